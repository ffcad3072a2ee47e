import { useId, useRef, useState } from 'preact/hooks'
import { begin } from '../activity'
import type { Fitting } from '../host/host'
import { message, t } from '../language/messages'
import { Switch } from '../Switch'
import { useSession } from './context'
import { answered } from './session'

const WEIGHTS = {
  pins: message('opposite each pin'),
  webs: message('on the webs'),
  ends: message('at the ends'),
} as const satisfies Record<NonNullable<Fitting['weights']>, string>
const SHAFTS = {
  none: message('none'),
  needed: message('where needed'),
  all: message('for all remaining orders'),
} as const satisfies Record<NonNullable<Fitting['shafts']>, string>

/** Puts counterweights and balance shafts on the engine; its file keeps its form. */
export function Fit() {
  const session = useSession()
  const id = useId()
  const [factor, setFactor] = useState('')
  const [weights, setWeights] = useState<keyof typeof WEIGHTS | ''>('')
  const [shafts, setShafts] = useState<keyof typeof SHAFTS | ''>('')
  const [bare, setBare] = useState(false)
  const [busy, setBusy] = useState(false)
  const root = useRef<HTMLDivElement>(null)

  const fit = async () => {
    const note = root.current?.closest('.editor')?.querySelector<HTMLElement>('.note')
    const share = Number(factor.trim().replace(',', '.'))
    if (!Number.isFinite(share)) {
      session.note.value = t('Balance factor: “{factor}” is not a number. Type one, as in 0.5.', {
        factor,
      })
      if (note) lookAt(note)
      return
    }
    const options: Fitting = {
      ...(factor.trim() && { factor: share }),
      ...(weights && { weights }),
      ...(shafts && { shafts }),
      ...(bare && { bare }),
    }
    setBusy(true)
    const answer = await answered(session.service.fitted(session.tree.value, options))
    setBusy(false)
    if (!answer.ok) {
      session.note.value = ''
      session.refused.value = { what: t('The engine was not fitted.'), problems: answer.problems }
    } else if (answer.value === null)
      session.note.value = t('Weights and shafts would not reduce the unbalance.')
    else {
      session.edit(answer.value)
      session.note.value = t('Fitted. The engine file now lists every weight; Undo removes them.')
    }
    if (note) lookAt(note)
  }

  return (
    <div class="fit" ref={root}>
      <p class="help">
        {t(
          'Fits counterweights, beside those that the engine has, and balance shafts. The engine file then lists every weight.',
        )}
      </p>
      <div>
        <label for={id}>{t('Balance factor')}</label>
        <input
          id={id}
          type="text"
          inputMode="decimal"
          placeholder={t('best')}
          autocomplete="off"
          value={factor}
          onInput={(event) => setFactor(event.currentTarget.value)}
        />
      </div>
      <Choice label={t('Counterweights')} names={WEIGHTS} value={weights} choose={setWeights} />
      <Switch label={t('Replace the counterweights of the engine')} on={bare} change={setBare} />
      <Choice label={t('Balance shafts')} names={SHAFTS} value={shafts} choose={setShafts} />
      <button type="button" disabled={busy} onClick={() => void fit()}>
        {t('Fit')}
      </button>
    </div>
  )
}

/** Scrolls to the note at the head of the form, which is far from the button and has changed. */
function lookAt(note: HTMLElement): void {
  note.focus({ preventScroll: true })
  // Once the new form stands: the browser holds on to the old place until then.
  const end = begin()
  requestAnimationFrame(() =>
    requestAnimationFrame(() => {
      note.scrollIntoView({ block: 'center' })
      end()
    }),
  )
}

interface ChoiceProps<T extends string> {
  readonly label: string
  readonly names: Readonly<Record<T, string>>
  /** Empty for the recommendation of the verdict. */
  readonly value: T | ''
  readonly choose: (value: T | '') => void
}

function Choice<T extends string>({ label, names, value, choose }: ChoiceProps<T>) {
  const id = useId()
  return (
    <div>
      <label for={id}>{label}</label>
      <select
        id={id}
        value={value}
        onChange={(event) => choose(event.currentTarget.value as T | '')}
      >
        <option value="">{t('recommended')}</option>
        {(Object.keys(names) as T[]).map((each) => (
          <option key={each} value={each}>
            {t(String(names[each]))}
          </option>
        ))}
      </select>
    </div>
  )
}
