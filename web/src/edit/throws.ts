import type { Exhibit } from '../exhibit'
import type { Tree } from '../host/host'
import { angle, degrees } from './quantity'
import { at, type Path, put } from './tree'

/** The tree, and where a throw is being turned, the weights of the throw turned as far. */
export function withWeightsAlong(
  tree: Tree,
  path: Path,
  value: unknown,
  stage: Pick<Exhibit, 'file' | 'weight_throws'>,
): Tree {
  const [shafts, shaft, throws, place, key] = path
  const turned = shafts === 'shaft' && throws === 'throw' && key === 'angle' && path.length === 5
  const [before, after] = [degrees(at(stage.file, path)), degrees(value)]
  if (!turned || before === null || after === null) return tree
  return (stage.weight_throws[Number(shaft)] ?? []).reduce((now, number, index) => {
    const own = ['shaft', shaft as number, 'weight', index, 'angle']
    const was = at(stage.file, own)
    const from = degrees(was)
    if (number !== Number(place) + 1 || from === null || at(now, own) === undefined) return now
    const to = from + after - before
    return put(now, own, angle(to - 360 * Math.ceil((to - 180) / 360), was))
  }, tree)
}
