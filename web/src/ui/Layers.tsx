import { useSignal } from '@preact/signals'
import { useId } from 'preact/hooks'
import { message, t } from '../language/messages'
import { Switch } from '../Switch'
import { CAMERAS, type Camera } from '../stage/stage'
import { set } from '../state'
import { useApp } from './context'
import { Icon } from './icons'
import { toggledWhirl } from './whirl'

const CAMERA = {
  front: message('Front'),
  plan: message('Plan'),
  side: message('Side'),
  isometric: message('Isometric'),
  orbit: message('Orbit'),
} as const satisfies Record<Camera, string>

const SWITCHES = [
  ['force', message('Force')],
  ['couple', message('Couple')],
  ['cylinders', message('Each cylinder')],
  ['whirl', message('Whirl')],
  ['glass', message('Bores')],
  ['glow', message('Strokes')],
] as const

/** The view of the engine, and what is drawn with its parts. */
export function Layers() {
  const app = useApp()
  const { store } = app
  const open = useSignal(false)
  const id = useId()
  return (
    <section class="layers" aria-label={t('View')}>
      <fieldset class="cameras">
        <legend class="unseen">{t('View from')}</legend>
        {CAMERAS.map((camera) => (
          <label key={camera} class={store.camera.value === camera ? 'chosen' : ''}>
            <input
              type="radio"
              name={`${id}-camera`}
              value={camera}
              checked={store.camera.value === camera}
              onChange={() => set(store.camera, camera)}
            />
            <span>{t(CAMERA[camera])}</span>
          </label>
        ))}
      </fieldset>
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
      </div>
    </section>
  )
}
