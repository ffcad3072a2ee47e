import type { Tree } from '../host/host'
import { textOf } from './quantity'
import { type Path, same, written } from './tree'

/** A key that two engine files hold otherwise. */
export interface Change {
  readonly path: string
  readonly from: string
  readonly to: string
}

const LONGEST = 40

const short = (value: unknown): string => {
  const text = typeof value === 'object' && !Array.isArray(value) ? '…' : textOf(value)
  return text.length > LONGEST ? `${text.slice(0, LONGEST - 1)}…` : text
}

/** What differs between two engine files, key by key; sources, which follow, left out. */
export function changes(before: Tree, after: Tree): Change[] {
  const found: Change[] = []
  const compare = (one: unknown, other: unknown, path: Path): void => {
    if (same(one, other)) return
    if (isTable(one) && isTable(other)) {
      for (const key of new Set([...Object.keys(one), ...Object.keys(other)]))
        compare(one[key], other[key], [...path, key])
    } else if (isListOfTables(one) && isListOfTables(other) && one.length === other.length)
      for (const [index, item] of one.entries()) compare(item, other[index], [...path, index])
    else found.push({ path: written(path), from: short(one), to: short(other) })
  }
  const { provenance: _one, ...first } = before
  const { provenance: _other, ...second } = after
  compare(first, second, [])
  return found
}

const isTable = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

const isListOfTables = (value: unknown): value is Record<string, unknown>[] =>
  Array.isArray(value) && value.every(isTable)
