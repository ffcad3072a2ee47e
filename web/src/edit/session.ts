import { batch, computed, type ReadonlySignal, type Signal, signal } from '@preact/signals'
import { counted } from '../activity'
import type { CatalogEntry, Exhibit, Fact, Problem } from '../exhibit'
import type { Answer, Service, Tree } from '../host/host'
import { t } from '../language/messages'
import { reasonOf } from '../reason'
import { changes } from './changes'
import { withoutOrder } from './control'
import { after, begun, type History } from './history'
import { latest } from './latest'
import { renamed } from './naming'
import { type Form, formOf, forms } from './schema'
import { withoutSources } from './sources'
import { withWeightsAlong } from './throws'
import { at, type Path, put, read, same, within } from './tree'

/** Puts a valid engine on the stage. */
export type Shown = (exhibit: Exhibit, tree: Tree) => void

/** What the form knows of the engine on the stage. */
export type OnStage = Pick<Exhibit, 'file' | 'relative' | 'weight_throws'> & {
  readonly verdict?: readonly Fact[]
  readonly scene?: Exhibit['scene']
  readonly whirl?: Exhibit['whirl']
}

/** A mistake and the place in the engine file that it is about. */
export interface Placed extends Problem {
  readonly at: Path
}

export interface Refused {
  readonly what: string
  readonly problems: readonly Problem[]
}

/**
 * The engine file that is being edited: what is in the form, valid or not, with its history; the
 * engine on the stage is the last valid one. It outlives the form, so that a look at another tab
 * loses nothing.
 */
export interface Session {
  readonly service: Service
  readonly tree: ReadonlySignal<Tree>
  readonly form: ReadonlySignal<Form | undefined>
  readonly forms: Signal<readonly Form[]>
  readonly catalog: Signal<readonly CatalogEntry[]>
  readonly problems: Signal<readonly Placed[]>
  /** A request that was refused, and why; the form itself has no mistake. */
  readonly refused: Signal<Refused | null>
  readonly busy: Signal<boolean>
  /** What is not known of the engine on the stage, and so counted in its own unit. */
  readonly relative: Exhibit['relative']
  /** The engine on the stage as it is drawn. */
  readonly scene: Exhibit['scene'] | undefined
  /** Its mass and centre, given or estimated. */
  readonly whirl: Exhibit['whirl'] | undefined
  /** What was done or went wrong last, for everyone to see and hear. */
  readonly note: Signal<string>
  /** The engine on the stage: the last that was valid, and what its verdict says. */
  readonly valid: ReadonlySignal<Tree>
  readonly verdict: ReadonlySignal<readonly Fact[]>
  /** All steps, done and undone, and the place of the present one. */
  readonly steps: ReadonlySignal<{ readonly all: readonly Tree[]; readonly at: number }>
  readonly canUndo: ReadonlySignal<boolean>
  readonly canRedo: ReadonlySignal<boolean>
  /** Puts another engine file in place of this one. Edits of one gesture are one step of undo. */
  edit(to: Tree, gesture?: string): void
  /** Puts another engine in place of this one, under its own name. */
  replace(to: Tree): void
  /**
   * The same for a direct control: its steps go on until it rests, and a firing order that no
   * longer fits is left out.
   */
  direct(to: Tree, control: string): void
  /** To a step of `steps`. */
  goTo(step: number): void
  set(path: Path, value: unknown, gesture?: string): void
  /** Ends a gesture: the next edit is a step of its own. */
  rest(): void
  undo(): void
  redo(): void
  /** Asks for what the form is made of, if that was not done. */
  load(): void
  /** Takes over the engine that was put on the stage by others. */
  adopt(engine: OnStage): void
  /** Edits the engine to that of an answer, or shows its faults. Returns whether it was one. */
  open(answer: Promise<Answer<Tree>>, what: string): Promise<boolean>
  /** What may change from one drawing of the shell to the next. */
  shown: Shown
}

/** A gesture that begins with this leaves out a firing order that does not fit. */
const DIRECT = 'direct '
/** A gesture that begins with this is typing, which a pause ends, milliseconds. */
export const TYPING = 'type '
const PAUSE = 1000

/** A session that begins with an engine. */
export function session(service: Service, engine: OnStage, shown: Shown): Session {
  const history = signal<History<Tree>>(begun(engine.file))
  const present = computed(() => history.value.present)
  const allForms = signal<readonly Form[]>([])
  const catalog = signal<readonly CatalogEntry[]>([])
  const problems = signal<readonly Placed[]>([])
  const refused = signal<Refused | null>(null)
  const busy = signal(false)
  const note = signal('')
  const valid = signal<Tree>(engine.file)
  const verdict = signal<readonly Fact[]>(engine.verdict ?? [])
  const origins = new Set<unknown>([engine.file.name])
  let onStage = engine
  let lastEdit = 0
  let loading = false

  const live = latest<Tree, Exhibit>({
    send: (subject, abort) => service.exhibit(subject, abort),
    answered: (answer, subject, newest) => {
      if (answer.ok) {
        onStage = answer.value
        batch(() => {
          valid.value = subject
          verdict.value = answer.value.verdict ?? []
          self.shown(answer.value, subject)
        })
      } else if (newest && leftOut(answer.problems, subject)) return
      const wrong = answer.ok ? [] : placed(answer.problems)
      if (newest && (wrong.length || problems.peek().length)) problems.value = wrong
    },
    waiting: (now) => {
      busy.value = now
    },
  })

  /** Leaves out a firing order that a direct control made impossible. */
  function leftOut(found: readonly Problem[], subject: Tree): boolean {
    const { gesture, present: now } = history.peek()
    const order = found.every(({ path }) => path.startsWith('firing_'))
    if (!order || now !== subject || !gesture?.startsWith(DIRECT)) return false
    const rest = withoutOrder(subject)
    if (rest === subject) return false
    move({ kind: 'edit', to: rest, gesture })
    note.value = t('The firing order no longer fits and was left out. Choose one below.')
    return true
  }

  const move = (change: Parameters<typeof after<Tree>>[1]) => {
    const was = history.value.present
    history.value = after(history.value, change)
    if (history.value.present === was) return
    note.value = ''
    refused.value = null
    live.ask(history.value.present)
  }

  const self: Session = {
    service,
    tree: present,
    form: computed(() => formOf(allForms.value, present.value)),
    forms: allForms,
    catalog,
    problems,
    refused,
    busy,
    get relative() {
      return onStage.relative
    },
    get scene() {
      return onStage.scene
    },
    get whirl() {
      return onStage.whirl
    },
    note,
    shown,
    valid,
    verdict,
    steps: computed(() => {
      const { past, present: now, future } = history.value
      return { all: [...past, now, ...future], at: past.length }
    }),
    canUndo: computed(() => history.value.past.length > 0),
    canRedo: computed(() => history.value.future.length > 0),
    edit(to, gesture) {
      const now = performance.now()
      if (gesture?.startsWith(TYPING) && now - lastEdit > PAUSE) move({ kind: 'rest' })
      lastEdit = now
      const named = renamed(history.peek().present, to, origins, (name) =>
        t('{name}, edited', { name }),
      )
      move({ kind: 'edit', to: named, ...(gesture !== undefined && { gesture }) })
    },
    replace(to) {
      origins.add(to.name)
      move({ kind: 'edit', to })
    },
    direct(to, control) {
      const moved = changes(history.peek().present, to).reduce((now, { path }) => {
        const place = read(path)
        return withoutSources(withWeightsAlong(now, place, at(to, place), onStage), place)
      }, to)
      self.edit(moved, DIRECT + control)
    },
    goTo: (step) => move({ kind: 'go', step }),
    set(path, value, gesture) {
      const along = withWeightsAlong(history.value.present, path, value, onStage)
      self.edit(withoutSources(put(along, path, value), path), gesture)
    },
    rest: () => move({ kind: 'rest' }),
    undo: () => move({ kind: 'undo' }),
    redo: () => move({ kind: 'redo' }),
    adopt(given) {
      const known = same(given.file, onStage.file) || same(given.file, present.peek())
      onStage = given
      if (given.verdict) verdict.value = given.verdict
      if (known) return
      origins.add(given.file.name)
      live.stop()
      const untouched = self.steps.peek().all.length === 1
      // Back and Forward bring what was there before: a step that is known, not one more
      const step = self.steps.peek().all.findLastIndex((each) => same(each, given.file))
      const change =
        step < 0 ? ({ kind: 'edit', to: given.file } as const) : ({ kind: 'go', step } as const)
      batch(() => {
        // until something is changed, what the link shows is what the session begins with
        history.value = untouched ? begun(given.file) : after(history.value, change)
        valid.value = given.file
        problems.value = []
        busy.value = false
      })
    },
    load() {
      if (loading) return
      loading = true
      const failed = (reason: unknown) => {
        loading = false
        note.value = reasonOf(reason)
      }
      void service.schema().then((schema) => {
        allForms.value = forms(schema)
      }, failed)
      void service.catalog().then((entries) => {
        catalog.value = entries
      }, failed)
    },
    async open(answer, what) {
      const opened = await answered(counted(answer))
      batch(() => {
        if (opened.ok) self.replace(opened.value)
        note.value = opened.ok ? t('{what} is now in the form.', { what }) : ''
        refused.value = opened.ok
          ? null
          : {
              what: t('{what} could not be opened.', { what }),
              problems: opened.problems,
            }
      })
      return opened.ok
    },
  }

  return self
}

/** The answer; a server that cannot be reached is a problem too. */
export async function answered<T>(answer: Promise<Answer<T>>): Promise<Answer<T>> {
  try {
    return await answer
  } catch (reason) {
    return { ok: false, problems: [{ path: '', message: reasonOf(reason) }] }
  }
}

/** Problems with the places that they name. */
export function placed(problems: readonly Problem[]): Placed[] {
  return problems.map((problem) => ({ ...problem, at: read(problem.path) }))
}

/** The sentences that belong to a field; `below` takes those of all that is in it too. */
export function sentencesAt(problems: readonly Placed[], path: Path, below: boolean): string[] {
  return problems
    .filter(({ at }) => at.length > 0 && within(at, path) && (below || at.length === path.length))
    .map(({ message }) => message)
}

const sessions = new WeakMap<Service, Session>()

/** The session of a service, begun with an engine if there is none. */
export function sessionOf(service: Service, engine: OnStage, shown: Shown): Session {
  const its = sessions.get(service) ?? session(service, engine, shown)
  sessions.set(service, its)
  its.shown = shown
  return its
}
