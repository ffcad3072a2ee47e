import type { Tree } from '../host/host'
import { same } from './tree'

/** Keys that say what an engine is; the others tell of it, or of how it is run. */
const ESSENCE = [
  'layout',
  'shaft',
  'cylinder',
  'cylinders',
  'cycle',
  'rotation',
  'firing_order',
  'firing_angles',
  'balance_factor',
  'crankshaft',
  'balance_shaft',
] as const

/**
 * The edited engine with a name that is true: one that goes by the name it was opened with, and is
 * another engine now, says that it was edited. `edited` writes the name: “V8, edited”.
 */
export function renamed(
  before: Tree,
  after: Tree,
  origins: ReadonlySet<unknown>,
  edited: (name: string) => string,
): Tree {
  const { name } = after
  if (typeof name !== 'string' || !origins.has(name) || name !== before.name) return after
  if (name.endsWith(edited(''))) return after
  const other = ESSENCE.some((key) => !same(before[key], after[key]))
  return other ? { ...after, name: edited(name) } : after
}
