import type {
  CatalogEntry,
  Exhibit,
  FittedShown,
  Preset,
  SearchShown,
  SlidersShown,
  TomlShown,
  TreeShown,
  WorkshopShown,
} from '../exhibit'
import { part, requested, required, sent } from './api'
import type { Service, Tree } from './host'

const post = <T>(path: string, body: unknown, signal?: AbortSignal) =>
  requested<T>(path, { body, signal })

const search = (id: string, method: 'GET' | 'DELETE') =>
  requested<SearchShown>(`search/${encodeURIComponent(id)}`, { method, polls: method === 'GET' })

/** Live editing by the API of `crankstar serve`. */
export const service: Service = {
  schema: () => required(requested<Tree>('schema')),
  catalog: () => required(requested<CatalogEntry[]>('catalog')),
  engine: (name) => requested<Tree>(`catalog/${encodeURIComponent(name)}`),
  exhibit: (tree, signal) => post<Exhibit>('exhibit', { engine: tree }, signal),
  workshop: (tree, cylinders, signal) =>
    post<WorkshopShown>('arrangements', { engine: tree, cylinders: cylinders ?? null }, signal),
  sliders: (tree, units, signal) =>
    post<SlidersShown>('sliders', { engine: tree, units: units || null }, signal),
  presets: () => required(requested<Preset[]>('presets')),
  toml: async (tree) => part(await post<TomlShown>('toml', { engine: tree }), (it) => it.toml),
  exported: ({ file, units }, form, degrees) =>
    sent('export', { engine: file, form, theta_deg: degrees, units: units.chosen }),
  explicit: async (tree) =>
    part(await post<TreeShown>('explicit', { engine: tree }), (it) => it.tree),
  read: async (text) => part(await post<TreeShown>('read', { text }), (it) => it.tree),
  fitted: async (tree, options) =>
    part(
      await post<FittedShown>('fitted', { engine: tree, ...options }),
      ({ exhibit }) => exhibit?.file ?? null,
    ),
  startSearch: (tree, options) =>
    post<SearchShown>('search', tree === null ? options : { engine: tree, ...options }),
  search: (id) => search(id, 'GET'),
  cancelSearch: (id) => search(id, 'DELETE'),
}
