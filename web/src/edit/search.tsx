import { useId, useRef, useState } from 'preact/hooks'
import type { Found, Problem, SearchShown } from '../exhibit'
import { message, t } from '../language/messages'
import { Switch } from '../Switch'
import { useSession } from './context'
import {
  CONSTRAINTS,
  EMPTY,
  OBJECTIVES,
  otherSentences,
  type SearchForm,
  SUBJECT,
  sentencesOf,
} from './searchForm'
import { useSearch } from './searchRun'
import type { Session } from './session'
import { at } from './tree'

/** The button and its dialog. The dialog keeps its fields and results while the page is open. */
export function SearchButton() {
  const dialog = useRef<HTMLDialogElement>(null)
  return (
    <>
      <button type="button" onClick={() => dialog.current?.showModal()}>
        {t('Find a better crank …')}
      </button>
      <dialog class="search" ref={dialog} aria-labelledby="crank-search-title">
        <SearchDialog close={() => dialog.current?.close()} />
      </dialog>
    </>
  )
}

function SearchDialog({ close }: { close: () => void }) {
  const session = useSession()
  const { layout, name } = session.tree.value
  const inline = at(layout, ['type']) === 'inline' || layout === undefined
  const [fields, setFields] = useState<SearchForm>(EMPTY)
  const { state, problems, ending, start, stop } = useSearch(session)
  const form: SearchForm = inline ? fields : { ...fields, of: 'number' }
  const part = {
    form,
    problems,
    change: (fields: Partial<SearchForm>) => setFields({ ...form, ...fields }),
  }
  const running = state?.state === 'running'
  return (
    <>
      <header>
        <h2 id="crank-search-title">{t('Find a better crank')}</h2>
        <button type="button" aria-label={t('Close')} onClick={close}>
          ×
        </button>
      </header>
      <form
        onSubmit={(event) => {
          event.preventDefault()
          void start(form)
        }}
      >
        <Subject {...part} inline={inline} name={String(name ?? '')} />
        <Objectives {...part} />
        <Constraints {...part} />
        <div class="bar">
          <button type="submit" class="primary" disabled={running}>
            {t('Search')}
          </button>
          {running && (
            <button type="button" disabled={ending} onClick={() => void stop()}>
              {ending ? t('Cancelling …') : t('Cancel')}
            </button>
          )}
        </div>
      </form>
      <Sentences lines={otherSentences(problems)} />
      {state && (
        <Results state={state} put={(row, number) => putOnStage(session, row, number, close)} />
      )}
    </>
  )
}

function putOnStage(session: Session, row: Found, number: number, close: () => void): void {
  session.replace(row.tree)
  session.note.value = t('Row {number} is now in the form. Undo restores the previous engine.', {
    number,
  })
  close()
}

interface PartProps {
  readonly form: SearchForm
  readonly problems: readonly Problem[]
  readonly change: (fields: Partial<SearchForm>) => void
}

function Sentences({ lines, id }: { lines: readonly string[]; id?: string }) {
  if (!lines.length) return null
  return (
    <div class="sentences" role="alert" id={id}>
      {lines.map((line) => (
        <p key={line}>{line}</p>
      ))}
    </div>
  )
}

function Subject({
  form,
  problems,
  change,
  inline,
  name,
}: PartProps & { inline: boolean; name: string }) {
  return (
    <fieldset>
      <legend>{t('Engine')}</legend>
      <label class="mark">
        <input
          type="radio"
          name="of"
          checked={form.of === 'engine'}
          disabled={!inline}
          onChange={() => change({ of: 'engine' })}
        />
        <span>
          {inline
            ? t('the engine in the form: {name}', { name })
            : t('the engine in the form: {name} (only in-line engines can be searched)', { name })}
        </span>
      </label>
      <div class="mark">
        <label class="mark">
          <input
            type="radio"
            name="of"
            checked={form.of === 'number'}
            onChange={() => change({ of: 'number' })}
          />
          {t('an in-line engine with this number of cylinders:')}
        </label>
        <input
          type="number"
          aria-label={t('Number of cylinders')}
          min={2}
          max={24}
          value={form.cylinders}
          onInput={(event) => change({ of: 'number', cylinders: event.currentTarget.value })}
        />
        <select
          aria-label={t('Cycle')}
          value={form.cycle}
          onChange={(event) => change({ of: 'number', cycle: event.currentTarget.value })}
        >
          <option value="two-stroke">{t('two-stroke')}</option>
          <option value="four-stroke">{t('four-stroke')}</option>
        </select>
      </div>
      <Sentences lines={sentencesOf(problems, SUBJECT)} />
    </fieldset>
  )
}

function Objectives({ form, problems, change }: PartProps) {
  return (
    <fieldset>
      <legend>{t('Minimise')}</legend>
      {OBJECTIVES.filter(([name]) => name !== 'couple' || form.of === 'engine').map(
        ([name, meaning]) => (
          <Switch
            key={name}
            class="mark"
            label={
              <>
                <b>{name}</b> {t(meaning)}
              </>
            }
            on={form.objectives.includes(name)}
            change={(on) => {
              const chosen = (other: string) =>
                other === name ? on : form.objectives.includes(other)
              change({ objectives: OBJECTIVES.map(([other]) => other).filter(chosen) })
            }}
          />
        ),
      )}
      <Line
        label={t('Others')}
        example="M3, F1, 2*M2"
        value={form.more}
        change={(more) => change({ more })}
      />
      <Sentences lines={sentencesOf(problems, ['minimise'])} />
    </fieldset>
  )
}

const LINES = [
  ['best', message('Number of results'), message('all that no other star surpasses')],
  ['zero', message('Must be zero'), 'M2'],
  ['limit', message('Limits'), 'M2=1.5, neighbours=1'],
  ['fix', message('Fixed throws'), '1=0,4=3'],
] as const
const MARKS = [
  ['symmetric', message('the rear half mirrors the front half')],
  ['apart', message('no adjacent cylinders fire in succession')],
] as const

function Constraints({ form, problems, change }: PartProps) {
  const wrong = sentencesOf(problems, CONSTRAINTS).length > 0
  return (
    <details {...(wrong && { open: true })}>
      <summary>{t('Constraints')}</summary>
      {LINES.map(([key, label, example]) => (
        <Line
          key={key}
          label={t(label)}
          example={t(example)}
          value={form[key]}
          wrong={sentencesOf(problems, [key])}
          change={(value) => change({ [key]: value })}
        />
      ))}
      {MARKS.map(([key, label]) => (
        <Switch
          key={key}
          class="mark"
          label={t(label)}
          on={form[key]}
          change={(on) => change({ [key]: on })}
        />
      ))}
      <Sentences lines={sentencesOf(problems, ['symmetric', 'avoid_adjacent'])} />
    </details>
  )
}

interface LineProps {
  readonly label: string
  readonly example: string
  readonly value: string
  readonly wrong?: readonly string[]
  readonly change: (value: string) => void
}

function Line({ label, example, value, wrong = [], change }: LineProps) {
  const id = useId()
  return (
    <>
      <label class="line">
        <span>{label}</span>
        <input
          type="text"
          placeholder={example}
          autocomplete="off"
          spellcheck={false}
          value={value}
          aria-invalid={wrong.length > 0}
          {...(wrong.length > 0 && { 'aria-describedby': id })}
          onInput={(event) => change(event.currentTarget.value)}
        />
      </label>
      <Sentences lines={wrong} id={id} />
    </>
  )
}

const STATE = {
  running: message('Searching: {percent} %'),
  done: message('Search complete.'),
  cancelled: message('Cancelled.'),
  failed: message('The search failed.'),
} as const satisfies Record<SearchShown['state'], string>

/** Progress, then the rows. */
function Results({
  state,
  put,
}: {
  state: SearchShown
  put: (row: Found, number: number) => void
}) {
  const share = state.blocks > 0 ? state.done / state.blocks : 0
  const running = state.state === 'running'
  return (
    <div class="answer">
      <p role="status">
        {t(STATE[state.state], { percent: Math.floor(100 * share) })} {state.note}
      </p>
      {running && (
        <progress
          aria-label={t('Progress of the search')}
          max={1}
          {...(state.blocks > 0 && { value: share })}
        />
      )}
      {state.rows.length > 0 && (
        <div class="scroll">
          <table>
            <thead>
              <tr>
                {state.heads.map((head) => (
                  <th key={head} scope="col">
                    {head || <span class="unseen">{t('row')}</span>}
                  </th>
                ))}
                <th scope="col">
                  <span class="unseen">{t('Engine')}</span>
                </th>
              </tr>
            </thead>
            <tbody>
              {state.rows.map((row, index) => (
                <tr key={row.cells.join(' ')}>
                  {row.cells.map((cell, place) => (
                    <td key={place}>{cell}</td>
                  ))}
                  <td>
                    <button
                      type="button"
                      aria-label={t('Put row {number} on the stage', { number: index + 1 })}
                      onClick={() => put(row, index + 1)}
                    >
                      {t('Put on the stage')}
                    </button>
                  </td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      {state.sentences.map((line) => (
        <p key={line}>{line}</p>
      ))}
    </div>
  )
}
