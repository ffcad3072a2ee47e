import { useId, useRef, useState } from 'preact/hooks'
import type { Control, Slider } from '../exhibit'
import { t } from '../language/messages'
import { typeset } from '../language/typeset'
import { Curves } from './Curves'
import { useSession } from './context'
import { moved, snapped, valueIn } from './control'
import { parsed, type Quantity } from './quantity'
import { put, read, same } from './tree'

/** How near to a value that makes sense a drag comes to rest, as a share of the range. */
const REACH = 0.012
/** Share of a range by which a value that was read back may differ and be the same. */
const SAME = 1e-9
/** Steps in a fine one. */
const FINE = 10

/** A number with at most five digits, and its unit. */
export function numberText(value: number, unit: string): string {
  const text = String(Number(value.toPrecision(5)))
  return unit === 'deg' ? `${text}°` : unit ? `${text} ${unit}` : text
}

interface Props {
  readonly control: Control
  /** Its curves, where it has any. */
  readonly slider: Slider | undefined
  /** Whether the curves are those of the engine as it is. */
  readonly present: boolean
}

/** A number to type, and where it is swept a slider with the curves behind it. */
export function ControlRow({ control, slider, present }: Props) {
  const session = useSession()
  const value = valueIn(session.tree.value, control)
  const low = Math.min(control.low, value)
  const high = Math.max(control.high, value)
  const id = useId()
  const set = (to: number): void =>
    session.direct(moved(session.tree.peek(), control, to), control.key)
  return (
    <div class="control" data-control={control.key}>
      <label for={`${id}box`}>{control.label}</label>
      <NumberBox id={`${id}box`} control={control} value={value} set={set} />
      {control.swept && (
        <Range control={control} value={value} low={low} high={high} set={set} slider={slider} />
      )}
      {slider && (
        <Legend
          slider={slider}
          present={present && Math.abs(slider.present - value) < SAME * (high - low)}
        />
      )}
      <p class="help" id={`${id}box-help`}>
        {control.help}
      </p>
    </div>
  )
}

interface Moved {
  readonly control: Control
  readonly value: number
  readonly set: (value: number) => void
}

function NumberBox({ id, control, value, set }: Moved & { id: string }) {
  const session = useSession()
  const [raw, setRaw] = useState<string | null>(null)
  const shown = `${Number(value.toPrecision(9))}${control.unit && ` ${control.unit}`}`
  const [only, second] = control.sets
  const alone = only && !second && only.added === 0 ? only : null
  const typed = raw === null ? null : typedIn(raw)
  // another unit is for the file to read, where it has the number as it is typed
  const wrong = raw !== null && !(typed && (plainIn(typed, control) !== null || alone))
  const take = (text: string): void => {
    const now = typedIn(text)
    const plain = now && plainIn(now, control)
    if (plain !== null) set(plain)
    else if (now && alone)
      session.direct(put(session.tree.peek(), read(alone.path), text.trim()), control.key)
  }
  return (
    <>
      <input
        id={id}
        type="text"
        inputMode="decimal"
        autocomplete="off"
        spellcheck={false}
        aria-describedby={`${wrong ? `${id}-wrong ` : ''}${id}-help`}
        aria-invalid={wrong}
        value={raw ?? shown}
        onInput={(event) => {
          setRaw(event.currentTarget.value)
          take(event.currentTarget.value)
        }}
        onBlur={() => {
          setRaw(null)
          session.rest()
        }}
        onKeyDown={(event) => {
          if (event.key === 'Enter') {
            if (!wrong) setRaw(null)
            session.rest()
          }
          const way = { ArrowUp: 1, ArrowDown: -1 }[event.key]
          if (!way) return
          event.preventDefault()
          setRaw(null)
          set(stepped(value, way * control.step, event.shiftKey))
        }}
      />
      {wrong && (
        <p class="sentences" id={`${id}-wrong`} role="alert">
          {t('Not a value for this engine. Type one such as {example}.', { example: shown })}
        </p>
      )}
    </>
  )
}

/** What was typed as number and unit, in the letters of any keyboard; null where it is neither. */
const typedIn = (text: string): Quantity | null =>
  parsed(text.normalize('NFKC').replace(',', '.').replace('°', ' deg'))

/** The number in the unit of a control; null where it has another one. */
function plainIn({ number, unit }: Quantity, control: Control): number | null {
  if (!unit || unit === control.unit) return number
  return unit === '%' && !control.unit ? number / 100 : null
}

const stepped = (value: number, step: number, fine: boolean): number => {
  const size = fine ? step / FINE : step
  return Number((value + size).toPrecision(12))
}

interface RangeProps extends Moved {
  readonly low: number
  readonly high: number
  readonly slider: Slider | undefined
}

/** A slider: a drag rests at values that make sense, with alt anywhere; shift and arrows, fine. */
function Range({ control, value, low, high, set, slider }: RangeProps) {
  const session = useSession()
  const held = useRef(false)
  const free = useRef(false)
  const share = (value - low) / (high - low)
  const rest = (): void => {
    held.current = false
    session.rest()
  }
  const curved = slider?.curves.length ? slider : undefined
  return (
    <div class={curved ? 'sweep' : 'sweep plain'}>
      {curved && <Curves slider={curved} share={share} />}
      <input
        type="range"
        aria-label={control.label}
        aria-valuetext={numberText(value, control.unit)}
        min={low}
        max={high}
        step="any"
        value={value}
        onPointerDown={() => {
          held.current = true
        }}
        onPointerMove={(event) => {
          free.current = event.altKey
        }}
        onInput={(event) => {
          const to = Number(event.currentTarget.value)
          const whole = Math.round(to / control.step) * control.step
          const near = free.current ? to : snapped(whole, control.snaps, REACH * (high - low))
          set(Number(near.toPrecision(12)))
        }}
        onKeyDown={(event) => {
          const ways: Record<string, number> = {
            ArrowRight: 1,
            ArrowUp: 1,
            ArrowLeft: -1,
            ArrowDown: -1,
            PageUp: FINE,
            PageDown: -FINE,
          }
          const way = ways[event.key]
          if (way === undefined) return
          event.preventDefault()
          const to = stepped(value, way * control.step, event.shiftKey)
          set(Math.min(high, Math.max(low, to)))
        }}
        onChange={rest}
        onBlur={rest}
      />
      {held.current && (
        <output
          class="readout"
          // within the slider at both of its ends
          style={{ left: `${100 * share}%`, transform: `translateX(${-100 * share}%)` }}
          aria-hidden="true"
        >
          {numberText(value, control.unit)}
        </output>
      )}
    </div>
  )
}

/** What each curve is, and its result at the value where the engine is. */
function Legend({ slider, present }: { slider: Slider; present: boolean }) {
  return (
    <ul class={present ? 'legend' : 'legend waiting'}>
      {slider.curves.map((curve, place) => (
        <li key={`${curve.what} ${curve.order}`}>
          <i class={`key curve-${place}`} aria-hidden="true" />
          {curve.label}{' '}
          <b>{present ? `${typeset(significant(curve.present))} ${curve.unit}` : '…'}</b>
        </li>
      ))}
    </ul>
  )
}

/** A result with the digits of the tables. */
export function significant(value: number): string {
  const size = Math.abs(value)
  if (size < 1e-9) return '0'
  if (size >= 1e5 || size < 1e-3) return value.toExponential(2)
  return String(Number(value.toPrecision(4)))
}

/** Whether two engines leave the same curves for a control: all but its own value is the same. */
export function sameBut(
  control: Control,
  one: Parameters<typeof same>[0],
  other: unknown,
): boolean {
  const bare = (tree: unknown): unknown =>
    control.sets.reduce(
      (now, { path }) => put(now as Record<string, unknown>, read(path), undefined),
      tree,
    )
  return same(bare(one), bare(other))
}
