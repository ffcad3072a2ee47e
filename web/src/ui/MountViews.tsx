import type { ComponentChildren } from 'preact'
import type { Exhibit, MountAxis, Mounts, Scene } from '../exhibit'
import { message, t } from '../language/messages'
import {
  type Frame,
  frameOf,
  outlinesOf,
  type Place,
  type Side,
  seen,
  shaftOf,
  within,
} from './layoutView'

export const NAMES = {
  front: message('Front'),
  side: message('Side, from the right'),
  plan: message('Plan'),
} as const satisfies Record<Side, string>

/** Units of a drawing to its breadth: letters and marks have their sizes in them. */
export const UNITS = 300

interface GroundProps {
  readonly side: Side
  readonly scene: Scene
  readonly frame: Frame
  readonly label: string
  readonly children: ComponentChildren
}

/** The engine as an outline, with what is drawn over it in metres times `scaleOf`. */
export function Ground({ side, scene, frame, label, children }: GroundProps) {
  const scale = scaleOf(frame)
  const path = (spots: readonly (readonly [number, number])[]) =>
    `M${spots.map(([x, y]) => `${(x * scale).toFixed(2)} ${(y * scale).toFixed(2)}`).join('L')}`
  const box = [frame.x, frame.y, frame.width, frame.height].map((each) => (each * scale).toFixed(2))
  return (
    <figure class={`mount-view of-${side}`} aria-label={label}>
      <svg viewBox={box.join(' ')}>
        <title>{label}</title>
        {outlinesOf(side, scene).map((spots, index) => (
          <path key={index} class="engine-outline" d={`${path(spots)}Z`} />
        ))}
        <path class="crank-axis" d={path(shaftOf(side, scene))} />
        {side === 'front' && (
          <circle
            class="crank-axis"
            cx={(shaftOf(side, scene)[0][0] * scale).toFixed(2)}
            cy={(shaftOf(side, scene)[0][1] * scale).toFixed(2)}
            r="4"
          />
        )}
        {children}
      </svg>
      <figcaption>{t(NAMES[side])}</figcaption>
    </figure>
  )
}

/** Units of the drawing to a metre. */
export const scaleOf = ({ width }: Frame): number => UNITS / width

/** The centre of mass: a circle in quarters. */
export function Centre({ at: [x, y] }: { at: readonly [number, number] }) {
  return (
    <g class="mass-centre" transform={`translate(${x.toFixed(2)} ${y.toFixed(2)})`}>
      <circle r="6" />
      <path d="M0 0V-6A6 6 0 0 1 6 0ZM0 0V6A6 6 0 0 1 -6 0Z" />
    </g>
  )
}

/** The layout of the mounts with the two axes, seen from the front, from the side and from above. */
export function MountViews({ exhibit, mounts }: { exhibit: Exhibit; mounts: Mounts }) {
  const { scene } = exhibit
  const places: Place[] = [...mounts.mounts.map(({ place }) => place), ...mounts.centres]
  const lines = [
    { key: 'roll-axis', label: t('torque-roll axis'), axis: mounts.torque_roll },
    { key: 'elastic-axis', label: t('elastic axis'), axis: mounts.elastic },
  ]
  return (
    <div class="mount-views">
      {(['front', 'side', 'plan'] as const).map((side) => {
        const frame = frameOf(side, scene, places)
        const scale = scaleOf(frame)
        const spot = (place: Place) => seen(side, place).map((each) => each * scale) as Pair
        return (
          <Ground
            key={side}
            side={side}
            scene={scene}
            frame={frame}
            label={t('Mounts and axes: {view}', { view: t(NAMES[side]) })}
          >
            {lines.map(({ key, axis }) => (
              <path key={key} class={key} d={lineOf(axis, side, frame)} />
            ))}
            {marksOf(mounts, spot).map(({ at, names, below }) => (
              <Mark
                key={names.join()}
                at={at}
                name={names.join(' · ')}
                below={below}
                frame={frame}
              />
            ))}
            {mounts.centres.map((centre, index) => (
              <Centre key={index} at={spot(centre)} />
            ))}
          </Ground>
        )
      })}
      <ul class="legend">
        {lines.map(({ key, label }) => (
          <li key={key}>
            <svg class="line-sample" viewBox="0 0 28 8" aria-hidden="true">
              <path class={key} d="M0 4H28" />
            </svg>{' '}
            {label}
          </li>
        ))}
        <li>
          <svg class="line-sample" viewBox="-8 -8 16 16" aria-hidden="true">
            <Centre at={[0, 0]} />
          </svg>{' '}
          {t('centre of mass')}
        </li>
      </ul>
    </div>
  )
}

export type Pair = [number, number]

/** The mounts on a view, those that stand behind each other as one. */
function marksOf({ mounts }: Mounts, spot: (place: Place) => Pair) {
  const marks: { at: Pair; names: string[]; below: boolean }[] = []
  for (const { name, place, below } of mounts) {
    const at = spot(place)
    const near = marks.find(
      (mark) => mark.below === below && Math.hypot(mark.at[0] - at[0], mark.at[1] - at[1]) < CLOSE,
    )
    if (near) near.names.push(name)
    else marks.push({ at, names: [name], below })
  }
  return marks
}

/** Units of a drawing within which marks are one. */
const CLOSE = 16

interface MarkProps {
  readonly at: Pair
  readonly name: string
  readonly below: boolean
  readonly frame: Frame
}

/** A mount by a square and its name. */
function Mark({ at, name, below, frame }: MarkProps) {
  const [x, y] = at
  return (
    <g
      class={below ? 'mount-mark below' : 'mount-mark'}
      transform={`translate(${x.toFixed(2)} ${y.toFixed(2)})`}
    >
      <rect x="-6" y="-6" width="12" height="12" rx="2" />
      <NameBelow name={name} at={at} frame={frame} />
    </g>
  )
}

/** A line through a frame, as a path; one that points at the eye is a cross. */
function lineOf({ point, direction }: MountAxis, side: Side, frame: Frame): string {
  const reach = 2 * Math.max(frame.width, frame.height) + Math.hypot(...point)
  const scale = scaleOf(frame)
  const end = (way: number) =>
    seen(side, [
      point[0] + way * reach * direction[0],
      point[1] + way * reach * direction[1],
      point[2] + way * reach * direction[2],
    ])
  const text = (spot: readonly number[]) => spot.map((each) => (each * scale).toFixed(2)).join(' ')
  const [from, to] = [end(1), end(-1)]
  if (Math.hypot(from[0] - to[0], from[1] - to[1]) * scale < 12) {
    const [x = 0, y = 0] = seen(side, point).map((each) => each * scale)
    return `M${x - 7} ${y}H${x + 7}M${x} ${y - 7}V${y + 7}`
  }
  const cut = within(frame, from, to)
  return cut ? `M${text(cut[0])}L${text(cut[1])}` : ''
}

/** Units of a letter on an average, and how many a name has at most. */
const [LETTER, LONGEST] = [6.6, 20]

/** A name below a mark, as much of it as there is room for, within its drawing. */
export function NameBelow({ name, at: [x], frame }: { name: string; at: Pair; frame: Frame }) {
  const text = name.length > LONGEST ? `${name.slice(0, LONGEST - 1)}…` : name
  const scale = scaleOf(frame)
  const half = (LETTER * text.length) / 2 + 2
  const [left, right] = [frame.x * scale + half, (frame.x + frame.width) * scale - half]
  return (
    <text x={(Math.max(left, Math.min(right, x)) - x).toFixed(2)} y="19">
      {text}
    </text>
  )
}
