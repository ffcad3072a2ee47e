import { effect, type Signal, signal } from '@preact/signals'
import { afterRest } from '../activity'
import type { Preset, Slider, WorkshopShown } from '../exhibit'
import type { Tree } from '../host/host'
import { reasonOf } from '../reason'
import { latest } from './latest'
import { answered, type Session } from './session'
import { same } from './tree'

/** Milliseconds for which an engine must rest before what it offers is asked for. */
export const REST = 250

/** What the server says of the engine on the stage: offers, controls, and curves of sliders. */
export interface Bench {
  /** Of the engine of `asked`; an older one while the newest is still to come. */
  readonly shown: Signal<WorkshopShown | null>
  readonly sliders: Signal<readonly Slider[]>
  /** The engine that `sliders` are of. */
  readonly swept: Signal<Tree | null>
  readonly presets: Signal<readonly Preset[]>
  readonly busy: Signal<boolean>
  /** What was decided with the last number of cylinders. */
  readonly decided: Signal<readonly string[]>
  /** Puts the engine with another number of cylinders on the stage. */
  cylinders(count: number): Promise<void>
  loadPresets(): void
}

interface Answers {
  readonly shown: WorkshopShown | null
  readonly sliders: readonly Slider[]
}

/** Follows the engine on the stage of a session. Returns the bench and what ends it. */
export function benchOf(session: Session, units: () => string): [Bench, () => void] {
  const shown = signal<WorkshopShown | null>(null)
  const sliders = signal<readonly Slider[]>([])
  const swept = signal<Tree | null>(null)
  const presets = signal<readonly Preset[]>([])
  const busy = signal(false)
  const decided = signal<readonly string[]>([])
  let loading = false
  let decidedFor: Tree | null = null

  const live = latest<Tree, Answers>({
    async send(tree, abort) {
      // one after the other: the next change of the engine must find a process that is free
      const bench = await session.service.workshop(tree, undefined, abort)
      // the first is there to be worked on while the curves of its sliders are still computed
      if (bench.ok && shown.peek() === null) shown.value = bench.value
      const curves = await session.service.sliders(tree, units(), abort)
      return {
        ok: true,
        value: {
          shown: bench.ok ? bench.value : null,
          sliders: curves.ok ? curves.value.sliders : [],
        },
      }
    },
    answered(answer, tree, newest) {
      if (!answer.ok || !newest) return
      shown.value = answer.value.shown
      if (decidedFor && !same(decidedFor, tree)) decided.value = []
      sliders.value = answer.value.sliders
      swept.value = tree
    },
    waiting: (now) => {
      busy.value = now
    },
  })

  let callOff = (): void => {}
  const end = effect(() => {
    const tree = session.valid.value
    units()
    callOff()
    callOff = afterRest(() => live.ask(tree), shown.peek() === null ? 0 : REST)
  })

  return [
    {
      shown,
      sliders,
      swept,
      presets,
      busy,
      decided,
      async cylinders(count) {
        const answer = await answered(session.service.workshop(session.tree.peek(), count))
        if (!answer.ok) {
          session.note.value = answer.problems.map(({ message }) => message).join(' ')
          return
        }
        decidedFor = answer.value.tree as Tree
        session.replace(decidedFor)
        decided.value = answer.value.sentences.slice(1)
        shown.value = answer.value
      },
      loadPresets() {
        if (loading || presets.peek().length) return
        loading = true
        session.service.presets().then(
          (list) => {
            presets.value = list
          },
          (reason: unknown) => {
            session.note.value = reasonOf(reason)
            loading = false
          },
        )
      },
    },
    () => {
      end()
      callOff()
      live.stop()
    },
  ]
}
