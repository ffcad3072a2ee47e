import { useSignal } from '@preact/signals'
import { useId, useRef } from 'preact/hooks'
import { degreesText, typedAngle, withinCycle } from '../angle'
import { t } from '../language/messages'
import { paceAt, paceText, placeOf } from '../pace'
import { set } from '../state'
import { useApp, useExhibit, useFollower } from './context'
import { Icon } from './icons'

/** Play and stop, the crank angle, the pace. */
export function TimeBar() {
  const { clock } = useApp()
  const playing = clock.playing.value
  const step = (degrees: number) => () => {
    clock.stop()
    clock.turnTo(Math.round((clock.degrees() + degrees) * 1e6) / 1e6)
  }
  return (
    <section class="time" aria-label={t('Crank angle and speed')}>
      <div class="angle">
        <button
          type="button"
          class="play"
          onClick={playing ? clock.stop : clock.play}
          aria-label={playing ? t('Stop') : t('Play')}
          title={playing ? t('Stop (space)') : t('Play (space)')}
        >
          <Icon name={playing ? 'stop' : 'play'} />
        </button>
        <button
          type="button"
          class="plain round"
          onClick={step(-1)}
          aria-label={t('Back 1 degree')}
          title={t('Back 1° (comma)')}
        >
          <Icon name="back" />
        </button>
        <Scrubber />
        <button
          type="button"
          class="plain round"
          onClick={step(1)}
          aria-label={t('Forward 1 degree')}
          title={t('Forward 1° (full stop)')}
        >
          <Icon name="forth" />
        </button>
        <AngleField />
      </div>
      <Pace />
    </section>
  )
}

/** How fast the crankshaft turns on the page, beside the speed of the engine. */
function Pace() {
  const { store } = useApp()
  const { speed_rpm } = useExhibit()
  const pace = store.pace.value
  const beside = paceText(pace, speed_rpm)
  const turns = t('{pace} turns/s', { pace: pace.toFixed(2) })
  return (
    <div class="pace">
      <label>
        <span>{t('Speed')}</span>
        <input
          type="range"
          min="0"
          max="1"
          step="0.01"
          value={placeOf(pace)}
          aria-label={t('Speed')}
          aria-valuetext={`${turns}, ${beside}`}
          onInput={(event) => set(store.pace, paceAt(event.currentTarget.valueAsNumber))}
        />
      </label>
      <span class="words">
        <span class="number">{turns}</span>, {beside}
      </span>
    </div>
  )
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
      aria-label={t('Crank angle, degrees')}
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
  const id = useId()
  useFollower(() => {
    const input = field.current
    // typing is not overwritten, nor a field with the focus while the engine turns
    const typing =
      document.activeElement === input && (input?.dataset.typed || clock.playing.peek())
    if (!input || typing || wrong.peek()) return
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
          aria-label={t('Crank angle: type degrees or a number with its unit')}
          aria-invalid={wrong.value !== ''}
          aria-describedby={wrong.value ? id : undefined}
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
        <span class="unit">{t('° of {cycle}', { cycle: 360 * turns })}</span>
      </label>
      {wrong.value && (
        <span class="wrong" id={id} role="alert">
          {wrong.value}
        </span>
      )}
    </span>
  )
}
