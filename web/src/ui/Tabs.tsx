import type { ComponentType } from 'preact'
import { useEffect, useId, useRef } from 'preact/hooks'
import type { App } from '../app'
import { TABS, type Tab } from '../state'
import { useApp } from './context'
import { About } from './panels/About'
import { Compare } from './panels/Compare'
import { Derivation } from './panels/Derivation'
import { Edit } from './panels/Edit'
import { Forces } from './panels/Forces'
import { Orders } from './panels/Orders'
import { Remedies } from './panels/Remedies'
import { Stars } from './panels/Stars'
import { Strokes } from './panels/Strokes'
import { Verdict } from './panels/Verdict'
import { WhirlPanel } from './panels/WhirlPanel'

interface Panel {
  readonly label: string
  readonly content: ComponentType
  /** Whether there is anything to show; without it, always. */
  readonly when?: (app: App) => boolean
}

const PANELS: Readonly<Record<Tab, Panel>> = {
  orders: { label: 'Orders', content: Orders },
  stars: { label: 'Stars', content: Stars },
  forces: { label: 'Forces', content: Forces },
  strokes: { label: 'Strokes', content: Strokes },
  derivation: {
    label: 'Derivation',
    content: Derivation,
    when: ({ shown }) => (shown.value[0]?.derivations.length ?? 0) > 0,
  },
  verdict: { label: 'Verdict', content: Verdict },
  remedies: { label: 'Weights and shafts', content: Remedies },
  whirl: { label: 'Whirl', content: WhirlPanel },
  compare: {
    label: 'Compare',
    content: Compare,
    when: ({ host }) => !!host.service || host.exhibition.engines.length > 1,
  },
  edit: { label: 'Edit', content: Edit, when: ({ host }) => !!host.service },
  about: { label: 'About', content: About },
}

/** The panels, one at a time. Only the one that is seen is there. */
export function Tabs() {
  const app = useApp()
  const list = useRef<HTMLDivElement>(null)
  const id = useId()
  const there = TABS.filter((tab) => PANELS[tab].when?.(app) ?? true)
  const chosen = there.find((tab) => tab === app.store.tab.value) ?? 'orders'
  const Content = PANELS[chosen].content

  function choose(tab: Tab | undefined): void {
    if (!tab) return
    app.store.tab.value = tab
    list.current?.querySelector<HTMLElement>(`[data-tab="${tab}"]`)?.focus()
  }

  function pressed(event: KeyboardEvent): void {
    const place = there.indexOf(chosen)
    const goals: Record<string, number> = {
      ArrowRight: place + 1,
      ArrowLeft: place - 1,
      Home: 0,
      End: there.length - 1,
    }
    const goal = goals[event.key]
    if (goal === undefined) return
    event.preventDefault()
    choose(there[(goal + there.length) % there.length])
  }

  useEffect(() => {
    const strip = list.current
    const tab = strip?.querySelector<HTMLElement>('[aria-selected="true"]')
    if (!strip || !tab) return
    // scrollIntoView would also move the page
    const before = tab.getBoundingClientRect().left - strip.getBoundingClientRect().left
    strip.scrollLeft += before - (strip.clientWidth - tab.offsetWidth) / 2
  }, [chosen])

  return (
    <section class="panels" aria-label="Analysis">
      <div class="tabs" role="tablist" aria-label="Panels" ref={list} onKeyDown={pressed}>
        {there.map((tab) => (
          <button
            key={tab}
            type="button"
            role="tab"
            id={`${id}-${tab}`}
            data-tab={tab}
            aria-selected={tab === chosen}
            aria-controls={`${id}-panel`}
            tabIndex={tab === chosen ? 0 : -1}
            onClick={() => choose(tab)}
          >
            {PANELS[tab].label}
          </button>
        ))}
      </div>
      <div
        class="panel"
        role="tabpanel"
        id={`${id}-panel`}
        aria-labelledby={`${id}-${chosen}`}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: a panel that scrolls is reached by keyboard
        tabIndex={0}
        data-panel={chosen}
      >
        <h2 class="unseen">{PANELS[chosen].label}</h2>
        <Content key={chosen} />
      </div>
    </section>
  )
}
