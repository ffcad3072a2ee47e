import { useId, useRef, useState } from 'preact/hooks'
import type { Fitting } from '../host/host'
import { useSession } from './context'
import { told } from './session'

const WEIGHTS: Record<string, Fitting['weights']> = {
  'opposite each pin': 'pins',
  'on the webs': 'webs',
  'at the ends': 'ends',
}
const SHAFTS: Record<string, Fitting['shafts']> = {
  none: 'none',
  'where needed': 'needed',
  'for all that is left': 'all',
}
const FACTOR = 'Balance factor to fit'
const ADVISED = 'as its verdict advises'

/** Puts counterweights and balance shafts on the engine; what it becomes has every weight in it (explicit form). */
export function Fit() {
  const session = useSession()
  const id = useId()
  const [factor, setFactor] = useState('')
  const [weights, setWeights] = useState(ADVISED)
  const [shafts, setShafts] = useState(ADVISED)
  const [busy, setBusy] = useState(false)
  const root = useRef<HTMLDivElement>(null)

  const fit = async () => {
    const note = root.current?.closest('.editor')?.querySelector<HTMLElement>('.note')
    const share = Number(factor.trim().replace(',', '.'))
    if (!Number.isFinite(share)) {
      session.note.value = `${FACTOR}: “${factor}” is no number; give one as in 0.5, or leave it empty for the best.`
      if (note) lookAt(note)
      return
    }
    const at = WEIGHTS[weights]
    const which = SHAFTS[shafts]
    const options: Fitting = {
      ...(factor.trim() && { factor: share }),
      ...(at && { weights: at }),
      ...(which && { shafts: which }),
    }
    setBusy(true)
    const answer = await told(session.service.fitted(session.tree.value, options))
    setBusy(false)
    if (!answer.ok) {
      const problems = answer.problems.map((one) => (one.path === 'factor' ? { ...one, path: FACTOR } : one))
      session.note.value = ''
      session.refused.value = { what: 'The engine could not be fitted; it stays as it is.', problems }
    } else if (answer.value === null)
      session.note.value = 'There is nothing to fit: weights and shafts would take nothing away.'
    else {
      session.edit(answer.value)
      session.note.value =
        'Fitted. The engine is in the explicit form now, weight by weight; undo takes them off again.'
    }
    if (note) lookAt(note)
  }

  return (
    <div class="fit" ref={root}>
      <p class="help">
        Weights and shafts that take away what they can. The engine is then in the explicit form, weight by weight.
      </p>
      <div>
        <label for={id}>{FACTOR}</label>
        <input
          id={id}
          type="text"
          inputMode="decimal"
          placeholder="the best"
          autocomplete="off"
          value={factor}
          onInput={(event) => setFactor(event.currentTarget.value)}
        />
      </div>
      <Choice label="Counterweights" among={Object.keys(WEIGHTS)} value={weights} choose={setWeights} />
      <Choice label="Balance shafts" among={Object.keys(SHAFTS)} value={shafts} choose={setShafts} />
      <button type="button" disabled={busy} onClick={() => void fit()}>
        Fit
      </button>
    </div>
  )
}

/** What was done is told at the head of the form, far from the button, and the form is another one then: go there. */
function lookAt(note: HTMLElement): void {
  note.focus({ preventScroll: true })
  // Once the new form stands: the browser holds on to the old place until then.
  requestAnimationFrame(() => requestAnimationFrame(() => note.scrollIntoView({ block: 'center' })))
}

interface ChoiceProps {
  readonly label: string
  readonly among: readonly string[]
  readonly value: string
  readonly choose: (value: string) => void
}

function Choice({ label, among, value, choose }: ChoiceProps) {
  const id = useId()
  return (
    <div>
      <label for={id}>{label}</label>
      <select id={id} value={value} onChange={(event) => choose(event.currentTarget.value)}>
        {[ADVISED, ...among].map((one) => (
          <option key={one} value={one}>
            {one}
          </option>
        ))}
      </select>
    </div>
  )
}
