import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { css } from '../stage/palette'
import { HEAT } from '../stage/twist'
import { loadName, type Twist, topText } from '../torsion'
import { sizeText } from './Bars'
import { useApp } from './context'

/** What is chosen of the twist, as links have it; an empty text for how it opens. */
interface Chosen {
  readonly show?: string
  readonly mode?: string
  readonly order?: string
  readonly at?: string
  readonly times?: string
}

/** What changes the choice. */
export function useTwist(): (change: Chosen) => void {
  const { store } = useApp()
  return (change) => {
    const next = { ...store.choices.value }
    for (const [name, value] of Object.entries(change)) {
      if (value === '' || value === OPENING[name]) delete next[`twist.${name}`]
      else next[`twist.${name}`] = value
    }
    store.choices.value = next
  }
}

const OPENING: Readonly<Record<string, string>> = { show: 'still', mode: '1', at: '0' }

/** The slider runs from 1 to ten thousand, in powers of ten. */
const DECADES = 4

/** How many times its true size the twist is drawn. */
export function Magnification({ twist }: { twist: Twist }) {
  const choose = useTwist()
  const text = t('exaggerated × {times}', { times: sizeText(twist.times) })
  return (
    <label class="wide times">
      <span>{t('Magnification')}</span>
      <input
        type="range"
        min="0"
        max={DECADES}
        step="0.02"
        value={Math.log10(twist.times)}
        aria-valuetext={text}
        onInput={(event) => {
          const times = 10 ** event.currentTarget.valueAsNumber
          choose({ times: String(Math.max(1, Number(times.toPrecision(2)))).split('.')[0] ?? '1' })
        }}
      />
      <span class="number">{text}</span>
    </label>
  )
}

/** What the colours of the crank mean, as on the stage. */
export function HeatLegend({ exhibit, twist }: { exhibit: Exhibit; twist: Twist }) {
  const colours = HEAT.map((colour) => css(colour)).join(', ')
  if (!(twist.top > 0)) return null
  return (
    <p class="heat-legend">
      <span>{loadName(twist)}</span> <span class="number">0</span>
      <i
        class="heat"
        style={{ background: `linear-gradient(to right, ${colours})` }}
        aria-hidden="true"
      />
      <span class="number">{topText(exhibit, twist)}</span>
    </p>
  )
}
