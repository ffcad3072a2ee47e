import { type Signal, useSignal } from '@preact/signals'
import { useId } from 'preact/hooks'
import { CAMERAS, type Camera } from '../stage/stage'
import { useApp } from './context'
import { Icon } from './icons'
import { toggledWhirl } from './whirl'

const CAMERA_WORDS: Readonly<Record<Camera, string>> = {
  front: 'Front',
  plan: 'Plan',
  side: 'Side',
  isometric: 'Isometric',
  orbit: 'Orbit',
}

/** From where the engine is seen, and what is drawn beside its parts. */
export function Layers() {
  const app = useApp()
  const { store } = app
  const open = useSignal(false)
  const id = useId()
  return (
    <section class="layers" aria-label="View">
      <fieldset class="cameras">
        <legend class="unseen">Seen from</legend>
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
            <span>{CAMERA_WORDS[camera]}</span>
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
        <span>Show</span>
      </button>
      <div class={`shown${open.value ? ' open' : ''}`} id={`${id}-shown`}>
        <Switch label="Force" part={store.force} />
        <Switch label="Couple" part={store.couple} />
        <Switch label="Each cylinder" part={store.cylinders} />
        <label class="switch">
          <input type="checkbox" checked={store.whirl.value > 0} onChange={() => toggledWhirl(app)} />
          <span>Whirl</span>
        </label>
        <Switch label="Bores" part={store.glass} />
        <Switch label="Firing" part={store.glow} />
        <label class="slider">
          <span>Arrows</span>
          <input
            type="range"
            min="-1"
            max="1"
            step="0.05"
            value={Math.log10(store.scale.value)}
            aria-label="Length of the arrows"
            aria-valuetext={`${store.scale.value.toFixed(2)} times`}
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
