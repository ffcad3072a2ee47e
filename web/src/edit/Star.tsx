import { useSignal } from '@preact/signals'
import { useRef } from 'preact/hooks'
import type { Pin } from '../exhibit'
import { t } from '../language/messages'
import { useSession } from './context'
import { angleIn, snappedAngle, throwSnaps, turnedPin } from './control'
import { wrapped } from './quantity'

/** Degrees within which a drag comes to rest at an angle that makes sense. */
const REACH = 4
const [INNER, OUTER] = [34, 62]
const TICKS = Array.from({ length: 12 }, (_, place) => 30 * place)
const STEPS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 15,
  PageDown: -15,
}

/** The crank star: drag a throw, or turn it with the arrow keys (shift: tenths, page: 15°). */
export function Star({ pins }: { pins: readonly Pin[] }) {
  const session = useSession()
  const svg = useRef<SVGSVGElement>(null)
  // no state: what is held must be known to the events that come before the next drawing
  const held = useSignal<string | null>(null)
  const first = pins[0]
  if (!first) return null
  const tree = session.tree.value
  // the first pin stays where the first cylinder wants it; the file counts the others from it
  const base = first.bearing_deg - first.angle_deg
  const explicit = !pins.some(({ fixed }) => fixed)
  const at = (pin: Pin): number => (explicit ? 0 : base) + angleIn(tree, pin)
  const snaps = throwSnaps(pins.length)
  const turn = (pin: Pin, angle: number): void =>
    session.direct(turnedPin(session.tree.peek(), pins, pin, angle), pin.path)

  const follow = (pin: Pin, event: PointerEvent): void => {
    const box = svg.current?.getBoundingClientRect()
    if (!box) return
    const right = event.clientX - box.left - box.width / 2
    const up = box.top + box.height / 2 - event.clientY
    if (Math.hypot(up, right) < 6) return
    const seen = (Math.atan2(right, up) * 180) / Math.PI - (explicit ? 0 : base)
    if (event.shiftKey) turn(pin, wrapped(Math.round(seen * 10) / 10, 0.1))
    else if (event.altKey) turn(pin, wrapped(Math.round(seen), 1))
    else turn(pin, snappedAngle(Math.round(seen), snaps, REACH))
  }
  const leave = (): void => {
    held.value = null
    session.rest()
  }
  const turning = pins.find(({ path }) => path === held.value)
  return (
    <figure class="star" aria-label={t('Crank star')}>
      <svg ref={svg} viewBox="-80 -80 160 160">
        <title>{t('Crank star')}</title>
        <circle class="rim" r="74" />
        {TICKS.map((angle) => (
          <path key={angle} class="tick" d="M0 -74V-71" transform={`rotate(${angle + base})`} />
        ))}
        {pins.map((pin, place) => {
          const angle = angleIn(tree, pin)
          const radius = radiusOf(place, pins.length)
          return (
            <g
              key={pin.path}
              class={pin.fixed ? 'pin fixed' : 'pin'}
              data-path={pin.path}
              transform={`rotate(${at(pin)})`}
              {...(!pin.fixed && {
                role: 'slider',
                tabIndex: 0,
                'aria-label': t('Crank pin {pin}', { pin: pin.label }),
                'aria-valuemin': -180,
                'aria-valuemax': 180,
                'aria-valuenow': Math.round(wrapped(angle, 1e-3) * 1000) / 1000,
                'aria-valuetext': t('{degrees} degrees from pin 1', {
                  degrees: Math.round(wrapped(angle, 1e-3) * 1000) / 1000,
                }),
                onPointerDown: (event: PointerEvent) => {
                  ;(event.currentTarget as Element).setPointerCapture(event.pointerId)
                  held.value = pin.path
                },
                onPointerMove: (event: PointerEvent) =>
                  held.peek() === pin.path && follow(pin, event),
                onPointerUp: leave,
                onPointerCancel: leave,
                onBlur: session.rest,
                onKeyDown: (event: KeyboardEvent) => {
                  const step = STEPS[event.key]
                  if (step === undefined) return
                  event.preventDefault()
                  const size = event.shiftKey && Math.abs(step) === 1 ? step / 10 : step
                  turn(pin, wrapped(angleIn(session.tree.peek(), pin) + size, 0.001))
                },
              })}
            >
              <path class="arm" d={`M0 0V${-radius}`} />
              <circle class="grip" cy={-radius} r="14" />
              <circle class="knob" cy={-radius} r="9" />
              <text y={-radius} transform={`rotate(${-at(pin)} 0 ${-radius})`} dy="0.36em">
                {pin.label}
              </text>
            </g>
          )
        })}
        <circle class="axis" r="3" />
      </svg>
      <figcaption>
        {turning
          ? t('Pin {pin}: {degrees}°', {
              pin: turning.label,
              degrees: Math.round(wrapped(angleIn(tree, turning), 1e-3) * 100) / 100,
            })
          : explicit
            ? t('Seen from the front. Drag a pin.')
            : t('Seen from the front, counted from pin 1. Drag a pin.')}
      </figcaption>
    </figure>
  )
}

/** How far a pin is drawn from the middle, so that pins at one angle do not hide each other. */
function radiusOf(place: number, count: number): number {
  if (count < 2) return OUTER
  return OUTER - ((OUTER - INNER) * place) / (count - 1)
}
