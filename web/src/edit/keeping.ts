import type { Preset } from '../exhibit'
import type { Tree } from '../host/host'

/** What a small picture of an engine shows. */
export type Likeness = Pick<Preset, 'axes_deg' | 'throws_deg' | 'radial'>

/** An engine that is kept in the browser. */
export interface Kept {
  readonly id: string
  readonly name: string
  /** When it was kept, as ISO text. */
  readonly at: string
  readonly summary: string
  readonly likeness: Likeness
  readonly tree: Tree
}

/** Why the browser keeps nothing: its store is full, or it lets a page keep nothing. */
export type Trouble = 'full' | 'off'

/** A store like localStorage; a page from disk may have none. */
export type Store = Pick<Storage, 'getItem' | 'setItem' | 'removeItem'>

const ENGINES = 'crankstar.engines'
const LAST = 'crankstar.last'
export const MOST = 200

const isTable = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

const numbers = (value: unknown): number[] =>
  Array.isArray(value) ? value.filter((item) => Number.isFinite(item)).map(Number) : []

/** An engine read from a text that anything may have written; null where it is none. */
function keptOf(value: unknown, place: number): Kept | null {
  if (!isTable(value) || !isTable(value.tree)) return null
  const likeness = isTable(value.likeness) ? value.likeness : {}
  return {
    id: typeof value.id === 'string' && value.id ? value.id : `${Date.now()}-${place}`,
    name: String(value.name ?? value.tree.name ?? ''),
    at: typeof value.at === 'string' ? value.at : '',
    summary: typeof value.summary === 'string' ? value.summary : '',
    likeness: {
      axes_deg: numbers(likeness.axes_deg),
      throws_deg: numbers(likeness.throws_deg),
      radial: likeness.radial === true,
    },
    tree: value.tree,
  }
}

function listOf(text: string | null): Kept[] {
  try {
    const whole: unknown = JSON.parse(text ?? '[]')
    const list = isTable(whole) ? whole.engines : whole
    return Array.isArray(list) ? list.map(keptOf).filter((each) => each !== null) : []
  } catch {
    return []
  }
}

/** The engines that are kept, the newest first; none where the browser keeps nothing. */
export function keptIn(store: Store | null): Kept[] {
  try {
    return listOf(store?.getItem(ENGINES) ?? null)
  } catch {
    return []
  }
}

/** The engine that was edited last; null if there is none. */
export function lastIn(store: Store | null): Kept | null {
  try {
    const text = store?.getItem(LAST)
    return text ? keptOf(JSON.parse(text), 0) : null
  } catch {
    return null
  }
}

function put(store: Store | null, key: string, text: string): Trouble | null {
  if (!store) return 'off'
  try {
    store.setItem(key, text)
    return null
  } catch (reason) {
    const full = reason instanceof DOMException && /quota/i.test(reason.name)
    return full ? 'full' : 'off'
  }
}

/** Keeps a list of engines; says why where that fails. */
export function keep(store: Store | null, engines: readonly Kept[]): Trouble | null {
  return put(store, ENGINES, JSON.stringify(engines))
}

export function keepLast(store: Store | null, engine: Kept): Trouble | null {
  return put(store, LAST, JSON.stringify(engine))
}

/** The list with an engine before all others, at most MOST of them. */
export function withEngine(engines: readonly Kept[], engine: Kept): Kept[] {
  return [engine, ...engines.filter(({ id }) => id !== engine.id)].slice(0, MOST)
}

export function without(engines: readonly Kept[], id: string): Kept[] {
  return engines.filter((engine) => engine.id !== id)
}

/** The list with another name for an engine, in its file too. */
export function withName(engines: readonly Kept[], id: string, name: string): Kept[] {
  return engines.map((engine) =>
    engine.id === id ? { ...engine, name, tree: { ...engine.tree, name } } : engine,
  )
}

/** All engines as the text of one file. */
export function exported(engines: readonly Kept[]): string {
  return `${JSON.stringify({ format: 1, engines }, null, 1)}\n`
}

/** The engines of such a file; null where it is none. New ids, so that none replaces another. */
export function imported(text: string, stamp: number): Kept[] | null {
  let whole: unknown
  try {
    whole = JSON.parse(text)
  } catch {
    return null
  }
  if (!isTable(whole) || !Array.isArray(whole.engines)) return null
  return listOf(text).map((engine, place) => ({ ...engine, id: `${stamp}-${place}` }))
}
