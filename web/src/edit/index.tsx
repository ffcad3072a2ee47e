import { effect } from '@preact/signals'
import { useEffect, useMemo, useRef } from 'preact/hooks'
import { afterRest } from '../activity'
import type { Service, Tree } from '../host/host'
import { plural, t } from '../language/messages'
import { useBench, Workbench } from './Bench'
import benchCss from './bench.css?inline'
import { CatalogPicker } from './catalog'
import { Provider } from './context'
import css from './edit.css?inline'
import { DropZone, FileButtons } from './files'
import { EngineForm, jump } from './form'
import { keepLast } from './keeping'
import mountsCss from './mounts.css?inline'
import { browserStore, keptNow, Shelf } from './Shelf'
import { Steps } from './Steps'
import { SearchButton } from './search'
import { type OnStage, type Session, type Shown, sessionOf } from './session'

/** The style of the editor, to be adopted by the page beside its own. */
export const editStyle: string = `${css}${benchCss}${mountsCss}`

interface Props {
  readonly service: Service
  readonly engine: OnStage
  /** The units of all numbers, as --units takes them. */
  readonly units?: string
  /** Puts an engine beside the one that is edited. */
  readonly beside?: (tree: Tree) => void
  /** Puts a new engine on the stage. */
  readonly shown: Shown
}

/** Live editing: catalog, form of the engine file, undo, files, and the crank search. */
export function Editor({ service, engine, units = '', beside, shown }: Props) {
  const session = sessionOf(service, engine, shown)
  const root = useRef<HTMLElement>(null)
  const bench = useBench(session, units)
  // drawn once: its fields follow the engine by themselves
  const form = useMemo(() => <EngineForm />, [])
  useEffect(() => session.adopt(engine), [session, engine])
  useEffect(session.load, [session])
  return (
    <Provider value={session}>
      <section class="editor" ref={root} aria-label={t('Editor')} aria-busy={session.busy.value}>
        <CatalogPicker
          label={t('Engine of the catalog')}
          entries={session.catalog.value}
          take={({ name, title }) => void session.open(service.engine(name), title)}
        />
        <div class="bar" role="toolbar" aria-label={t('Edit')}>
          <button
            type="button"
            disabled={!session.canUndo.value}
            onClick={session.undo}
            title="Ctrl+Z"
          >
            {t('Undo')}
          </button>
          <button
            type="button"
            disabled={!session.canRedo.value}
            onClick={session.redo}
            title="Ctrl+Shift+Z"
          >
            {t('Redo')}
          </button>
          <FileButtons />
          <SearchButton />
        </div>
        <p class="note" role="status" tabIndex={-1}>
          {session.note.value}
        </p>
        <NotDone session={session} />
        <Mistakes session={session} root={() => root.current} />
        {beside && <Shelf beside={beside} />}
        <Steps controls={bench?.shown.value?.controls ?? []} />
        {bench && <Workbench bench={bench} />}
        {form}
      </section>
    </Provider>
  )
}

interface Anywhere extends Props {
  /** Called when a file is dropped. */
  readonly opens: () => void
  /** Called with the number of mistakes. */
  readonly slips: (count: number) => void
}

/** Undo keys, dropped files and mistakes on every tab. */
export function EditAnywhere({ service, engine, shown, opens, slips }: Anywhere) {
  const session = sessionOf(service, engine, shown)
  useEffect(() => effect(() => slips(session.problems.value.length)), [session, slips])
  useEffect(() => session.adopt(engine), [session, engine])
  useEffect(() => undoKeys(session), [session])
  useEffect(() => keepingLast(session), [session])
  return (
    <Provider value={session}>
      <DropZone opens={opens} />
    </Provider>
  )
}

/** A request that was refused, and why; scrolled to as soon as it is there. */
function NotDone({ session }: { session: Session }) {
  const box = useRef<HTMLDivElement>(null)
  const refused = session.refused.value
  useEffect(() => box.current?.scrollIntoView({ block: 'center' }), [refused])
  if (!refused) return null
  return (
    <div class="mistakes" role="alert" ref={box}>
      <p>{refused.what}</p>
      <ul>
        {refused.problems.map(({ path, message }) => (
          <li key={`${path} ${message}`}>
            {path && <code>{path}</code>} {message}
          </li>
        ))}
      </ul>
    </div>
  )
}

/** All mistakes, each leading to its field. */
function Mistakes({ session, root }: { session: Session; root: () => HTMLElement | null }) {
  const problems = session.problems.value
  if (!problems.length) return null
  return (
    <div class="mistakes" role="alert">
      <p>
        {plural(
          '{count} mistake. The stage shows the last valid engine until it is corrected.',
          '{count} mistakes. The stage shows the last valid engine until they are corrected.',
          problems.length,
          { count: problems.length },
        )}
      </p>
      <ul>
        {problems.map((problem) => (
          <li key={`${problem.path} ${problem.message}`}>
            {problem.at.length > 0 ? (
              <button
                type="button"
                onClick={() => {
                  const element = root()
                  if (element) jump(element, problem)
                }}
              >
                <code>{problem.path}</code> {problem.message}
              </button>
            ) : (
              problem.message
            )}
          </li>
        ))}
      </ul>
      {problems.some(({ at }) => at[0] === 'firing_order') && (
        <button
          type="button"
          class="way-out"
          onClick={() => session.set(['firing_order'], undefined)}
        >
          {t('Remove the firing order')}
        </button>
      )}
    </div>
  )
}

/** Milliseconds after which an edited engine is kept as the last one. */
const KEPT_AFTER = 1000

/** Keeps the engine that was edited last, to be offered another day. Returns what ends it. */
function keepingLast(session: Session): () => void {
  let callOff = (): void => {}
  const end = effect(() => {
    void session.valid.value
    callOff()
    if (session.canUndo.value)
      callOff = afterRest(() => keepLast(browserStore(), keptNow(session)), KEPT_AFTER)
  })
  return () => {
    end()
    callOff()
  }
}

/** Ctrl+Z, Ctrl+Shift+Z, Ctrl+Y (Cmd on a Mac), except in other text. Returns what ends it. */
function undoKeys(session: Session): () => void {
  const pressed = (event: KeyboardEvent) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return
    const key = event.key.toLowerCase()
    if (key !== 'z' && key !== 'y') return
    const target = event.target instanceof Element ? event.target : null
    const writes = target?.closest('input:not([type=range],[type=checkbox]), textarea')
    if (writes && !writes.closest('.editor .form')) return
    event.preventDefault()
    if (key === 'y' || event.shiftKey) session.redo()
    else session.undo()
  }
  document.addEventListener('keydown', pressed)
  return () => document.removeEventListener('keydown', pressed)
}
