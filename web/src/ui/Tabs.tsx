import type { ComponentType } from 'preact'
import { useEffect, useId, useRef } from 'preact/hooks'
import type { App } from '../app'
import { message, t } from '../language/messages'
import { set, TABS, type Tab } from '../state'
import { Choice } from './Choice'
import { useApp } from './context'
import { About } from './panels/About'
import { Bearings } from './panels/Bearings'
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
  orders: { label: message('Orders'), content: Orders },
  stars: { label: message('Stars'), content: Stars },
  forces: { label: message('Forces'), content: Forces },
  bearings: { label: message('Bearings'), content: Bearings },
  strokes: { label: message('Strokes'), content: Strokes },
  derivation: {
    label: message('Derivation'),
    content: Derivation,
    when: ({ shown, subject }) => (shown.value[subject.value]?.derivations.length ?? 0) > 0,
  },
  verdict: { label: message('Verdict'), content: Verdict },
  remedies: { label: message('Balancing'), content: Remedies },
  whirl: { label: message('Whirl'), content: WhirlPanel },
  compare: {
    label: message('Compare'),
    content: Compare,
    when: ({ host }) => !!host.service || host.exhibition.engines.length > 1,
  },
  edit: { label: message('Edit'), content: Edit, when: ({ host }) => !!host.service },
  about: { label: message('About'), content: About },
}
/** Panels that show both engines, or the only one that can be edited. */
const OF_ALL: readonly Tab[] = ['compare', 'edit', 'about']

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
    <section class="panels" aria-label={t('Analysis')}>
      <div class="tabs" role="tablist" aria-label={t('Panels')} ref={list} onKeyDown={pressed}>
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
            {t(PANELS[tab].label)}
          </button>
        ))}
      </div>
      <div
        class="panel"
        role="tabpanel"
        id={`${id}-panel`}
        aria-labelledby={`${id}-${chosen}`}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: a scrolling panel is reached by keys
        tabIndex={0}
        data-panel={chosen}
      >
        <h2 class="unseen">{t(PANELS[chosen].label)}</h2>
        {!OF_ALL.includes(chosen) && <EngineChoice />}
        <Content key={chosen} />
      </div>
    </section>
  )
}

/** Which of two engines the panel shows. */
function EngineChoice() {
  const { shown, subject, store } = useApp()
  if (shown.value.length < 2) return null
  return (
    <Choice
      label={t('Engine')}
      value={String(subject.value + 1)}
      choices={shown.value.map(({ name }, index) => ({ value: String(index + 1), label: name }))}
      chosen={(value) => set(store.panel, value === '2' ? '2' : '1')}
    />
  )
}
