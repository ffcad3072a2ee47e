import type { Tree } from '../host/host'
import { type Path, read, within } from './tree'

const keysOf = (path: Path): Path => path.filter((key) => typeof key === 'string')

/** The tree without the sources of values that changed at a path. */
export function withoutSources(tree: Tree, path: Path): Tree {
  const sources = tree.provenance
  if (path[0] === 'provenance' || typeof sources !== 'object' || sources === null) return tree
  const changed = keysOf(path)
  const kept = Object.entries(sources).filter(([about]) => {
    const place = keysOf(read(about))
    return place.length === 0 || !(within(changed, place) || within(place, changed))
  })
  if (kept.length === Object.keys(sources).length) return tree
  const { provenance: _, ...rest } = tree
  return kept.length ? { ...rest, provenance: Object.fromEntries(kept) } : rest
}
