import { useRef, useState } from 'preact/hooks'
import { counted } from '../activity'
import type { Exhibit } from '../exhibit'
import type { Tree } from '../host/host'
import { language, plural, t } from '../language/messages'
import { choiceText } from './choices'
import { useSession } from './context'
import {
  exported,
  imported,
  type Kept,
  keep,
  keptIn,
  type Likeness,
  lastIn,
  MOST,
  type Store,
  type Trouble,
  withEngine,
  withName,
  without,
} from './keeping'
import { Picture } from './Presets'
import type { Session } from './session'

const LARGEST = 5_000_000

/** The browser's store, null where a page may have none. */
export function browserStore(): Store | null {
  try {
    return window.localStorage
  } catch {
    return null
  }
}

/** What a small picture of an engine on the stage shows. */
export function likenessOf(scene: Exhibit['scene'] | undefined): Likeness {
  const degrees = (angle: number): number => Math.round((angle * 180000) / Math.PI) / 1000
  const { cylinders = [], shafts = [] } = scene ?? {}
  const axes = [...new Set(cylinders.map(({ bearing }) => degrees(bearing)))]
  const pins = shafts.flatMap(({ throws }) => throws.map(({ angle }) => degrees(angle)))
  return { axes_deg: axes, throws_deg: pins, radial: axes.length > 4 && pins.length === 1 }
}

/** The engine of a session, to be kept. */
export function keptNow(session: Session): Kept {
  const { valid, scene } = session
  const tree = valid.peek()
  const count = scene?.cylinders.length ?? 0
  const layout = (tree.layout as { type?: unknown } | undefined)?.type ?? 'explicit'
  return {
    id: `${Date.now()}`,
    name: String(tree.name ?? ''),
    at: new Date().toISOString(),
    summary: `${layout}, ${count}`,
    likeness: likenessOf(scene),
    tree,
  }
}

function sentenceOf(trouble: Trouble): string {
  return trouble === 'full'
    ? t('The browser’s store is full: delete kept engines, or export and delete them.')
    : t('The browser does not let this page keep anything. Save the engine as TOML instead.')
}

interface Props {
  /** Puts an engine beside the one that is edited. */
  readonly beside: (tree: Tree) => void
}

/** Engines that are kept in the browser. */
export function Shelf({ beside }: Props) {
  const session = useSession()
  const [store] = useState(browserStore)
  const [engines, setEngines] = useState(() => keptIn(store))
  const [gone, setGone] = useState<readonly Kept[] | null>(null)
  const [said, setSaid] = useState('')
  const [naming, setNaming] = useState('')
  const [last] = useState(() => lastIn(store))

  const change = (next: Kept[], done: string): void => {
    const trouble = keep(store, next)
    if (!trouble) setEngines(next)
    setSaid(trouble ? sentenceOf(trouble) : done)
  }
  const open = (engine: Kept): void => {
    session.replace(engine.tree)
    session.note.value = t('{what} is now in the form.', { what: engine.name })
  }
  const takeIn = async (file: File): Promise<void> => {
    const more = file.size > LARGEST ? null : imported(await counted(file.text()), Date.now())
    const taken = more?.slice(0, Math.max(0, MOST - engines.length)) ?? []
    if (!more?.length)
      setSaid(t('{file} is no file of kept engines.', { file: file.name.slice(0, 80) }))
    else
      change(
        [...taken, ...engines],
        [
          plural('{count} engine was added.', '{count} engines were added.', taken.length, {
            count: taken.length,
          }),
          ...(taken.length < more.length
            ? [
                t('{count} do not fit: at most {most} are kept.', {
                  count: more.length - taken.length,
                  most: MOST,
                }),
              ]
            : []),
        ].join(' '),
      )
  }
  const isOther = last !== null && last.name !== session.tree.value.name
  return (
    <details class="folded shelf">
      <summary>{t('Kept engines ({count})', { count: engines.length })}</summary>
      <div class="within">
        <div class="bar">
          <button
            type="button"
            onClick={() => {
              setGone(null)
              change(withEngine(engines, keptNow(session)), t('Kept in this browser.'))
            }}
          >
            {t('Keep this engine')}
          </button>
          {isOther && (
            <button type="button" onClick={() => open(last)}>
              {t('Your last engine: {name}', { name: last.name.slice(0, 60) })}
            </button>
          )}
          {engines.length > 0 && (
            <button type="button" onClick={() => download(exported(engines))}>
              {t('Export all')}
            </button>
          )}
          <Import take={(file) => void takeIn(file)} />
        </div>
        <p role="status" class="help">
          {said}{' '}
          {gone && (
            <button
              type="button"
              onClick={() => {
                change([...gone], t('It is back.'))
                setGone(null)
              }}
            >
              {t('Undo the deletion')}
            </button>
          )}
        </p>
        <ul>
          {engines.map((engine) => (
            <li key={engine.id}>
              <Picture of={engine.likeness} />
              {naming === engine.id ? (
                <Name
                  name={engine.name}
                  named={(name) => {
                    setNaming('')
                    if (name) change(withName(engines, engine.id, name), '')
                  }}
                />
              ) : (
                <span class="kept">
                  <b>{engine.name}</b>
                  <span class="facts">{`${summaryText(engine)} · ${dateOf(engine.at)}`}</span>
                </span>
              )}
              <span class="bar">
                <Act does={() => open(engine)} word={t('Open')} name={engine.name} />
                <Act does={() => beside(engine.tree)} word={t('Beside')} name={engine.name} />
                <Act does={() => setNaming(engine.id)} word={t('Rename')} name={engine.name} />
                <Act
                  does={() => {
                    setGone(engines)
                    change(without(engines, engine.id), t('Deleted.'))
                  }}
                  word={t('Delete')}
                  name={engine.name}
                />
              </span>
            </li>
          ))}
        </ul>
      </div>
    </details>
  )
}

function Act({ does, word, name }: { does: () => void; word: string; name: string }) {
  return (
    <button type="button" aria-label={`${word}: ${name}`} onClick={does}>
      {word}
    </button>
  )
}

function Name({ name, named }: { name: string; named: (name: string) => void }) {
  return (
    <input
      type="text"
      aria-label={t('Name')}
      value={name}
      ref={(box) => box?.focus()}
      onBlur={(event) => named(event.currentTarget.value.trim())}
      onKeyDown={(event) => {
        if (event.key === 'Enter') named(event.currentTarget.value.trim())
        if (event.key === 'Escape') named('')
      }}
    />
  )
}

function Import({ take }: { take: (file: File) => void }) {
  const chooser = useRef<HTMLInputElement>(null)
  return (
    <>
      <button type="button" onClick={() => chooser.current?.click()}>
        {t('Import …')}
      </button>
      <input
        ref={chooser}
        type="file"
        class="unseen"
        accept=".json,application/json"
        aria-label={t('File of kept engines to import')}
        tabIndex={-1}
        onChange={(event) => {
          const file = event.currentTarget.files?.[0]
          if (file) take(file)
          event.currentTarget.value = ''
        }}
      />
    </>
  )
}

function download(text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: 'application/json' }))
  const link = document.createElement('a')
  link.href = address
  link.download = 'crankstar-engines.json'
  link.click()
  setTimeout(() => URL.revokeObjectURL(address), 10_000)
}

/** Layout and number of cylinders; the layout is kept as the engine file names it. */
function summaryText({ summary }: Kept): string {
  const [layout = '', ...more] = summary.split(', ')
  return [choiceText(layout), ...more].join(', ')
}

function dateOf(at: string): string {
  const date = new Date(at)
  return Number.isNaN(date.getTime())
    ? ''
    : date.toLocaleString(language.value, { dateStyle: 'medium', timeStyle: 'short' })
}
