import { useEffect, useId, useRef, useState } from 'preact/hooks'
import type { Problem } from '../exhibit'
import type { Answer, Found, SearchState } from '../host/host'
import { useSession } from './context'
import { type Session, told } from './session'
import { at } from './tree'

/** How often the progress is asked for, milliseconds. */
const EVERY = 250

/** What may be made least, as `crankstar search --minimise` calls it. */
const AIMS: readonly [name: string, what: string][] = [
  ['M1', 'first-order couple'],
  ['M2', 'second-order couple'],
  ['M4', 'fourth-order couple'],
  ['neighbours', 'neighbours that fire one after the other'],
  ['couple', 'couples of all orders together (of an engine)'],
]

/** The fields of the dialog, as they stand in it. */
export interface Asked {
  readonly of: 'engine' | 'number'
  readonly cylinders: string
  readonly cycle: string
  readonly aims: readonly string[]
  readonly more: string
  readonly best: string
  readonly zero: string
  readonly limit: string
  readonly fix: string
  readonly symmetric: boolean
  readonly apart: boolean
}

export const NOTHING_YET: Asked = {
  of: 'engine',
  cylinders: '7',
  cycle: 'two-stroke',
  aims: ['M1', 'M2'],
  more: '',
  best: '',
  zero: '',
  limit: '',
  fix: '',
  symmetric: false,
  apart: false,
}

/** What the keys of a question are called in the dialog. */
const CALLED: Readonly<Record<string, string>> = {
  cylinders: 'Number of cylinders',
  cycle: 'Cycle',
  minimise: 'Make least',
  best: 'How many of the best',
  zero: 'Must vanish',
  limit: 'At most',
  fix: 'Throws that stay',
  symmetric: 'rear half the image of the front half',
  avoid_adjacent: 'no neighbours fire one after the other',
}
const WHOSE = ['cylinders', 'cycle']
const CONDITIONS = ['best', 'zero', 'limit', 'fix', 'symmetric', 'avoid_adjacent']

const keyOf = ({ path }: Problem): string => /^\w+/.exec(path)?.[0] ?? ''

/** The sentences that belong to some keys, with the names that stand in the dialog in place of keys. */
export function sentencesOf(wrong: readonly Problem[], keys: readonly string[]): string[] {
  return wrong.filter((problem) => keys.includes(keyOf(problem))).map(({ message }) => spoken(message))
}

/** Those that belong to nothing in the dialog. */
export function otherSentences(wrong: readonly Problem[]): string[] {
  return wrong
    .filter((problem) => !(keyOf(problem) in CALLED))
    .map(({ path, message }) => (path ? `${path}: ${spoken(message)}` : spoken(message)))
}

const spoken = (message: string): string => message.replace(/`(\w+)`/g, (_, key: string) => `"${CALLED[key] ?? key}"`)

const numbered = (text: string): unknown => (/^\s*\d+\s*$/.test(text) ? Number(text) : text)

/** The wish that the server takes: only what was said, in the words of the command line. */
export function wishOf(asked: Asked): Record<string, unknown> {
  const aims = [...asked.aims, ...asked.more.split(',').map((aim) => aim.trim())].filter(Boolean)
  const limits = asked.limit.split(',').filter((limit) => limit.trim())
  return {
    ...(asked.of === 'number' && { cylinders: numbered(asked.cylinders), cycle: asked.cycle }),
    // the usual couples are left to the server, which leaves out what is the same for all stars of this engine
    ...(aims.length && aims.join() !== NOTHING_YET.aims.join() && { minimise: aims.join(',') }),
    ...(asked.best.trim() && { best: numbered(asked.best) }),
    ...(asked.zero.trim() && { zero: asked.zero.trim() }),
    ...(limits.length && { limit: limits.map((limit) => limit.trim()) }),
    ...(asked.fix.trim() && { fix: asked.fix.trim() }),
    ...(asked.symmetric && { symmetric: true }),
    ...(asked.apart && { avoid_adjacent: true }),
  }
}

/** The button and its dialog. The dialog keeps what was asked and found while the page is open. */
export function SearchButton() {
  const dialog = useRef<HTMLDialogElement>(null)
  return (
    <>
      <button type="button" onClick={() => dialog.current?.showModal()}>
        Find a better crank ...
      </button>
      <dialog class="search" ref={dialog} aria-labelledby="crank-search-title">
        <SearchDialog close={() => dialog.current?.close()} />
      </dialog>
    </>
  )
}

function SearchDialog({ close }: { close: () => void }) {
  const session = useSession()
  const inline = at(session.tree.value, ['layout', 'type']) === 'inline' || session.tree.value.layout === undefined
  const [asked, setAsked] = useState<Asked>(NOTHING_YET)
  const { state, wrong, ending, start, stop } = useSearch(session)
  const now: Asked = inline ? asked : { ...asked, of: 'number' }
  const running = state?.state === 'running'
  return (
    <>
      <header>
        <h2 id="crank-search-title">Find a better crank</h2>
        <button type="button" aria-label="Close" onClick={close}>
          ×
        </button>
      </header>
      <form
        onSubmit={(event) => {
          event.preventDefault()
          void start(now)
        }}
      >
        <Whose
          asked={now}
          wrong={wrong}
          inline={inline}
          name={String(session.tree.value.name ?? '')}
          change={setAsked}
        />
        <Aims asked={now} wrong={wrong} change={setAsked} />
        <Conditions asked={now} wrong={wrong} change={setAsked} />
        <div class="bar">
          <button type="submit" class="chief" disabled={running}>
            Search
          </button>
          {running && (
            <button type="button" disabled={ending} onClick={() => void stop()}>
              {ending ? 'Cancelling ...' : 'Cancel'}
            </button>
          )}
        </div>
      </form>
      <Sentences lines={otherSentences(wrong)} />
      {state && <Answered state={state} put={(found, row) => putOnStage(session, found, row, close)} />}
    </>
  )
}

function putOnStage(session: Session, found: Found, row: number, close: () => void): void {
  session.edit(found.tree)
  session.note.value = `Row ${row} of the search is in the form; undo brings the old engine back.`
  close()
}

/** A search that is asked for, followed and stopped. */
function useSearch(session: Session) {
  const [state, setState] = useState<SearchState | null>(null)
  const [wrong, setWrong] = useState<readonly Problem[]>([])
  const [ending, setEnding] = useState(false)
  const following = useRef('')
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined)
  const { service } = session
  useEffect(() => {
    // a search that nobody waits for any more would keep the processors of others busy
    const leave = () => {
      if (following.current) void told(service.cancelSearch(following.current))
      following.current = ''
      clearTimeout(timer.current)
    }
    window.addEventListener('pagehide', leave)
    return () => {
      window.removeEventListener('pagehide', leave)
      leave()
    }
  }, [service])

  const take = (answer: Answer<SearchState>) => {
    if (!answer.ok) {
      setWrong(answer.problems)
      setState(null)
      following.current = ''
      return
    }
    setState(answer.value)
    following.current = answer.value.state === 'running' ? answer.value.id : ''
    if (following.current) timer.current = setTimeout(() => void follow(answer.value.id), EVERY)
  }
  const follow = async (id: string) => {
    const answer = await told(service.search(id))
    if (following.current === id) take(answer)
  }
  return {
    state,
    wrong,
    ending,
    start: async (asked: Asked) => {
      setWrong([])
      setState(null)
      setEnding(false)
      take(await told(service.startSearch(asked.of === 'engine' ? session.tree.value : null, wishOf(asked))))
    },
    stop: async () => {
      const id = following.current
      clearTimeout(timer.current)
      setEnding(true)
      if (id) take(await told(service.cancelSearch(id)))
    },
  }
}

interface PartProps {
  readonly asked: Asked
  readonly wrong: readonly Problem[]
  readonly change: (asked: Asked) => void
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

function Whose({ asked, wrong, change, inline, name }: PartProps & { inline: boolean; name: string }) {
  return (
    <fieldset>
      <legend>Of</legend>
      <label class="mark">
        <input
          type="radio"
          name="of"
          checked={asked.of === 'engine'}
          disabled={!inline}
          onChange={() => change({ ...asked, of: 'engine' })}
        />
        <span>
          the engine on the stage{name && `: ${name}`}
          {!inline && ' (it is not in line)'}
        </span>
      </label>
      <div class="mark">
        <label class="mark">
          <input
            type="radio"
            name="of"
            checked={asked.of === 'number'}
            onChange={() => change({ ...asked, of: 'number' })}
          />
          a number of cylinders
        </label>
        <input
          type="number"
          aria-label="Number of cylinders"
          min={2}
          max={24}
          value={asked.cylinders}
          onInput={(event) => change({ ...asked, of: 'number', cylinders: event.currentTarget.value })}
        />
        <select
          aria-label="Cycle"
          value={asked.cycle}
          onChange={(event) => change({ ...asked, of: 'number', cycle: event.currentTarget.value })}
        >
          <option value="two-stroke">two-stroke</option>
          <option value="four-stroke">four-stroke</option>
        </select>
      </div>
      <Sentences lines={sentencesOf(wrong, WHOSE)} />
    </fieldset>
  )
}

function Aims({ asked, wrong, change }: PartProps) {
  return (
    <fieldset>
      <legend>Make least</legend>
      {AIMS.filter(([name]) => name !== 'couple' || asked.of === 'engine').map(([name, what]) => (
        <label class="mark" key={name}>
          <input
            type="checkbox"
            checked={asked.aims.includes(name)}
            onChange={(event) => {
              const aims = AIMS.map(([one]) => one).filter((one) =>
                one === name ? event.currentTarget.checked : asked.aims.includes(one),
              )
              change({ ...asked, aims })
            }}
          />
          <span>
            <b>{name}</b> {what}
          </span>
        </label>
      ))}
      <Line label="Others" example="M3, F1, 2*M2" value={asked.more} change={(more) => change({ ...asked, more })} />
      <Sentences lines={sentencesOf(wrong, ['minimise'])} />
    </fieldset>
  )
}

function Conditions({ asked, wrong, change }: PartProps) {
  const lines = (key: string) => sentencesOf(wrong, [key])
  return (
    <details {...(sentencesOf(wrong, CONDITIONS).length > 0 && { open: true })}>
      <summary>Conditions</summary>
      <Line
        label="How many of the best"
        example="all that none betters (the front)"
        value={asked.best}
        wrong={lines('best')}
        change={(best) => change({ ...asked, best })}
      />
      <Line
        label="Must vanish"
        example="M2"
        value={asked.zero}
        wrong={lines('zero')}
        change={(zero) => change({ ...asked, zero })}
      />
      <Line
        label="At most"
        example="M2=1.5, neighbours=1"
        value={asked.limit}
        wrong={lines('limit')}
        change={(limit) => change({ ...asked, limit })}
      />
      <Line
        label="Throws that stay"
        example="1=0,4=3"
        value={asked.fix}
        wrong={lines('fix')}
        change={(fix) => change({ ...asked, fix })}
      />
      <label class="mark">
        <input
          type="checkbox"
          checked={asked.symmetric}
          onChange={(event) => change({ ...asked, symmetric: event.currentTarget.checked })}
        />
        rear half the image of the front half
      </label>
      <label class="mark">
        <input
          type="checkbox"
          checked={asked.apart}
          onChange={(event) => change({ ...asked, apart: event.currentTarget.checked })}
        />
        no neighbours fire one after the other
      </label>
      <Sentences lines={sentencesOf(wrong, ['symmetric', 'avoid_adjacent'])} />
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

const TOLD = { running: 'Searching', done: 'Done', cancelled: 'Cancelled', failed: 'The search broke off' }

/** Progress, then the rows. */
function Answered({ state, put }: { state: SearchState; put: (found: Found, row: number) => void }) {
  const share = state.blocks > 0 ? state.done / state.blocks : 0
  const running = state.state === 'running'
  return (
    <div class="answer">
      <p role="status">
        {TOLD[state.state]}
        {running && ` ${Math.floor(100 * share)} %`}
        {state.note && `: ${state.note}`}
      </p>
      {running && <progress aria-label="Progress of the search" max={1} {...(state.blocks > 0 && { value: share })} />}
      {state.rows.length > 0 && (
        <div class="scrolls">
          <table>
            <thead>
              <tr>
                {state.heads.map((head) => (
                  <th key={head} scope="col">
                    {head || <span class="aside">row</span>}
                  </th>
                ))}
                <th scope="col">
                  <span class="aside">Engine</span>
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
                      aria-label={`Put on the stage: row ${index + 1}`}
                      onClick={() => put(row, index + 1)}
                    >
                      Put on the stage
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
