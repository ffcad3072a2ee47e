import type { Exhibit, Row } from '../exhibit'
import { message, t } from '../language/messages'

type Quantity = Row['quantity']

const QUANTITY = {
  force: message('Force'),
  couple: message('Couple'),
  roll: message('Rolling moment'),
  torque: message('Inertia torque'),
} as const satisfies Record<Quantity, string>

/** A quantity as headings and choices name it. */
export const quantityName = (quantity: Quantity): string => t(QUANTITY[quantity])

/** The term of the glossary that each quantity is. */
export const TERMS: Readonly<Record<Quantity, string>> = {
  force: 'inertia force',
  couple: 'couple',
  roll: 'roll',
  torque: 'inertia torque',
}

/** The unit that a quantity of an engine is printed in. */
export const unitOf = ({ units }: Exhibit, quantity: Quantity): string =>
  quantity === 'torque' ? units.roll : units[quantity]
