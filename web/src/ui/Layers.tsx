import { useSignal } from '@preact/signals'
import { useId, useMemo } from 'preact/hooks'
import type { StrokeColours } from '../exhibit'
import { message, t } from '../language/messages'
import { Switch } from '../Switch'
import { banksOf } from '../stage/banks'
import { slicesOf } from '../stage/section'
import { EACH, type Each, SIGHTS, type Sight } from '../stage/stage'
import { set } from '../state'
import { useApp } from './context'
import { Icon } from './icons'
import { toggledWhirl } from './whirl'

export const SIGHT = {
  sheet: message('Sheet'),
  front: message('Front'),
  plan: message('Plan'),
  side: message('Side'),
  isometric: message('Isometric'),
  orbit: message('Orbit'),
} as const satisfies Record<Sight, string>

const SWITCHES = [
  ['force', message('Force')],
  ['couple', message('Couple')],
  ['roll', message('Roll')],
  ['whirl', message('Whirl')],
  ['glass', message('Bores')],
  ['glow', message('Strokes')],
] as const

/** The view of the engine, and what is drawn with its parts. */
export function Layers() {
  const app = useApp()
  const { store, sight, roomy } = app
  const open = useSignal(false)
  const id = useId()
  return (
    <section class="layers" aria-label={t('View')}>
      <fieldset class="cameras">
        <legend class="unseen">{t('View from')}</legend>
        {SIGHTS.filter((each) => each !== 'sheet' || roomy.value).map((each) => (
          <label key={each} class={sight.value === each ? 'chosen' : ''}>
            <input
              type="radio"
              name={`${id}-camera`}
              value={each}
              checked={sight.value === each}
              onChange={() => set(store.camera, each)}
            />
            <span>{t(SIGHT[each])}</span>
          </label>
        ))}
      </fieldset>
      <SectionChoice />
      <button
        type="button"
        class="plain more"
        aria-expanded={open.value}
        aria-controls={`${id}-shown`}
        onClick={() => set(open, !open.value)}
      >
        <Icon name="layers" />
        <span>{t('Show')}</span>
      </button>
      <div class={`shown${open.value ? ' open' : ''}`} id={`${id}-shown`}>
        {SWITCHES.map(([part, name]) => (
          <Switch
            key={part}
            label={t(name)}
            on={Boolean(store[part].value)}
            change={(on) => (part === 'whirl' ? toggledWhirl(app) : set(store[part], on))}
          />
        ))}
        {store.couple.value && (
          <Switch
            label={t('Pitch and yaw')}
            on={store.axes.value}
            change={(on) => set(store.axes, on)}
          />
        )}
        <EachChoice />
        <label class="slider">
          <span>{t('Arrows')}</span>
          <input
            type="range"
            min="-1"
            max="1"
            step="0.05"
            value={Math.log10(store.scale.value)}
            aria-label={t('Arrow length')}
            aria-valuetext={`× ${store.scale.value.toFixed(2)}`}
            onInput={(event) =>
              set(store.scale, Number((10 ** event.currentTarget.valueAsNumber).toPrecision(3)))
            }
          />
        </label>
        <StrokeLegend />
      </div>
    </section>
  )
}

const STROKES = {
  intake: message('intake'),
  compression: message('compression'),
  power: message('power'),
  exhaust: message('exhaust'),
} as const satisfies Record<keyof StrokeColours, string>

/** The colours of the strokes, as on the stage and in the stroke chart. */
function StrokeLegend() {
  const { store, shown, host } = useApp()
  const strokes = new Set(
    shown.value.flatMap((exhibit) => exhibit.stroke_windows.map(({ stroke }) => stroke)),
  )
  if (!store.glow.value || !strokes.size) return null
  const colours = host.exhibition.stroke_colours
  const all = Object.keys(STROKES) as (keyof StrokeColours)[]
  return (
    <ul class="legend" aria-label={t('Colours of the strokes')}>
      {all
        .filter((stroke) => strokes.has(stroke))
        .map((stroke) => (
          <li key={stroke}>
            <span class="swatch" style={{ background: colours[stroke] }} aria-hidden="true" />
            {t(STROKES[stroke])}
          </li>
        ))}
    </ul>
  )
}

const OF = {
  engine: message('of the engine'),
  banks: message('of each bank'),
  cylinders: message('of each cylinder'),
} as const satisfies Record<Each, string>

/** Of what there are arrows of force besides those of the whole engine. */
function EachChoice() {
  const { store, shown } = useApp()
  const rows = shown.value.some((exhibit) => banksOf(exhibit).length > 0)
  const offered = EACH.filter((each) => each !== 'banks' || rows)
  return (
    <label class="slider">
      <span>{t('Forces')}</span>
      <select
        value={store.each.value}
        onChange={(event) => set(store.each, event.currentTarget.value as Each)}
      >
        {offered.map((each) => (
          <option key={each} value={each}>
            {t(OF[each])}
          </option>
        ))}
      </select>
    </label>
  )
}

/** Where the front view is cut: a slice between two webs, or nowhere. */
function SectionChoice() {
  const { store, shown, subject, sight } = useApp()
  const exhibit = shown.value[subject.value]
  const slices = useMemo(() => (exhibit ? slicesOf(exhibit.scene) : []), [exhibit])
  if (slices.length < 2 || (sight.value !== 'sheet' && sight.value !== 'front')) return null
  const place = Math.min(store.section.value, slices.length)
  const slice = slices[place - 1]
  const text = slice
    ? t('cylinders {numbers}', { numbers: slice.cylinders.join(', ') })
    : t('whole engine')
  return (
    <label class="slider section">
      <span>{t('Section')}</span>
      <input
        type="range"
        min="0"
        max={slices.length}
        step="1"
        value={place}
        aria-valuetext={text}
        onInput={(event) => set(store.section, event.currentTarget.valueAsNumber)}
      />
      <output>{text}</output>
    </label>
  )
}
