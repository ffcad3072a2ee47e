import type { Exhibit, Exhibition, Problem } from '../exhibit'

/** A compiled Vega specification with one parameter, `theta`, in degrees. */
export type Spec = Record<string, unknown>

/** Where the page runs, and where it gets what an exhibit only names: a file and a notebook have it with them, a server is asked. */
export interface Host {
  readonly kind: 'page' | 'server' | 'widget'
  /** What the page opens with. */
  readonly exhibition: Exhibition
  /** A figure by its key. */
  chart(exhibit: Exhibit, key: string): Promise<Spec>
  /** A derivation by its key: HTML with MathML, made and escaped by our own typesetter. */
  derivation(exhibit: Exhibit, key: string): Promise<string>
  /** The same engine with weights and balance shafts; null where there is nothing to do. */
  fitted(exhibit: Exhibit): Promise<Exhibit | null>
  /** The state of the page as text: of the address for a page, of the model for a notebook. */
  readState(): string
  writeState(text: string): void
  /** Called when the state is changed from outside: the back button, another cell. Returns what ends it. */
  onState(changed: (text: string) => void): () => void
  /** What only a server can do; absent elsewhere. */
  readonly service?: Service
}

export interface CatalogEntry {
  name: string
  title: string
  layout: string
  cylinders: number
  cycle: string
}

export type Tree = Record<string, unknown>

/** An answer, or what is wrong with the question, mistake by mistake. */
export type Answer<T> = { ok: true; value: T } | { ok: false; problems: Problem[] }

/** A line of a search's answer; `tree` is the engine file it makes. */
export interface Found {
  cells: string[]
  tree: Tree
}

export interface SearchState {
  id: string
  state: 'running' | 'done' | 'cancelled' | 'failed'
  done: number
  blocks: number
  note: string
  heads: string[]
  rows: Found[]
  sentences: string[]
}

/** How an engine is fitted with weights and shafts; what is left out is done as its verdict advises. */
export interface Fitting {
  factor?: number
  weights?: 'pins' | 'webs' | 'ends'
  shafts?: 'none' | 'needed' | 'all'
}

/** Live editing: engine files as trees, exactly as in TOML. All of it may be aborted. */
export interface Service {
  schema(): Promise<Tree>
  catalog(): Promise<CatalogEntry[]>
  engine(name: string): Promise<Answer<Tree>>
  exhibit(tree: Tree, signal?: AbortSignal): Promise<Answer<Exhibit>>
  toml(tree: Tree): Promise<Answer<string>>
  /** The same engine in the explicit form, part by part. */
  explicit(tree: Tree): Promise<Answer<Tree>>
  /** An engine file that was dropped or opened, TOML or JSON. */
  read(text: string): Promise<Answer<Tree>>
  /** The engine file with counterweights and balance shafts; null where there is nothing to do. */
  fitted(tree: Tree, options: Fitting): Promise<Answer<Tree | null>>
  /** Of the in-line engine of a tree; without one, of `cylinders` and `cycle` in the wish. */
  startSearch(tree: Tree | null, wish: Record<string, unknown>): Promise<Answer<SearchState>>
  search(id: string): Promise<Answer<SearchState>>
  cancelSearch(id: string): Promise<Answer<SearchState>>
}
