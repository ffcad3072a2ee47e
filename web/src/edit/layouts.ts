import type { Tree } from '../host/host'
import { EXPLICIT } from './schema'
import { at } from './tree'

/** The numbers of an engine's cylinders in ascending order, wherever its layout names them. */
export function numbersOf(tree: Tree): number[] {
  const lists = [at(tree, ['layout', 'banks']), at(tree, ['layout', 'rows'])]
  const cranks = at(tree, ['layout', 'cranks'])
  for (const crank of Array.isArray(cranks) ? cranks : []) lists.push(at(crank, ['banks']))
  const named = lists
    .flatMap((list) => (Array.isArray(list) ? list : []))
    .flatMap((row: unknown) => at(row, ['cylinders']) ?? [])
  const throws = at(tree, ['layout', 'throws'])
  const count =
    named.length ||
    (Array.isArray(tree.firing_order) && tree.firing_order.length) ||
    (Array.isArray(throws) && throws.length)
  return Array.from({ length: Math.max(1, Number(count) || 4) }, (_, place) => place + 1)
}

const spaced = (count: number) =>
  Array.from(
    { length: count },
    (_, place) => `${Math.round((place * 3600000) / count) / 10000} deg`,
  )

/** Where a layout of another type begins: the same cylinders, their throws evenly spaced. */
const BEGINNINGS: Record<string, (numbers: number[], tree: Tree) => Tree> = {
  inline: (numbers) => ({ throws: spaced(numbers.length) }),
  vee: (numbers) => twoBanks(numbers, ['-45 deg', '45 deg']),
  boxer: (numbers) => twoBanks(numbers, ['-90 deg', '90 deg']),
  opposed: (numbers, tree) => ({
    throws: spaced(numbers.length),
    crank_distance: at(tree, ['cylinder', 'stroke']) ? '800 mm' : 12,
  }),
  radial: (numbers) => ({ rows: [{ cylinders: numbers, master: 1 }] }),
  tandem: (numbers, tree) => {
    const all = numbers.length < 2 ? [1, 2] : numbers
    const half = Math.ceil(all.length / 2)
    const crank = (name: string, cylinders: number[]) => ({
      name,
      banks: [{ cylinders }],
      throws: spaced(cylinders.length),
    })
    const right = at(tree, ['cylinder', 'stroke']) ? '150 mm' : 4
    return {
      cranks: [
        crank('front', all.slice(0, half)),
        { ...crank('rear', all.slice(half)), right, speed_ratio: -1 },
      ],
    }
  },
}

function twoBanks(numbers: number[], bearings: readonly [string, string]): Tree {
  const pairs = numbers.length % 2 ? [...numbers, numbers.length + 1] : numbers
  const banks = bearings.map((bearing, side) => ({
    bearing,
    cylinders: pairs.filter((_, place) => place % 2 === side),
  }))
  return { banks, throws: spaced(pairs.length / 2) }
}

/** The types of layout that one may change to. */
export const TYPES: readonly string[] = Object.keys(BEGINNINGS)

/** The engine with a layout of another type, without its firing order, which may not fit. */
export function withLayout(tree: Tree, type: string): Tree {
  const begin = BEGINNINGS[type]
  if (!begin || type === EXPLICIT) return tree
  const {
    firing_order: _order,
    firing_angles: _angles,
    provenance: _sources,
    cylinders: _one,
    shaft: _shaft,
    ...kept
  } = tree
  const pitch = at(tree, ['layout', 'bore_pitch'])
  const spread = pitch === undefined || type === 'radial' ? {} : { bore_pitch: pitch }
  return { ...kept, layout: { type, ...begin(numbersOf(tree), tree), ...spread } }
}
