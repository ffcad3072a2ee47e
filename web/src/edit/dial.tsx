import { useRef } from 'preact/hooks'
import { t } from '../language/messages'
import { wrapped } from './quantity'

const STEPS: Record<string, number> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 15,
  PageDown: -15,
}

/** Degrees from which on, or if it is no number at all, an angle that was typed is not drawn. */
const ABSURD = 1e6

interface Props {
  /** Degrees, clockwise from up; null where there is no angle to show. */
  readonly degrees: number | null
  readonly label: string
  /** Called while it is turned. */
  readonly turned: (degrees: number) => void
  /** Called when a turn is over. */
  readonly rested: () => void
}

/** A wheel for a bearing: drag or arrow keys, 1 deg; with shift or page keys 15, with alt 0.1. */
export function Dial({ degrees, label, turned, rested }: Props) {
  const held = useRef(false)
  const shown = degrees !== null && Math.abs(degrees) < ABSURD
  const at = shown ? degrees : 0

  const leave = () => {
    held.current = false
    rested()
  }
  const follow = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect()
    const right = event.clientX - box.left - box.width / 2
    const up = box.top + box.height / 2 - event.clientY
    if (Math.hypot(up, right) < 3) return
    const step = event.shiftKey ? 15 : event.altKey ? 0.1 : 1
    turned(wrapped((Math.atan2(right, up) * 180) / Math.PI, step))
  }

  return (
    <span
      class="dial"
      role="slider"
      tabIndex={0}
      aria-label={label}
      aria-valuemin={-180}
      aria-valuemax={180}
      aria-valuenow={Math.round(wrapped(at, 0.001) * 1000) / 1000}
      aria-valuetext={
        shown
          ? t('{degrees} degrees clockwise from up', { degrees: Math.round(at * 1000) / 1000 })
          : t('no angle')
      }
      onPointerDown={(event) => {
        held.current = true
        event.currentTarget.setPointerCapture(event.pointerId)
        follow(event)
      }}
      onPointerMove={(event) => held.current && follow(event)}
      onPointerUp={leave}
      onPointerCancel={leave}
      onKeyDown={(event) => {
        const step = STEPS[event.key]
        if (step === undefined) return
        event.preventDefault()
        turned(wrapped(at + (event.shiftKey && Math.abs(step) === 1 ? 15 * step : step), 0.001))
      }}
      onBlur={rested}
    >
      <svg viewBox="-20 -20 40 40" aria-hidden="true">
        <circle class="rim" r="17" />
        <path class="mark" d="M0 -17V-13" />
        {shown && (
          <g transform={`rotate(${at})`}>
            <path class="arm" d="M0 0V-11" />
            <circle class="pin" cy="-12" r="4" />
          </g>
        )}
      </svg>
    </span>
  )
}
