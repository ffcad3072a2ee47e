import { computed, effect, type ReadonlySignal, type Signal, signal } from '@preact/signals'
import { afterRest, begin, counted } from './activity'
import { commonTurns } from './angle'
import { type Clock, createClock } from './clock'
import type { Exhibit, Term } from './exhibit'
import type { Host, Tree } from './host/host'
import type { News } from './host/watching'
import { language, t } from './language/messages'
import { type MountChoice, mountChoiceOf } from './mounts'
import { packedTree, unpackedTree } from './packing'
import { prevailing } from './prevailing'
import { reasonOf } from './reason'
import type { Sight, Stage } from './stage/stage'
import {
  type Quantity,
  restore,
  type Store,
  set,
  snapshot,
  stateOf,
  stateText,
  storeOf,
} from './state'
import { settingOf, withGasRoll, withoutPower } from './torque'
import { type TwistChoice, twistChoiceOf } from './torsion'
import { InUnits, keepUnits, keptUnits } from './units'
import { visits } from './visits'

/** What all parts of the page share. */
export interface App {
  readonly host: Host
  readonly store: Store
  readonly clock: Clock
  /** The engine and, where there is one, the engine beside it, as they are. */
  readonly engines: ReadonlySignal<readonly Exhibit[]>
  /** The same with weights and shafts; null where they do not help, undefined until known. */
  readonly cured: ReadonlySignal<readonly (Exhibit | null | undefined)[]>
  /** The engines on the stage and in the panels: each as it is or fitted. */
  readonly shown: ReadonlySignal<readonly Exhibit[]>
  /** The same as the stage and its numbers have them: with gas in the rolling moment, if chosen. */
  readonly staged: ReadonlySignal<readonly Exhibit[]>
  /** The units of all numbers, as --units takes them. */
  readonly units: ReadonlySignal<string>
  /** Puts the engine with estimated masses in its place. */
  estimate(exhibit: Exhibit): Promise<void>
  /** Which of the shown engines the panels show: places in `engines`, `cured` and `shown`. */
  readonly subjects: ReadonlySignal<readonly number[]>
  /** The first of them. */
  readonly subject: ReadonlySignal<number>
  /** The quantity that figures and derivations show: the chosen one, or the greater of force and couple. */
  readonly quantity: ReadonlySignal<Quantity>
  /** What twists the cranks of engines whose torsion is known. */
  readonly twist: ReadonlySignal<TwistChoice>
  /** What moves the blocks of engines on mounts. */
  readonly mounts: ReadonlySignal<MountChoice>
  /** What is on the stage: as chosen, or what there is room for. */
  readonly sight: ReadonlySignal<Sight>
  /** The stages that are on the page, each at the place of its engine in `shown`. */
  readonly stages: Map<number, Stage>
  /** Whether each stage has room for a drawing sheet. */
  readonly roomy: Signal<boolean>
  /** The term of the glossary that is explained at the moment, and the word beside which. */
  readonly explained: Signal<{ term: Term; beside: HTMLElement } | null>
  /** Step of the guide that is shown, from 1; 0 for none. */
  readonly guide: Signal<number>
  /** The dialog that is open, by name; empty for none. */
  readonly dialog: Signal<'' | 'export' | 'keys'>
  /** What went wrong last, as a sentence; empty if nothing. */
  readonly trouble: Signal<string>
  /** What is wrong with the file that the server watches; null if nothing. */
  readonly mistakes: Signal<Mistaken | null>
  /** How many mistakes the engine has that is edited; it is not the one that is shown then. */
  readonly slips: Signal<number>
  /** Whether the page is dark, by choice or by the system. */
  readonly dark: ReadonlySignal<boolean>
  readonly calm: ReadonlySignal<boolean>
  /** Puts an engine that was edited on the stage. */
  put(exhibit: Exhibit, tree: Tree): void
  /** Asks for the engine with weights and shafts, if that was not done yet. */
  cure(): void
  dispose(): void
}

/** A file with mistakes. */
export type Mistaken = Pick<News, 'file' | 'problems'>

const WRITTEN_AFTER = 300

/** A media query as a signal. */
function matching(query: string, endings: (() => void)[]): ReadonlySignal<boolean> {
  const list = matchMedia(query)
  const matches = signal(list.matches)
  const changed = (): void => set(matches, list.matches)
  list.addEventListener('change', changed)
  endings.push(() => list.removeEventListener('change', changed))
  return matches
}

export function createApp(host: Host): App {
  const endings: (() => void)[] = []
  const store = storeOf(stateOf(host.readState()))
  if (host.kind !== 'widget' && !store.units.peek()) store.units.value = keptUnits()
  const systemDark = matching('(prefers-color-scheme: dark)', endings)
  const calm = matching('(prefers-reduced-motion: reduce)', endings)
  const trouble = signal('')
  const mistakes = signal<Mistaken | null>(null)
  const slips = signal(0)
  let given: Exhibit = host.exhibition.engines[0]
  const own = signal<Exhibit>(given)
  const other = signal<Exhibit | null>(null)
  const known = signal<ReadonlyMap<Exhibit, Exhibit | null>>(new Map())

  const others = new InUnits()
  const arrived = signal(0)
  const asGiven = computed(() => (other.value ? [own.value, other.value] : [own.value]))
  const units = computed(() => store.units.value || host.exhibition.engines[0].units.chosen)
  // until an engine comes in the chosen units, it stays as it is
  const engines = computed(() => {
    void arrived.value
    return asGiven.value.map((exhibit) => others.of(exhibit, units.value) ?? exhibit)
  })
  const cured = computed(() => engines.value.map((exhibit) => known.value.get(exhibit)))
  const shown = computed(() =>
    engines.value.map((exhibit, index) =>
      store.fitted.value ? (cured.value[index] ?? exhibit) : exhibit,
    ),
  )
  const staged = computed(() => {
    const { choices } = store
    const setting = settingOf(choices.value)
    const gas = choices.value['forces.gas'] === 'on'
    if (!gas && !setting.off.length) return shown.value
    return shown.value.map((exhibit) =>
      withoutPower(gas ? withGasRoll(exhibit, setting) : exhibit, setting.off),
    )
  })
  const subjects = computed(() => {
    const places = engines.value.map((_, place) => place)
    const chosen = places[Number(store.panel.value) - 1]
    return chosen === undefined ? places : [chosen]
  })
  const subject = computed(() => subjects.value[0] ?? 0)
  const quantity = computed(
    () => store.quantity.value ?? prevailing(engines.value[subject.value] ?? own.value),
  )
  const twist = computed(() => twistChoiceOf(store.choices.value))
  const mounts = computed(() => mountChoiceOf(store.choices.value))
  const roomy = signal(true)
  const explained = signal<{ term: Term; beside: HTMLElement } | null>(null)
  const guide = signal(0)
  const dialog = signal<'' | 'export' | 'keys'>('')
  const sight = computed((): Sight => {
    const chosen = store.camera.value ?? 'sheet'
    return chosen === 'sheet' && !roomy.value ? 'isometric' : chosen
  })
  const dark = computed(() =>
    store.theme.value === 'auto' ? systemDark.value : store.theme.value === 'dark',
  )
  const clock = createClock(store.pace, (degrees) => set(store.angle, degrees))

  const failed = (error: unknown): void => set(trouble, reasonOf(error))

  function cure(): void {
    for (const exhibit of engines.peek()) {
      if (known.peek().has(exhibit)) continue
      counted(host.fitted(exhibit)).then(
        (after) => set(known, new Map(known.peek()).set(exhibit, after)),
        failed,
      )
    }
  }

  /** An engine of the catalog, or one packed into the address; null if it cannot be had. */
  async function engineNamed(name: string): Promise<Exhibit | null> {
    const service = host.service
    if (!service) return null
    const packed = name.startsWith('~')
    const tree = packed ? await unpackedTree(name.slice(1)) : await service.engine(name)
    const answer = tree.ok ? await service.exhibit(tree.value) : tree
    if (answer.ok) return answer.value
    const reason = answer.problems.map((problem) => problem.message).join(' ')
    trouble.value = packed
      ? reason
      : t('The link names the engine “{name}”, which cannot be shown: {reason}', {
          name: name.slice(0, 60),
          reason,
        })
    return null
  }

  /** Asks for engines in the chosen units; where they are refused, takes back the choice. */
  function convert(exhibits: readonly Exhibit[], wanted: string): void {
    for (const exhibit of exhibits) {
      if (others.of(exhibit, wanted)) continue
      counted(host.inUnits(exhibit, wanted)).then(
        (converted) => {
          others.put(exhibit, wanted, converted)
          arrived.value += 1
        },
        (error: unknown) => {
          failed(error)
          if (store.units.peek() === wanted) store.units.value = ''
        },
      )
    }
  }

  let ownName = ''
  let begun = false
  endings.push(
    effect(() => convert(asGiven.value, units.value)),
    effect(() => {
      // a notebook has the units of its kernel
      if (host.kind !== 'widget') keepUnits(store.units.value)
    }),
    effect(() => {
      const name = store.engine.value
      if (name === ownName) return
      ownName = name
      if (name === '') own.value = given
      else
        engineNamed(name).then((exhibit) => {
          if (exhibit && ownName === name) own.value = exhibit
        }, failed)
    }),
    effect(() => {
      const name = store.beside.value
      const second = host.exhibition.engines[1] ?? null
      if (name === '' || name === '2') other.value = second
      else if (name === '0') other.value = null
      else
        engineNamed(name).then((exhibit) => {
          if (exhibit && store.beside.peek() === name) other.value = exhibit
        }, failed)
    }),
    effect(() => {
      clock.turns.value = shown.value.reduce(
        (turns, exhibit) => commonTurns(turns, exhibit.turns),
        1,
      )
    }),
    effect(() => {
      if (store.fitted.value && engines.value.length) cure()
    }),
    effect(() => {
      // a file has its title written in it, a notebook is not ours
      if (host.kind === 'server') document.title = engines.value.map(({ name }) => name).join(' · ')
    }),
    effect(() => {
      const before = language.value
      language.value = store.language.value || host.language
      // a server tells of its engines in one language: asked again, when the link has the choice
      if (host.kind === 'server' && begun && language.value !== before) {
        begin() // and ended by the page that comes in the place of this one
        window.setTimeout(() => location.reload(), 2 * WRITTEN_AFTER)
      }
      begun = true
      // a notebook is not ours
      if (host.kind !== 'widget') document.documentElement.lang = language.value
    }),
  )

  const visited = visits(snapshot(store))
  let callOff: (() => void) | null = null
  const write = (): void => {
    callOff = null
    const state = snapshot(store)
    host.writeState(stateText(state), visited.isNew(state, performance.now()))
  }
  let first = true
  endings.push(
    effect(() => {
      snapshot(store)
      clock.refresh()
      // the text stands as it was given until something is changed
      if (!first) callOff ??= afterRest(write, WRITTEN_AFTER)
      first = false
    }),
    () => callOff?.(),
  )

  function put(exhibit: Exhibit, tree: Tree): void {
    const edited = { ...exhibit, file: tree }
    own.value = edited
    ownName = '~'
    packedTree(tree).then((packed) => {
      if (own.peek() !== edited) return
      ownName = `~${packed}`
      store.engine.value = ownName
    }, failed)
  }

  async function estimate(exhibit: Exhibit): Promise<void> {
    try {
      const tree = await host.estimate?.(exhibit)
      if (!tree) return // the host has put it there
      if (asGiven.peek()[1]?.file === exhibit.file) {
        store.beside.value = `~${await packedTree(tree)}`
        return
      }
      const answer = await host.service?.exhibit(tree)
      if (answer?.ok) put(answer.value, tree)
    } catch (error) {
      failed(error)
    }
  }

  /** A watched file was saved: its engine takes the place of the one before, edited or not. */
  async function saved({ file, problems, tree }: News): Promise<void> {
    mistakes.value = problems.length ? { file, problems } : null
    const answer = tree && (await host.service?.exhibit(tree))
    if (!answer) return
    if (!answer.ok) {
      mistakes.value = { file, problems: answer.problems }
      return
    }
    given = answer.value
    const name = store.engine.peek()
    if (name !== '' && !name.startsWith('~')) return
    ownName = ''
    store.engine.value = ''
    own.value = given
  }
  const unwatch = host.watched?.((news) => void saved(news).catch(failed))
  if (unwatch) endings.push(unwatch)

  /** Sets the clock as the state has it: at an angle, or turning unless calm is preferred. */
  function start(): void {
    const angle = store.angle.peek()
    if (angle !== null) {
      clock.stop()
      clock.turnTo(angle)
    } else if (calm.peek()) clock.turnTo(0)
    else clock.play()
  }
  endings.push(
    host.onState((text) => {
      const state = stateOf(text)
      // what was changed just before does not lead back
      callOff?.()
      callOff = null
      if (stateText(state) === stateText(snapshot(store))) return
      visited.seen(state)
      restore(store, state)
      start()
    }),
  )
  start()

  return {
    host,
    store,
    clock,
    engines,
    cured,
    shown,
    staged,
    units,
    estimate,
    subjects,
    subject,
    quantity,
    sight,
    twist,
    mounts,
    stages: new Map(),
    roomy,
    explained,
    guide,
    dialog,
    trouble,
    mistakes,
    slips,
    dark,
    calm,
    put,
    cure,
    dispose() {
      for (const end of endings) end()
      clock.dispose()
    },
  }
}
