import type { Exhibit, Fact, Row } from '../exhibit'
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

/** Subjects of the verdict that say how the engine shakes, and what would cure it. */
export const SHAKES: readonly string[] = ['force', 'couple', 'roll', 'cure']

/** The verdict by what it is about: first what remains and what would cure it. */
export function judged({ verdict }: Exhibit): readonly (readonly [string, readonly Fact[]])[] {
  const isFirst = ({ subject }: Fact): boolean => SHAKES.includes(subject)
  const facts = [...verdict.filter(isFirst), ...verdict.filter((fact) => !isFirst(fact))]
  const subjects = [...new Set(facts.map(({ about }) => about))]
  return subjects.map((subject) => [subject, facts.filter(({ about }) => about === subject)])
}

/** The term of the glossary that each quantity is. */
export const TERMS: Readonly<Record<Quantity, string>> = {
  force: 'inertia force',
  couple: 'couple',
  roll: 'roll',
  torque: 'inertia torque',
}

/** What a number of a quantity, as it is sent, is multiplied with to be in the printed unit. */
export const factorOf = ({ units }: Exhibit, quantity: Quantity): number =>
  quantity === 'force'
    ? units.force_factor
    : quantity === 'couple'
      ? units.couple_factor
      : units.roll_factor

/** The unit that a quantity of an engine is printed in. */
export const unitOf = ({ units }: Exhibit, quantity: Quantity): string =>
  quantity === 'torque' ? units.roll : units[quantity]
