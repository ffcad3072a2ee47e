import type {
  CatalogEntry,
  Exhibit,
  Exhibition,
  FittedQuestion,
  Preset,
  Problem,
  SearchQuestion,
  SearchShown,
  SlidersShown,
  WorkshopShown,
} from '../exhibit'
import type { Draw } from './drawing'
import type { News } from './watching'

/** A figure as Vega-Lite; where it turns it has one parameter, `theta`, in degrees. */
export type Spec = Record<string, unknown>

/** Where the page runs, and its source of figures, derivations and fitted engines. */
export interface Host {
  readonly kind: 'page' | 'server' | 'widget'
  /** What the page opens with. */
  readonly exhibition: Exhibition
  /** A figure by its key, to one scale with that of the engine beside it, where it can be. */
  chart(exhibit: Exhibit, key: string, beside?: Exhibit): Promise<Spec>
  /** What draws figures: read when the first is wanted, and kept. */
  drawing(): Promise<Draw>
  /** A derivation by its key: HTML with MathML, made and escaped by our own typesetter. */
  derivation(exhibit: Exhibit, key: string): Promise<string>
  /** The same engine in other units, by their name; of a fitted one, ask for that anew. */
  inUnits(exhibit: Exhibit, units: string): Promise<Exhibit>
  /** Whether any units can be asked for, not only those that are offered by name. */
  readonly anyUnits: boolean
  /** Puts the engine with estimated masses on the page; absent where that cannot be done. */
  estimate?(exhibit: Exhibit): Promise<Tree | null>
  /** The same engine with weights and balance shafts; null where there is nothing to do. */
  fitted(exhibit: Exhibit): Promise<Exhibit | null>
  /** Language that the host asks for, as in `ja`; empty for none. */
  readonly language: string
  /** Language in which a file was written, verdict and figures in it; absent where one can ask. */
  readonly written?: string
  /** The state of the page as text: of the address for a page, of the model for a notebook. */
  readState(): string
  /** `visit`: it is worth an entry that Back leads to, where the host has such. */
  writeState(text: string, visit?: boolean): void
  /** Calls back when the state changes from outside. Returns what ends it. */
  onState(changed: (text: string) => void): () => void
  /** Calls back when the file is saved that the server watches; absent elsewhere. */
  watched?(changed: (news: News) => void): () => void
  /** What only a server can do; absent elsewhere. */
  readonly service?: Service
}

/** Files that only Python writes. */
export type ExportForm = 'glb' | 'stl' | 'py' | 'csv' | 'xlsx' | 'report' | 'page'

export type Tree = Record<string, unknown>

/** An answer, or all faults of the request. */
export type Answer<T> = { ok: true; value: T } | { ok: false; problems: Problem[] }

/** How an engine is fitted with weights and shafts; by default as its verdict recommends. */
export type Fitting = Omit<FittedQuestion, 'engine'>

/** Options of a search as they were typed; the server checks their values. */
export type SearchOptions = Partial<Record<Exclude<keyof SearchQuestion, 'engine'>, unknown>>

/** Live editing: engine files as trees, exactly as in TOML. All of it may be aborted. */
export interface Service {
  schema(): Promise<Tree>
  catalog(): Promise<CatalogEntry[]>
  engine(name: string): Promise<Answer<Tree>>
  exhibit(tree: Tree, signal?: AbortSignal): Promise<Answer<Exhibit>>
  /** What can be changed in an engine, with another number of cylinders if one is given. */
  workshop(tree: Tree, cylinders?: number, signal?: AbortSignal): Promise<Answer<WorkshopShown>>
  /** The curves behind the sliders of an engine, in units as --units takes them. */
  sliders(tree: Tree, units: string, signal?: AbortSignal): Promise<Answer<SlidersShown>>
  /** Usual layouts to begin with. */
  presets(): Promise<Preset[]>
  toml(tree: Tree): Promise<Answer<string>>
  /** An engine as a file, solids at a crank angle; rejects with the sentences of its faults. */
  exported(exhibit: Exhibit, form: ExportForm, degrees: number): Promise<Blob>
  /** The same engine in the explicit form, part by part. */
  explicit(tree: Tree): Promise<Answer<Tree>>
  /** An engine file that was dropped or opened, TOML or JSON. */
  read(text: string): Promise<Answer<Tree>>
  /** The engine file with counterweights and balance shafts; null where there is nothing to do. */
  fitted(tree: Tree, options: Fitting): Promise<Answer<Tree | null>>
  /** Of the in-line engine of a tree; without one, of `cylinders` and `cycle` in the options. */
  startSearch(tree: Tree | null, options: SearchOptions): Promise<Answer<SearchShown>>
  search(id: string): Promise<Answer<SearchShown>>
  cancelSearch(id: string): Promise<Answer<SearchShown>>
}
