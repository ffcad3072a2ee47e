import { useSignal } from '@preact/signals'
import { useEffect, useId, useRef } from 'preact/hooks'
import { t } from '../language/messages'
import { set } from '../state'
import { Choice } from './Choice'
import { useApp } from './context'
import { Each } from './Each'
import { Icon } from './icons'
import { panelsOf } from './panels'

/** The panel that is seen where none is chosen. */
const FIRST = 'orders'

/** The panels, one at a time. Only the one that is seen is there. */
export function Tabs() {
  const app = useApp()
  const strip = useRef<HTMLDivElement>(null)
  const id = useId()
  const panels = panelsOf(app)
  const there = panels.filter(({ when }) => when?.(app) ?? true)
  const wanted = app.store.tab.value
  const panel = there.find(({ key }) => key === wanted) ?? there.find(({ key }) => key === FIRST)
  const missing = panel?.key !== wanted && panels.find(({ key }) => key === wanted)

  function choose(key: string | undefined): void {
    if (!key) return
    app.store.tab.value = key
    strip.current?.querySelector<HTMLElement>(`[data-tab="${key}"]`)?.focus()
  }

  function pressed(event: KeyboardEvent): void {
    const place = panel ? there.indexOf(panel) : -1
    const goals: Record<string, number> = {
      ArrowRight: place + 1,
      ArrowLeft: place - 1,
      Home: 0,
      End: there.length - 1,
    }
    const goal = goals[event.key]
    if (goal === undefined) return
    event.preventDefault()
    choose(there[(goal + there.length) % there.length]?.key)
  }

  useEffect(() => {
    const tab = strip.current?.querySelector<HTMLElement>('[aria-selected="true"]')
    if (!strip.current || !tab) return
    // scrollIntoView would also move the page
    const before = tab.getBoundingClientRect().left - strip.current.getBoundingClientRect().left
    strip.current.scrollLeft += before - (strip.current.clientWidth - tab.offsetWidth) / 2
  }, [panel])

  if (!panel) return null
  const { Content } = panel
  return (
    <section class="panels" aria-label={t('Analysis')}>
      <Strip strip={strip}>
        <div class="tabs" role="tablist" aria-label={t('Panels')} ref={strip} onKeyDown={pressed}>
          {there.map(({ key, label }) => (
            <button
              key={key}
              type="button"
              role="tab"
              id={`${id}-${key}`}
              data-tab={key}
              aria-selected={key === panel.key}
              aria-controls={`${id}-panel`}
              tabIndex={key === panel.key ? 0 : -1}
              onClick={() => choose(key)}
            >
              {t(label)}
              {key === 'edit' && app.slips.value > 0 && (
                <span class="badge" title={t('mistakes')}>
                  {app.slips.value}
                </span>
              )}
            </button>
          ))}
        </div>
      </Strip>
      <div
        class="panel"
        role="tabpanel"
        id={`${id}-panel`}
        aria-labelledby={`${id}-${panel.key}`}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: a scrolling panel is reached by keys
        tabIndex={0}
        data-panel={panel.key}
      >
        <h2 class="unseen">{t(panel.label)}</h2>
        {panel.key !== 'edit' && app.slips.value > 0 && (
          <p class="doubt" role="status">
            {t('The engine that is edited has mistakes: this is the last one without.')}
          </p>
        )}
        {missing && (
          <p class="doubt" role="status">
            {t(
              'Nothing to show under {panel} for this engine on this page; {shown} is open instead.',
              {
                panel: t(missing.label),
                shown: t(panel.label),
              },
            )}
          </p>
        )}
        {panel.of !== 'all' && <EngineChoice />}
        {panel.of === 'each' ? (
          <Each key={panel.key} Part={Content} />
        ) : (
          <Content key={panel.key} />
        )}
      </div>
    </section>
  )
}

/** One row of tabs; where it is too long, it fades at its ends and has arrows for a mouse. */
function Strip({
  strip,
  children,
}: {
  strip: { readonly current: HTMLDivElement | null }
  children: preact.ComponentChildren
}) {
  const [before, after] = [useSignal(false), useSignal(false)]
  useEffect(() => {
    const row = strip.current
    if (!row) return undefined
    const looked = (): void => {
      before.value = row.scrollLeft > 1
      after.value = row.scrollLeft + row.clientWidth < row.scrollWidth - 1
    }
    const sized = new ResizeObserver(looked)
    sized.observe(row)
    for (const tab of row.children) sized.observe(tab)
    row.addEventListener('scroll', looked, { passive: true })
    return () => {
      sized.disconnect()
      row.removeEventListener('scroll', looked)
    }
  })
  const scroll = (way: number) => () => {
    const row = strip.current
    row?.scrollBy({ left: 0.7 * way * row.clientWidth, behavior: 'smooth' })
  }
  return (
    <div class={`strip${before.value ? ' before' : ''}${after.value ? ' after' : ''}`}>
      {children}
      {/* for a mouse only: keys go from tab to tab, fingers push the row */}
      <button type="button" class="back" tabIndex={-1} aria-hidden="true" onClick={scroll(-1)}>
        <Icon name="back" />
      </button>
      <button type="button" class="on" tabIndex={-1} aria-hidden="true" onClick={scroll(1)}>
        <Icon name="forth" />
      </button>
    </div>
  )
}

/** Which of two engines the panel shows, or both. */
function EngineChoice() {
  const { shown, store } = useApp()
  if (shown.value.length < 2) return null
  return (
    <Choice
      label={t('Engine')}
      value={store.panel.value}
      choices={[
        { value: 'both', label: t('both') },
        ...shown.value.map(({ name }, index) => ({
          value: index ? ('2' as const) : ('1' as const),
          label: name,
        })),
      ]}
      chosen={(value) => set(store.panel, value)}
    />
  )
}
