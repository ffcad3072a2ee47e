import { useEffect, useRef } from 'preact/hooks'
import frame from '../../../src/crankstar/report/frame.svg?raw'
import { message, t } from '../language/messages'
import { restore, type State, type Store, set, stateOf } from '../state'
import { useApp } from './context'
import { Icon } from './icons'
import { enginesOf, onThisPage, TOURS, type Tour } from './tours'

interface Step {
  readonly about: string
  /** The panel that it speaks of: open until the next step. */
  readonly tab?: string
  readonly title: string
  readonly text: string
  /** The same where there is no room for the drawing sheet. */
  readonly narrow?: string
}

/** What the guide says, step by step, and which part of the page it is about. */
const STEPS = [
  {
    about: '.stages',
    title: message('The engine'),
    text: message(
      'You see the moving parts of the engine and nothing else: crankshaft red, rods and pistons grey, cylinder bores as glass. All views show the same instant. Click a view to enlarge it; the section cuts the front view at one crank pin.',
    ),
    narrow: message(
      'You see the moving parts of the engine and nothing else: crankshaft red, rods and pistons grey, cylinder bores as glass. Press a name above it, or swipe on a touch screen, for another view; the front view can be cut at one crank pin.',
    ),
  },
  {
    about: '.time',
    title: message('The crank angle'),
    text: message(
      'The crankshaft turns in slow motion. Stop it with the space bar, drag the slider or type an angle: everything on the page follows. At 0° the piston of cylinder 1 is at its top dead centre.',
    ),
  },
  {
    about: '.now',
    title: message('Force and couple'),
    text: message(
      'Pistons are thrown up and down, and what accelerates them pushes back on the block. The blue arrow is the sum of these inertia forces. The pair of arrows at both ends is the couple: forces that cancel in sum, but act at different places along the crankshaft and rock the engine. What does not cancel is felt as vibration.',
    ),
  },
  {
    about: '.panels',
    tab: 'orders',
    title: message('Orders'),
    text: message(
      'A shake is a sum of orders. Order 1 repeats once per turn of the crankshaft, order 2 twice, and so on. For each the table gives its greatest value and its path. Click an order to see it alone on the engine. A dotted line under a word means that it is explained.',
    ),
  },
  {
    about: '.tabs',
    tab: 'verdict',
    title: message('What to do about it'),
    text: message(
      'Verdict says in words what remains. Balancing fits the counterweights and balance shafts that would cure it. Derivation shows why, step by step.',
    ),
  },
] as const satisfies readonly Step[]

/** The guide "What am I looking at?", which points at one part of the page after the other. */
export function Guide() {
  const { guide, host, store, clock, calm, roomy } = useApp()
  const card = useRef<HTMLElement>(null)
  const step: Step | undefined = STEPS[guide.value - 1]
  useEffect(() => {
    const tab = step?.tab
    if (!tab) return undefined
    const before = store.tab.peek()
    set(store.tab, tab)
    // back to where the reader was, who may have gone elsewhere
    return () => {
      if (store.tab.peek() === tab) set(store.tab, before)
    }
  }, [step, store])
  useEffect(() => {
    const root = card.current?.closest('.crankstar')
    const part = step && root?.querySelector<HTMLElement>(step.about)
    part?.classList.add('shown-by-guide')
    // when the panel that it speaks of is there: what was scrolled may have been another
    const waiting = requestAnimationFrame(() => {
      part?.closest('.panels')?.querySelector('.panel')?.scrollTo({ top: 0 })
      part?.scrollIntoView({ block: step?.tab ? 'start' : 'nearest' })
    })
    return () => {
      cancelAnimationFrame(waiting)
      part?.classList.remove('shown-by-guide')
    }
  }, [step])
  const open = guide.value > 0
  useEffect(() => {
    if (!open) return undefined
    const pressed = (event: KeyboardEvent): void => {
      if (event.key === 'Escape') set(guide, 0)
    }
    document.addEventListener('keydown', pressed)
    return () => document.removeEventListener('keydown', pressed)
  }, [open, guide])
  if (!open) return null
  const close = (): void => set(guide, 0)
  return (
    <aside class="guide" ref={card} aria-label={t('What am I looking at?')}>
      <div class="guide-head">
        <h2>{step ? `${guide.value}/${STEPS.length} · ${t(step.title)}` : t('Frame and signs')}</h2>
        <button type="button" class="plain" onClick={close}>
          {t('Close')}
        </button>
      </div>
      {step ? <p>{t((!roomy.value && step.narrow) || step.text)}</p> : <Frame />}
      {guide.value === STEPS.length && (
        <Tours
          take={(tour) => {
            const state = host.service ? tour.state : onThisPage(tour)
            restore(store, { ...stateOf(state), ...kept(store) })
            if (!calm.peek()) clock.play()
            close()
          }}
        />
      )}
      <div class="guide-steps">
        <button
          type="button"
          disabled={guide.value === 1}
          onClick={() => set(guide, Math.max(1, guide.value - 1))}
        >
          <Icon name="back" />
          {t('Back')}
        </button>
        <button
          type="button"
          class="plain"
          aria-pressed={!step}
          onClick={() => set(guide, step ? STEPS.length + 1 : 1)}
        >
          {step ? t('Frame and signs') : t('The guide')}
        </button>
        {guide.value < STEPS.length && (
          <button type="button" class="primary" onClick={() => set(guide, guide.value + 1)}>
            {t('Next')}
            <Icon name="forth" />
          </button>
        )}
      </div>
    </aside>
  )
}

/** What a reader has chosen for all engines. */
function kept({ theme, units, language }: Store): Pick<State, 'theme' | 'units' | 'language'> {
  return { theme: theme.peek(), units: units.peek(), language: language.peek() }
}

/** The words of a drawing, and a letter of a quantity within them. */
const WORDS = /(<(text|title|desc)\b[^>]*>)(.*?)(<\/\2>)/gs
const LETTER = /<tspan class="italic">(\w)<\/tspan>/g
const italic = (letter: string): string => `<tspan class="italic">${letter}</tspan>`

/** The drawing of axes, angles and signs that the documents have, in the language of the page. */
const framed = (): string =>
  frame.replace(WORDS, (_whole, open: string, _name, words: string, close: string) => {
    const sentence = words.replace(LETTER, '{$1}') as '{e}{l}{r}{z}'
    const letters = { e: italic('e'), l: italic('l'), r: italic('r'), z: italic('z') }
    return `${open}${t(sentence, letters)}${close}`
  })

/** The picture of it. */
function Frame() {
  return (
    <img
      class="frame-and-signs"
      src={`data:image/svg+xml,${encodeURIComponent(framed())}`}
      alt={t(
        'The engine from the front: up, right and z toward the viewer; crank angle, bearing and forces clockwise. From the side: the front at the left.',
      )}
    />
  )
}

/** Examples: on a server each at a click, in a file those of its engines; of others the command. */
function Tours({ take }: { take: (tour: Tour) => void }) {
  const { host } = useApp()
  const here = host.exhibition.sources?.join() ?? ''
  const reached = (tour: Tour): boolean => !!host.service || enginesOf(tour).join() === here
  return (
    <>
      <h3>{t('Look at an example')}</h3>
      <ul class="tours">
        {TOURS.map((tour) => (
          <li key={tour.state}>
            {reached(tour) ? (
              <button type="button" class="plain" onClick={() => take(tour)}>
                {t(tour.title)}
              </button>
            ) : (
              <strong>{t(tour.title)}</strong>
            )}
            <span class="soft small">{t(tour.text)}</span>
            {!reached(tour) && (
              <code>{`crankstar page ${enginesOf(tour).join(' --beside ')} -o example.html`}</code>
            )}
          </li>
        ))}
      </ul>
    </>
  )
}
