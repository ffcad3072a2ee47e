import type { Dimension } from './quantity'
import { at, type Path } from './tree'

/** Values whose units show that an engine has masses, sizes and places. */
const SIGNS: Record<'mass' | 'length' | 'place', readonly Path[]> = {
  mass: [
    ['cylinder', 'reciprocating_mass'],
    ['cylinders', 0, 'reciprocating_mass'],
  ],
  length: [
    ['cylinder', 'stroke'],
    ['cylinders', 0, 'rod_length'],
  ],
  place: [
    ['layout', 'bore_pitch'],
    ['layout', 'row_pitch'],
    ['layout', 'positions', 1],
    ['bore_pitch'],
  ],
}

/** Whether a value of this dimension has a unit in this engine, else it is a bare number. */
export function measured(tree: unknown, path: Path, dimension: Dimension): boolean {
  if (dimension === 'angle' || dimension === 'speed') return true
  const given = (kind: keyof typeof SIGNS): boolean =>
    SIGNS[kind].some((sign) => typeof at(tree, sign) === 'string')
  if (dimension === 'other') return given('mass') && given('length')
  // The first of its kind decides for the others, so that it has the unit that the rest of the
  // engine lets expect.
  if (dimension === 'mass') return given('mass') || given('length')
  return dimension === 'place' && !String(path.at(-1)).endsWith('_pitch')
    ? given('place')
    : given('length')
}
