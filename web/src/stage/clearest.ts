import type { CylinderShown, Scene } from '../exhibit'
import { ISOMETRIC, type Look, upright } from './cameras'
import { along, boreEnd } from './extent'
import { dot, type Vector } from './vector'

/** Azimuths from the front to the right, radians: the isometric ones first, then those between. */
const AZIMUTHS = [45, -45, 30, -30, 60, -60, 20, -20].map((degrees) => (degrees * Math.PI) / 180)
/** A view that is not isometric must show at least this much more of the bores. */
const WORTH = 0.03
/** Points of a bore that are looked at, along it and across. */
const [ALONG, ACROSS] = [6, 3]

/** A bore on the screen: its two ends (right, up, nearness) and half its width. */
interface Strip {
  readonly from: Vector
  readonly to: Vector
  readonly half: number
}

/** The azimuth from which least of the bores is hidden behind others. */
export function clearestAzimuth(scene: Scene): number {
  const [first = Math.PI / 4, ...others] = AZIMUTHS
  let best = { azimuth: first, share: hiddenShare(scene, upright(first, ISOMETRIC)) }
  for (const azimuth of others) {
    const share = hiddenShare(scene, upright(azimuth, ISOMETRIC))
    const isometric = Math.abs(Math.abs(azimuth) - Math.PI / 4) < 1e-9
    if (share < best.share - (isometric ? 1e-9 : WORTH)) best = { azimuth, share }
  }
  return best.azimuth
}

/** The share of the bores that stands behind other bores from a look, from 0 to 1. */
export function hiddenShare(scene: Scene, look: Look): number {
  const strips = scene.cylinders.map((cylinder) => stripOf(scene, cylinder, look))
  let [seen, hidden] = [0, 0]
  for (const strip of strips)
    for (const point of pointsOf(strip)) {
      seen += 1
      if (strips.some((other) => other !== strip && covers(other, point))) hidden += 1
    }
  return seen > 0 ? hidden / seen : 0
}

function stripOf(scene: Scene, cylinder: CylinderShown, { right, up, back }: Look): Strip {
  const place = (distance: number): Vector => {
    const at = along(scene, cylinder, distance)
    return [dot(at, right), dot(at, up), dot(at, back)]
  }
  return {
    from: place(cylinder.bore_from),
    to: place(boreEnd(scene, cylinder)),
    half: cylinder.bore / 2,
  }
}

function* pointsOf({ from, to, half }: Strip): Generator<Vector> {
  const [x, y] = [to[0] - from[0], to[1] - from[1]]
  const long = Math.hypot(x, y) || 1
  for (let step = 0; step <= ALONG; step++)
    for (let side = 0; side < ACROSS; side++) {
      const share = step / ALONG
      const off = 0.8 * half * ((2 * side) / (ACROSS - 1) - 1)
      yield [
        from[0] + share * x - (off * y) / long,
        from[1] + share * y + (off * x) / long,
        from[2] + share * (to[2] - from[2]),
      ]
    }
}

/** Whether a bore lies before a point: on the screen over it, and nearer to the eye. */
function covers({ from, to, half }: Strip, [px, py, near]: Vector): boolean {
  const [x, y] = [to[0] - from[0], to[1] - from[1]]
  const square = x * x + y * y
  const share = square > 0 ? ((px - from[0]) * x + (py - from[1]) * y) / square : 0
  const inside = Math.min(1, Math.max(0, share))
  const off = Math.hypot(px - from[0] - inside * x, py - from[1] - inside * y)
  return off < half && from[2] + inside * (to[2] - from[2]) > near + half
}
