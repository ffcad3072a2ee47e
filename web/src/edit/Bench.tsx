import { useEffect, useState } from 'preact/hooks'
import type { OfferShown } from '../exhibit'
import type { Tree } from '../host/host'
import { plural, t } from '../language/messages'
import { typeset } from '../language/typeset'
import { SHAKES } from '../ui/names'
import { ControlRow, sameBut } from './ControlRow'
import { useSession } from './context'
import { type Bench, benchOf } from './offers'
import { Presets } from './Presets'
import { StageHandles } from './StageHandles'
import { Star } from './Star'
import type { Session } from './session'

/** The bench of the present session, for as long as the panel is open. */
export function useBench(session: Session, units: string): Bench | null {
  const [bench, setBench] = useState<Bench | null>(null)
  useEffect(() => {
    const [made, end] = benchOf(session, () => units)
    setBench(made)
    return end
  }, [session, units])
  return bench
}

/** What one changes first: cylinders, crank, firing order, and the few numbers that matter. */
export function Workbench({ bench }: { bench: Bench }) {
  const session = useSession()
  const shown = bench.shown.value
  return (
    <section class="bench" aria-label={t('Workshop')} aria-busy={bench.busy.value}>
      <details class="folded">
        <summary>{t('Usual layouts')}</summary>
        <Presets bench={bench} />
      </details>
      {!shown && bench.busy.value && (
        <p class="soft awaited" role="status">
          {t('Working out throws, firing orders and sliders …')}
        </p>
      )}
      {shown && <StageHandles controls={shown.controls} />}
      {shown && (
        <>
          <div class="counts">
            <Cylinders bench={bench} />
            <Rotation />
          </div>
          <Decided bench={bench} />
          <div class="turning">
            <Star pins={shown.pins} />
            <Offers
              title={t('Firing order')}
              offers={shown.orders}
              none={t('No firing order fits this crank.')}
            />
          </div>
          {shown.cranks.length > 1 && (
            <Offers title={t('Crank throws')} offers={shown.cranks} none="" />
          )}
          <div class="controls">
            {shown.controls.map((control) => (
              <ControlRow
                key={control.key}
                control={control}
                slider={bench.sliders.value.find(({ key }) => key === control.key)}
                present={sameBut(control, session.tree.value, bench.swept.value)}
              />
            ))}
          </div>
        </>
      )}
      <Remains />
    </section>
  )
}

/** Fewer and more cylinders. */
function Cylinders({ bench }: { bench: Bench }) {
  const shown = bench.shown.value
  if (!shown) return null
  const { cylinders, fewer, more } = shown
  const step = (count: number | null, sign: string, label: string) => (
    <button
      type="button"
      class="round"
      aria-label={label}
      title={label}
      disabled={count === null}
      onClick={() => count !== null && void bench.cylinders(count)}
    >
      {sign}
    </button>
  )
  return (
    <fieldset class="stepper" aria-label={t('Number of cylinders')}>
      {step(
        fewer ?? null,
        '−',
        fewer
          ? plural('{count} cylinder', '{count} cylinders', fewer, { count: fewer })
          : t('fewer cylinders'),
      )}
      <output>
        {plural('{count} cylinder', '{count} cylinders', cylinders, { count: cylinders })}
      </output>
      {step(
        more ?? null,
        '+',
        more
          ? plural('{count} cylinder', '{count} cylinders', more, { count: more })
          : t('more cylinders'),
      )}
    </fieldset>
  )
}

/** The way the crankshaft turns. */
function Rotation() {
  const session = useSession()
  const value = String(session.tree.value.rotation ?? 'clockwise')
  return (
    <label class="rotation">
      <span>{t('Rotation')}</span>
      <select
        value={value}
        onChange={(event) => {
          const rotation = event.currentTarget.value
          session.direct({ ...session.tree.peek(), rotation }, 'rotation')
          session.rest()
        }}
      >
        <option value="clockwise">{t('clockwise')}</option>
        <option value="counter-clockwise">{t('counter-clockwise')}</option>
      </select>
    </label>
  )
}

/** What the engine is, in a sentence, and what was left out on the way. */
function Decided({ bench }: { bench: Bench }) {
  const shown = bench.shown.value
  return (
    <div class="decided" role="status">
      {[...(shown?.sentences.slice(0, 1) ?? []), ...bench.decided.value].map((line) => (
        <p key={line}>{line}</p>
      ))}
    </div>
  )
}

interface OffersProps {
  readonly title: string
  readonly offers: readonly OfferShown[]
  readonly none: string
}

/** Engines one click away. */
function Offers({ title, offers, none }: OffersProps) {
  const session = useSession()
  return (
    <fieldset class="offers">
      <legend>{title}</legend>
      {offers.length === 0 && <p class="help">{none}</p>}
      {offers.map((offer) => (
        <button
          key={offer.label}
          type="button"
          aria-pressed={offer.chosen}
          onClick={() => !offer.chosen && session.edit(offer.tree as Tree)}
        >
          {offer.label}
        </button>
      ))}
    </fieldset>
  )
}

/** What the verdict says of forces, couples and roll of the engine on the stage. */
function Remains() {
  const facts = useSession().verdict.value.filter(({ subject }) => SHAKES.includes(subject))
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls is reached by keys
    <section class="remains" tabIndex={0} aria-label={t('Verdict')}>
      <h3>{t('Verdict')}</h3>
      <ul>
        {facts.map(({ sentence }) => (
          <li key={sentence}>{typeset(sentence)}</li>
        ))}
      </ul>
    </section>
  )
}
