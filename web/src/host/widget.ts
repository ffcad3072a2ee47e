import { effect } from '@preact/signals'
import { counted } from '../activity'
import type { App } from '../app'
import type { Exhibit, Exhibition } from '../exhibit'
import { t } from '../language/messages'
import { drawing } from './drawing'
import type { Host, Spec } from './host'
import { unpacked } from './page'

/** The model of a notebook's widget, as anywidget gives it (Anywidget Front-End Module). */
export interface Model {
  get(name: string): unknown
  set(name: string, value: unknown): void
  save_changes(): void
  send(content: unknown): void
  on(event: string, listener: (content: unknown) => void): void
  off(event: string, listener: (content: unknown) => void): void
}

/** The key of the crank angle in the text of a state: a notebook has its own traits for that. */
const ANGLE = 'a'
/** Degrees by which two angles differ that are the same. */
const SAME = 1e-9
/** Milliseconds that a kernel may take to answer: it may be at work in another cell. */
const PATIENCE = 60_000

const textOf = (model: Model, name: string): string => String(model.get(name) ?? '')
const angleOf = (model: Model): number => Number(model.get('theta')) || 0

function put(model: Model, name: string, value: unknown): void {
  if (model.get(name) === value) return
  model.set(name, value)
  model.save_changes()
}

/** A request to the kernel; `fitted` for the engine with weights and shafts. */
interface Question {
  engine: number
  fitted: boolean
  what: 'chart' | 'derivation' | 'drawing' | 'exhibit' | 'estimate'
  key: string
  units: string
}

interface Reply {
  id: unknown
  value?: unknown
  sentence?: unknown
}

const isReply = (content: unknown): content is Reply =>
  typeof content === 'object' && content !== null && 'id' in content

let questions = 0

/** Asks the kernel of the notebook; several views of one model each hear only their own answers. */
function kernel(model: Model, question: Question): Promise<unknown> {
  questions += 1
  const id = `${questions} ${Math.random()}`
  const reply = new Promise<unknown>((resolve, reject) => {
    const over = (): void => {
      window.clearTimeout(late)
      model.off('msg:custom', listener)
    }
    const listener = (content: unknown): void => {
      if (!isReply(content) || content.id !== id) return
      over()
      if (content.value === undefined) reject(new Error(String(content.sentence)))
      else resolve(content.value)
    }
    const late = window.setTimeout(() => {
      over()
      reject(new Error(t('The notebook kernel does not answer. Is it running and idle?')))
    }, PATIENCE)
    model.on('msg:custom', listener)
    model.send({ ...question, id })
  })
  return counted(reply)
}

/** Where an exhibit stands in what the kernel has. */
type Place = Pick<Question, 'engine' | 'fitted'>

/** A notebook cell: engines in the trait `data`, view in `state`, angle and motion apart. */
export async function widgetHost(model: Model): Promise<Host> {
  const { exhibition } = (await unpacked(textOf(model, 'data'))) as { exhibition: Exhibition }
  const places = new Map<Exhibit, Place>()
  exhibition.engines.forEach((exhibit, engine) => {
    places.set(exhibit, { engine, fitted: false })
    const after = exhibition.fitted[engine]
    if (after) places.set(after, { engine, fitted: true })
  })
  const placeOf = (exhibit: Exhibit): Place => places.get(exhibit) ?? { engine: -1, fitted: false }
  const ask = (exhibit: Exhibit, what: Question['what'], key = ''): Promise<unknown> =>
    kernel(model, { ...placeOf(exhibit), what, key, units: exhibit.units.chosen })
  /** An engine in other units, known from now on. */
  async function inUnits(place: Place, units: string): Promise<Exhibit | null> {
    const question = { ...place, what: 'exhibit', key: '', units } as const
    const exhibit = (await kernel(model, question)) as Exhibit | null
    if (exhibit) places.set(exhibit, place)
    return exhibit
  }
  const readState = (): string => {
    const state = new URLSearchParams(textOf(model, 'state'))
    state.delete(ANGLE)
    if (model.get('playing') !== true) state.set(ANGLE, String(angleOf(model)))
    return state.toString()
  }
  return {
    kind: 'widget',
    exhibition,
    language: '',
    chart: (exhibit, key) => ask(exhibit, 'chart', key) as Promise<Spec>,
    derivation: (exhibit, key) => ask(exhibit, 'derivation', key) as Promise<string>,
    drawing: drawing(async () => {
      const question = { engine: 0, fitted: false, what: 'drawing', key: '', units: '' } as const
      const text = String(await kernel(model, question))
      // as anywidget reads the script of the page, and so allowed wherever that is
      const address = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }))
      return { address }
    }),
    anyUnits: true,
    inUnits: async (exhibit, units) => (await inUnits(placeOf(exhibit), units)) ?? exhibit,
    estimate: async (exhibit) => {
      await ask(exhibit, 'estimate') // the kernel puts it in the place of the other
      return null
    },
    fitted: (exhibit) => {
      const { engine } = placeOf(exhibit)
      const asOpened = exhibition.engines[engine]?.units.chosen === exhibit.units.chosen
      if (asOpened) return Promise.resolve(exhibition.fitted[engine] ?? null)
      return inUnits({ engine, fitted: true }, exhibit.units.chosen)
    },
    readState,
    writeState: (text) => {
      const state = new URLSearchParams(text)
      state.delete(ANGLE)
      put(model, 'state', state.toString())
    },
    onState: (changed) => {
      const listener = (): void => changed(readState())
      model.on('change:state', listener)
      return () => model.off('change:state', listener)
    },
  }
}

/** Keeps angle and motion of model and page equal. Returns what ends that. */
export function linked(model: Model, { clock, store }: Pick<App, 'clock' | 'store'>): () => void {
  const turn = (): void => {
    if (Math.abs(angleOf(model) - clock.degrees()) < SAME) return
    clock.turnTo(angleOf(model))
    clock.stop()
  }
  const move = (): void => (model.get('playing') === true ? clock.play() : clock.stop())
  model.on('change:theta', turn)
  model.on('change:playing', move)
  const end = effect(() => {
    const angle = store.angle.value
    if (angle !== null && Math.abs(angle - angleOf(model)) >= SAME) put(model, 'theta', angle)
    put(model, 'playing', angle === null)
  })
  return () => {
    end()
    model.off('change:theta', turn)
    model.off('change:playing', move)
  }
}
