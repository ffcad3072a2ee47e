import type { Exhibit } from '../exhibit'
import { css } from '../stage/palette'
import { HEAT } from '../stage/twist'
import { loadName, type Twist, topText } from '../torsion'
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
