/** A place in an engine file: keys of tables, indices of lists from 0. */
export type Path = readonly (string | number)[]

type Json = unknown

/** What stands at a path; undefined where there is nothing. */
export function at(tree: Json, path: Path): Json {
  let here = tree
  for (const key of path) {
    if (typeof here !== 'object' || here === null) return undefined
    here = (here as Record<string | number, Json>)[key]
  }
  return here
}

/** The tree with a value at a path, with tables on the way; undefined removes. */
export function put<T>(tree: T, path: Path, value: Json): T {
  const [key, ...rest] = path
  if (key === undefined) return value as T
  const inner = rest.length
    ? put(at(tree, [key]) ?? (typeof rest[0] === 'number' ? [] : {}), rest, value)
    : value
  if (Array.isArray(tree)) {
    const index = Number(key)
    return (inner === undefined ? tree.toSpliced(index, 1) : tree.toSpliced(index, 1, inner)) as T
  }
  const { [key]: _, ...others } = (tree ?? {}) as Record<string, Json>
  if (inner === undefined) return others as T
  return (
    key in ((tree ?? {}) as object)
      ? { ...(tree as object), [key]: inner }
      : { ...others, [key]: inner }
  ) as T
}

/** The tree with an item of a list moved; unchanged where the place is outside. */
export function moved<T>(tree: T, list: Path, from: number, to: number): T {
  const items = at(tree, list)
  if (!Array.isArray(items) || to < 0 || to >= items.length) return tree
  const taken = items.toSpliced(from, 1)
  return put(tree, list, taken.toSpliced(to, 0, items[from]))
}

/** Whether two trees are equal up to the order of their keys. */
export function same(one: Json, other: Json): boolean {
  if (Object.is(one, other)) return true
  if (typeof one !== 'object' || typeof other !== 'object' || one === null || other === null)
    return false
  if (Array.isArray(one) !== Array.isArray(other)) return false
  const keys = Object.keys(one)
  return (
    keys.length === Object.keys(other).length &&
    keys.every(
      (key) =>
        key in other &&
        same((one as Record<string, Json>)[key], (other as Record<string, Json>)[key]),
    )
  )
}

/** A path as text: `layout.banks[2].bearing`, indices from 1. */
export function written(path: Path): string {
  let text = ''
  for (const key of path) {
    if (typeof key === 'number') text += `[${key + 1}]`
    else text += (text ? '.' : '') + (/^[A-Za-z0-9_-]+$/.test(key) ? key : JSON.stringify(key))
  }
  return text
}

/** A written path as keys and indices; the empty path where it names no place. */
export function read(text: string): Path {
  const path: (string | number)[] = []
  const part = /\.?(?:\[(\d+)\]|"((?:[^"\\]|\\.)*)"|([A-Za-z0-9_-]+))/y
  while (part.lastIndex < text.length) {
    const match = part.exec(text)
    if (!match) return []
    if (match[1] !== undefined) path.push(Number(match[1]) - 1)
    else path.push(match[2] ?? match[3] ?? '')
  }
  return path
}

/** Whether a path is the other one or lies below it. */
export function within(path: Path, outer: Path): boolean {
  return outer.length <= path.length && outer.every((key, place) => path[place] === key)
}
