import { type Signal, useSignal } from '@preact/signals'
import { useId } from 'preact/hooks'
import { message, t } from '../language/messages'
import { CAMERAS, type Camera } from '../stage/stage'
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
              onChange={() => {
                store.camera.value = camera
              }}
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
        onClick={() => {
          open.value = !open.value
        }}
      >
        <Icon name="layers" />
        <span>{t('Show')}</span>
      </button>
      <div class={`shown${open.value ? ' open' : ''}`} id={`${id}-shown`}>
        <Switch label={t('Force')} part={store.force} />
        <Switch label={t('Couple')} part={store.couple} />
        <Switch label={t('Each cylinder')} part={store.cylinders} />
        <label class="switch">
          <input
            type="checkbox"
            checked={store.whirl.value > 0}
            onChange={() => toggledWhirl(app)}
          />
          <span>{t('Whirl')}</span>
        </label>
        <Switch label={t('Bores')} part={store.glass} />
        <Switch label={t('Strokes')} part={store.glow} />
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
            onInput={(event) => {
              store.scale.value = Number((10 ** event.currentTarget.valueAsNumber).toPrecision(3))
            }}
          />
        </label>
      </div>
    </section>
  )
}

function Switch({ label, part }: { label: string; part: Signal<boolean> }) {
  return (
    <label class="switch">
      <input
        type="checkbox"
        checked={part.value}
        onChange={(event) => {
          part.value = event.currentTarget.checked
        }}
      />
      <span>{label}</span>
    </label>
  )
}
