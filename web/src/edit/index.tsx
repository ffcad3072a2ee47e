import { useEffect, useMemo, useRef } from 'preact/hooks'
import type { Exhibit } from '../exhibit'
import type { Service, Tree } from '../host/host'
import { CatalogPicker } from './catalog'
import { Provider } from './context'
import css from './edit.css?inline'
import { DropZone, FileButtons } from './files'
import { EngineForm, jump } from './form'
import { SearchButton } from './search'
import { type Session, sessionOf } from './session'

/** The style of the editor, to be adopted by the page beside its own. */
export const editStyle: string = css

interface Props {
  readonly service: Service
  /** Engine file of the engine on the stage. */
  readonly tree: Tree
  /** Puts a new engine on the stage. */
  readonly shown: (exhibit: Exhibit, tree: Tree) => void
}

/** Live editing: the catalog, the form of the engine file, undo, files, and the search for a better crank. */
export function Editor({ service, tree, shown }: Props) {
  const session = sessionOf(service, tree, shown)
  const root = useRef<HTMLElement>(null)
  // drawn once: its fields follow the engine by themselves
  const form = useMemo(() => <EngineForm />, [])
  useEffect(() => session.adopt(tree), [session, tree])
  useEffect(session.load, [session])
  return (
    <Provider value={session}>
      <section class="editor" ref={root} aria-label="Editor" aria-busy={session.busy.value}>
        <CatalogPicker />
        <div class="bar" role="toolbar" aria-label="Edit">
          <button type="button" disabled={!session.canUndo.value} onClick={session.undo} title="Ctrl+Z">
            Undo
          </button>
          <button type="button" disabled={!session.canRedo.value} onClick={session.redo} title="Ctrl+Shift+Z">
            Redo
          </button>
          <FileButtons />
          <SearchButton />
        </div>
        <p class="note" role="status" tabIndex={-1}>
          {session.note.value}
        </p>
        <NotDone session={session} />
        <Mistakes session={session} root={() => root.current} />
        {form}
      </section>
    </Provider>
  )
}

/** What editing does whichever tab is open: undo by keys, and a file that is dropped; `opens` is called when it is. */
export function EditAnywhere({ service, tree, shown, opens }: Props & { opens: () => void }) {
  const session = sessionOf(service, tree, shown)
  useEffect(() => session.adopt(tree), [session, tree])
  useEffect(() => undoKeys(session), [session])
  return (
    <Provider value={session}>
      <DropZone opens={opens} />
    </Provider>
  )
}

/** What was asked for and not done, and why; it is looked at as soon as it is there. */
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

/** All that is wrong, each a way to where it is. */
function Mistakes({ session, root }: { session: Session; root: () => HTMLElement | null }) {
  const problems = session.problems.value
  if (!problems.length) return null
  return (
    <div class="mistakes" role="alert">
      <p>
        {problems.length === 1 ? '1 mistake' : `${problems.length} mistakes`}. The stage shows the engine as it was
        before, until {problems.length === 1 ? 'it is' : 'they are'} mended.
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
        <button type="button" class="way-out" onClick={() => session.set(['firing_order'], undefined)}>
          Leave the firing order out
        </button>
      )}
    </div>
  )
}

/** Ctrl+Z and Ctrl+Shift+Z (Cmd on a Mac, Ctrl+Y too) anywhere on the page, but in text that is not the form's. Returns what ends it. */
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
