import { useSignal } from '@preact/signals'
import { snapshot, stateText, THEMES, type Theme } from '../state'
import { useApp } from './context'
import { Icon } from './icons'

const THEME_WORDS: Readonly<Record<Theme, string>> = { auto: 'as the system', light: 'light', dark: 'dark' }

/** The engine's name, how it turns, and what concerns the page as a whole. */
export function Header() {
  const { shown, store, clock, host } = useApp()
  const said = useSignal('')
  const next = THEMES[(THEMES.indexOf(store.theme.value) + 1) % THEMES.length] ?? 'auto'

  async function copy(): Promise<void> {
    // the link shows what is seen now, so it holds the angle even while the engine turns
    const text = stateText({ ...snapshot(store), angle: Number(clock.degrees().toFixed(2)) })
    const address = `${location.href.split('#')[0]}#${text}`
    try {
      await navigator.clipboard.writeText(address)
      said.value =
        location.protocol === 'file:' ? 'Link copied. It opens this file: send the file with it.' : 'Link copied.'
    } catch {
      host.writeState(text)
      said.value = 'Copy the link from the address bar.'
    }
    window.setTimeout(() => {
      said.value = ''
    }, 4000)
  }

  return (
    <header class="head">
      <div class="names">
        {shown.value.map((exhibit, index) => (
          <div class="name" key={index}>
            <h1>{exhibit.name}</h1>
            <p class="about">{turning(exhibit.sense, exhibit.speed_rpm)}</p>
          </div>
        ))}
      </div>
      <div class="tools">
        <span class="said" role="status">
          {said.value}
        </span>
        {host.kind !== 'widget' && (
          <button type="button" class="plain" onClick={() => void copy()}>
            <Icon name="link" />
            <span>Copy link</span>
          </button>
        )}
        <button
          type="button"
          class="plain round"
          onClick={() => {
            store.theme.value = next
          }}
          aria-label={`Colours: ${THEME_WORDS[store.theme.value]}. Change to ${THEME_WORDS[next]}.`}
          title={`Colours: ${THEME_WORDS[store.theme.value]}`}
        >
          <Icon name={store.theme.value} />
        </button>
      </div>
    </header>
  )
}

function turning(sense: -1 | 1, speedRpm: number | null): string {
  const way = sense === 1 ? 'clockwise seen from the front' : 'counter-clockwise seen from the front'
  return speedRpm === null ? `turns ${way}` : `turns ${way} at ${Number(speedRpm.toPrecision(6))} rpm`
}
