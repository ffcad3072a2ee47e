import { useSignal } from '@preact/signals'
import { useId, useRef } from 'preact/hooks'
import { degreesText, typedAngle, withinCycle } from '../angle'
import { paceAt, paceWords, placeOf } from '../pace'
import { useApp, useExhibit, useFollower } from './context'
import { Icon } from './icons'

/** Play and stop, the angle, the speed. */
export function TimeBar() {
  const { clock, store } = useApp()
  const exhibit = useExhibit()
  const playing = clock.playing.value
  const step = (degrees: number) => () => {
    clock.stop()
    clock.turnTo(Math.round((clock.degrees() + degrees) * 1e6) / 1e6)
  }
  return (
    <section class="time" aria-label="Crank angle and speed">
      <div class="angle">
        <button
          type="button"
          class="play"
          onClick={playing ? clock.stop : clock.play}
          aria-label={playing ? 'Stop' : 'Play'}
          title={playing ? 'Stop (space)' : 'Play (space)'}
        >
          <Icon name={playing ? 'stop' : 'play'} />
        </button>
        <button
          type="button"
          class="plain round"
          onClick={step(-1)}
          aria-label="Back by 1 degree"
          title="Back by 1° ( , )"
        >
          <Icon name="back" />
        </button>
        <Scrubber />
        <button type="button" class="plain round" onClick={step(1)} aria-label="On by 1 degree" title="On by 1° ( . )">
          <Icon name="forth" />
        </button>
        <AngleField />
      </div>
      <div class="pace">
        <span class="way" title={way(exhibit.sense)}>
          <Icon name="clockwise" mirrored={exhibit.sense === -1} />
          <span>{way(exhibit.sense)}</span>
        </span>
        <label>
          <span>Speed</span>
          <input
            type="range"
            min="0"
            max="1"
            step="0.01"
            value={placeOf(store.pace.value)}
            aria-valuetext={`${store.pace.value} turns per second, ${paceWords(store.pace.value, exhibit.speed_rpm)}`}
            onInput={(event) => {
              store.pace.value = paceAt(event.currentTarget.valueAsNumber)
            }}
          />
        </label>
        <span class="words">
          <span class="number">{store.pace.value.toFixed(2)}</span> turns/s,{' '}
          {paceWords(store.pace.value, exhibit.speed_rpm)}
        </span>
      </div>
    </section>
  )
}

function way(sense: -1 | 1): string {
  return sense === 1 ? 'clockwise, seen from the front' : 'counter-clockwise, seen from the front'
}

function Scrubber() {
  const { clock } = useApp()
  const slider = useRef<HTMLInputElement>(null)
  useFollower(() => {
    if (slider.current) slider.current.value = String(Math.round(clock.degrees()))
  }, [])
  return (
    <input
      ref={slider}
      class="scrubber"
      type="range"
      min="0"
      max={360 * clock.turns.value}
      step="1"
      aria-label="Crank angle, degrees"
      onInput={(event) => {
        clock.stop()
        clock.turnTo(event.currentTarget.valueAsNumber)
      }}
    />
  )
}

function AngleField() {
  const { clock } = useApp()
  const field = useRef<HTMLInputElement>(null)
  const wrong = useSignal('')
  const turns = clock.turns.value
  const told = useId()
  useFollower(() => {
    const input = field.current
    // what is being typed, or about to be typed while the engine turns, is not overwritten
    const meant = document.activeElement === input && (input?.dataset.typed || clock.playing.peek())
    if (!input || meant || wrong.peek()) return
    input.value = clock.playing.peek() ? clock.degrees().toFixed(0) : degreesText(clock.degrees())
  }, [])

  function enter(): void {
    const input = field.current
    if (!input?.dataset.typed) return
    const typed = typedAngle(input.value)
    wrong.value = typed.ok ? '' : typed.sentence
    if (!typed.ok) return
    delete input.dataset.typed
    clock.stop()
    clock.turnTo(typed.degrees)
    input.value = degreesText(withinCycle(typed.degrees, turns))
  }

  function leave(): void {
    enter()
    if (!wrong.peek()) return
    wrong.value = ''
    if (field.current) delete field.current.dataset.typed
    clock.refresh()
  }

  return (
    <span class="field">
      <label>
        <span class="theta">θ</span>
        <input
          ref={field}
          type="text"
          inputMode="text"
          autocomplete="off"
          spellcheck={false}
          aria-label="Crank angle: type degrees, or an angle with its unit"
          aria-invalid={wrong.value !== ''}
          aria-describedby={wrong.value ? told : undefined}
          title="450, -30, 90 deg, 1.5 rad, 2 turns"
          onInput={(event) => {
            event.currentTarget.dataset.typed = 'yes'
            wrong.value = ''
          }}
          onFocus={(event) => event.currentTarget.select()}
          onKeyDown={(event) => {
            if (event.key === 'Enter') enter()
            if (event.key === 'Escape') {
              wrong.value = ''
              delete event.currentTarget.dataset.typed
              clock.refresh()
            }
          }}
          onBlur={leave}
        />
        <span class="unit">° of {360 * turns}</span>
      </label>
      {wrong.value && (
        <span class="wrong" id={told} role="alert">
          {wrong.value}
        </span>
      )}
    </span>
  )
}
