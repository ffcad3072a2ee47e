import type { ComponentChildren } from 'preact'
import type { Term as Entry, Exhibition } from '../exhibit'
import { language, t } from '../language/messages'
import { useApp } from './context'

const known = new WeakMap<Exhibition, ReadonlyMap<string, Entry>>()

/** The glossary by its words, in lower case. */
export function wordsOf(exhibition: Exhibition): ReadonlyMap<string, Entry> {
  const before = known.get(exhibition)
  if (before) return before
  const { glossary = [] } = exhibition
  const words = new Map<string, Entry>()
  known.set(exhibition, words)
  for (const term of glossary)
    for (const word of [
      ...[term.term, ...term.term.split(', '), ...(term.also ?? [])],
      ...[term.japanese, term.russian],
    ])
      if (!words.has(word.toLowerCase())) words.set(word.toLowerCase(), term)
  return words
}

/** What a term is called in the language of the page. */
export function nameOf({ term, japanese, russian }: Entry): string {
  return language.value === 'ja' ? japanese : language.value === 'ru' ? russian : term
}

/** What a term means, in the language of the page. */
function meaningOf({ meanings }: Entry): string {
  return meanings[language.value] ?? ''
}

/** A word that the glossary explains: at a touch, under a pointer, or when it has the focus. */
export function Term({ word, children }: { word: string; children: ComponentChildren }) {
  const { host, explained } = useApp()
  const term = wordsOf(host.exhibition).get(word.toLowerCase())
  if (!term) return <>{children}</>
  const show = (event: { currentTarget: HTMLElement }): void => {
    explained.value = { term, beside: event.currentTarget }
  }
  const hide = (): void => {
    explained.value = null
  }
  return (
    // biome-ignore lint/a11y/useSemanticElements: a button would take the press of a heading
    <span
      class="term"
      role="button"
      tabIndex={0}
      aria-description={meaningOf(term)}
      onPointerEnter={(event) => event.pointerType === 'mouse' && show(event)}
      onPointerLeave={(event) => event.pointerType === 'mouse' && hide()}
      onClick={(event) => {
        event.stopPropagation()
        show(event)
      }}
      onFocus={show}
      onBlur={hide}
      onKeyDown={(event) => event.key === 'Escape' && hide()}
    >
      {children}
    </span>
  )
}

/** The words that the sentences of a verdict use, which come as text: explained below them. */
export function Words() {
  return (
    <p class="soft small">
      {t('Words of verdicts:')} <Term word="primary">{t('primary')}</Term>,{' '}
      <Term word="secondary">{t('secondary')}</Term>,{' '}
      <Term word="Lanchester">{t('Lanchester balancer')}</Term>
    </p>
  )
}

/** Room between a word and its explanation, and at the edges of the window, pixels. */
const [GAP, EDGE, WIDE] = [6, 8, 320]

/** The explanation of the word that is pointed at, below it or, where there is no room, above. */
export function Explanation() {
  const { explained } = useApp()
  const now = explained.value
  if (!now) return null
  const { term, beside } = now
  const box = beside.getBoundingClientRect()
  const room = Math.min(WIDE, innerWidth - 2 * EDGE)
  const left = Math.max(EDGE, Math.min(box.left, innerWidth - room - EDGE))
  const above = box.bottom > 0.7 * innerHeight
  const place = (element: HTMLElement | null): void => {
    if (!element) return
    element.style.left = `${left}px`
    element.style.width = `${room}px`
    if (above) element.style.bottom = `${innerHeight - box.top + GAP}px`
    else element.style.top = `${box.bottom + GAP}px`
  }
  return (
    <div class="explanation" role="tooltip" ref={place}>
      <p>
        <strong>{nameOf(term)}</strong>
        {term.symbol && <span class="symbol"> {symbolText(term.symbol)}</span>}
      </p>
      <p>{t('{meaning}.', { meaning: meaningOf(term) })}</p>
      <p class="soft">
        {[term.term, term.japanese, term.russian]
          .filter((name) => name !== nameOf(term))
          .join(' · ')}
      </p>
      <p class="unseen">{t('Escape closes this.')}</p>
    </div>
  )
}

/** A symbol with its indices lowered: F_k, M_1. */
function symbolText(symbol: string) {
  return symbol
    .split(/(_\w+)/)
    .map((part, index) => (part.startsWith('_') ? <sub key={index}>{part.slice(1)}</sub> : part))
}
