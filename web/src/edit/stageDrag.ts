import type { Control, Exhibit } from '../exhibit'
import type { PaneRead } from '../stage/stage'
import { placeAt, SIDES, type Spot, seen } from '../ui/layoutView'
import { moved, snapped, valueIn } from './control'
import { KEYS, mountsIn, placedAt, placeIn } from './mounts'
import { parsed, rewritten } from './quantity'
import type { Session } from './session'
import { at, type Path, put } from './tree'

/** Degrees about a cylinder axis in which a press takes hold of its bank; pixels about a weight. */
const [BESIDE, NEAR] = [14, 12]
/** Degrees within which a dragged bank comes to rest at an angle that makes sense. */
const REST = 3

/** What is dragged on the stage: sets it to where the pointer is, and says what it is then. */
export interface Handle {
  follow(x: number, y: number, fine: boolean): string
}

/** What a press takes hold of. */
export interface Grip {
  readonly panes: readonly PaneRead[]
  readonly scene: Exhibit['scene']
  readonly controls: readonly Control[]
  readonly session: Session
}

const paneAt = (panes: readonly PaneRead[], x: number, y: number): PaneRead | undefined =>
  panes.find(
    (pane) => x >= pane.x && x <= pane.x + pane.width && y >= pane.y && y <= pane.y + pane.height,
  )

const turned = (from: number, to: number): number => ((((to - from + 180) % 360) + 360) % 360) - 180

/** The handle at a place of the stage, pixels; null where there is none. */
export function handleAt(grip: Grip, x: number, y: number): Handle | null {
  const pane = paneAt(grip.panes, x, y)
  const mount = pane && mountAt(grip, pane, x, y)
  if (mount) return mount
  if (pane?.camera === 'front') return bankAt(grip, pane, x, y)
  if (pane?.camera === 'side') return weightAt(grip, pane, x, y)
  return null
}

/** A mount of a file, on a view that is square to the axes of the engine. */
function mountAt({ scene, session }: Grip, pane: PaneRead, x: number, y: number): Handle | null {
  const side = SIDES.find((each) => each === pane.camera)
  if (!side || scene.length_unit !== 'm') return null
  const [left, top] = pane.origin
  const spot = (across: number, down: number): Spot => [
    (across - left) / pane.scale,
    (down - top) / pane.scale,
  ]
  const pressed = spot(x, y)
  const found = mountsIn(session.tree.peek()).flatMap(({ index, name, place }) => {
    if (!place) return []
    const at = seen(side, place)
    const off: Spot = [pressed[0] - at[0], pressed[1] - at[1]]
    return [{ index, name, place, off, away: Math.hypot(...off) * pane.scale }]
  })
  const nearest = found.sort((one, other) => one.away - other.away)[0]
  if (!nearest || nearest.away > NEAR) return null
  const { index, name, off } = nearest
  const path: Path = ['mounts', index]
  return {
    follow(toX, toY, fine) {
      const now = placeIn(session.tree.peek(), path) ?? nearest.place
      const [across, down] = spot(toX, toY)
      const to = placeAt(side, [across - off[0], down - off[1]], now)
      const next = placedAt(session.tree.peek(), path, now, to, fine ? 0.001 : 0.005)
      session.direct(next, `${path.join('.')} place`)
      const told = KEYS.map((key) => `${key} ${String(at(next, [...path, key]) ?? 0)}`)
      return `${name}: ${told.join(', ')}`
    },
  }
}

const bearingOf = ({ origin }: PaneRead, x: number, y: number): number =>
  (Math.atan2(x - origin[0], origin[1] - y) * 180) / Math.PI

/** One of the two banks of a V engine, seen from the front. */
function bankAt(
  { scene, controls, session }: Grip,
  pane: PaneRead,
  x: number,
  y: number,
): Handle | null {
  const control = controls.find(({ key }) => key === 'layout.bank_angle')
  const first = scene.cylinders[0]
  if (!control || !first) return null
  const away = Math.hypot(x - pane.origin[0], y - pane.origin[1]) / pane.scale
  if (away < 1.3 * first.crank_radius || away > 1.15 * first.bore_to) return null
  const middle = control.sets[0]?.added ?? 0
  const pressed = turned(middle, bearingOf(pane, x, y))
  const half = valueIn(session.tree.peek(), control) / 2
  const beside = Math.abs(pressed) - half
  if (Math.abs(beside) > BESIDE) return null
  return {
    follow(toX, toY, fine) {
      const angle = 2 * Math.max(0, Math.abs(turned(middle, bearingOf(pane, toX, toY))) - beside)
      const whole = fine ? Math.round(10 * angle) / 10 : Math.round(angle)
      const to = Math.min(180, fine ? whole : snapped(whole, control.snaps, REST))
      session.direct(moved(session.tree.peek(), control, to), control.key)
      return `${control.label}: ${to}°`
    },
  }
}

/** A weight of a file that says where it stands along the shaft, seen from the side. */
function weightAt({ scene, session }: Grip, pane: PaneRead, x: number, y: number): Handle | null {
  const tree = session.tree.peek()
  const found = scene.shafts.flatMap((shaft, place) =>
    shaft.weights.flatMap((weight, index) => {
      const path = pathOf(tree, place, index, shaft.weights.length)
      const across = pane.origin[0] - weight.z * pane.scale
      const down = pane.origin[1] - shaft.up * pane.scale
      const within = Math.abs(y - down) < weight.outer_radius * pane.scale
      const off = Math.abs(x - across)
      return path && within && off < NEAR ? [{ path, weight, off }] : []
    }),
  )
  const nearest = found.sort((one, other) => one.off - other.off)[0]
  if (!nearest) return null
  const { path, weight } = nearest
  const was = at(tree, path)
  return {
    follow(toX, _toY, fine) {
      const along = weight.z + (x - toX) / pane.scale
      const to = zOf(along, weight.z, was, scene.length_unit === 'm', fine)
      session.direct(put(session.tree.peek(), path, to), path.join('.'))
      return `z: ${String(to)}`
    },
  }
}

/** The place along the shaft in the unit of the file, rounded to what can be meant. */
function zOf(along: number, from: number, was: unknown, metres: boolean, fine: boolean): unknown {
  const given = parsed(was)
  // how much of the file's unit the drawing's is, as the weight itself tells
  const unit =
    given && given.number !== 0 && from !== 0
      ? given.number / from
      : metres && given?.unit === 'mm'
        ? 1000
        : 1
  const number = along * unit
  const step = fine ? Math.abs(unit) / 10000 : Math.abs(unit) / 1000
  return rewritten(Math.round(number / step) * step, was, '')
}

/** Where the file says how far along the shaft a weight stands; null where it does not. */
function pathOf(tree: unknown, shaft: number, index: number, count: number): Path | null {
  const cranks = at(tree, ['layout', 'cranks'])
  const crankshafts = Array.isArray(cranks) ? cranks.length : 1
  const table: Path = Array.isArray(at(tree, ['shaft']))
    ? ['shaft', shaft]
    : shaft < crankshafts
      ? ['crankshaft', shaft]
      : ['balance_shaft', shaft - crankshafts]
  const weights = at(tree, [...table, 'weight'])
  // with a balance factor there are more weights than the file lists
  if (!Array.isArray(weights) || weights.length !== count) return null
  const path: Path = [...table, 'weight', index, 'z']
  return at(tree, path) === undefined ? null : path
}
