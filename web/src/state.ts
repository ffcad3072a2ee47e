import { batch, type Signal, signal } from '@preact/signals'
import { FASTEST, SLOWEST, USUAL } from './pace'
import { EACH, type Each, SIGHTS, type Sight } from './stage/stage'

export const THEMES = ['auto', 'light', 'dark'] as const
export type Theme = (typeof THEMES)[number]
export const QUANTITIES = ['force', 'couple', 'roll', 'torque'] as const
export type Quantity = (typeof QUANTITIES)[number]

/** All that makes two people who open the same link see the same thing. */
export interface State {
  /** The engine unless the opening one: a catalog name, or `~` and a packed engine file. */
  readonly engine: string
  /** Crank angle at which the engine stands, degrees; null while it turns. */
  readonly angle: number | null
  /** The view; null for the sheet where there is room for it, else the isometric one. */
  readonly camera: Sight | null
  /** Place of the slice that the front view shows, from the front; 0 for the whole engine. */
  readonly section: number
  /** The panel that is seen, by its key. */
  readonly tab: string
  readonly force: boolean
  readonly couple: boolean
  readonly roll: boolean
  /** The couple as pitch and yaw, not in its plane. */
  readonly axes: boolean
  /** Arrows of cylinders or banks besides those of the engine. */
  readonly each: Each
  /** Orders that are shown as arrows, as whirl and in figures; null for all. */
  readonly orders: readonly number[] | null
  /** The quantity of figures and derivations; null for the greater of force and couple. */
  readonly quantity: Quantity | null
  /** Length of the arrows, 1 as the stage is designed. */
  readonly scale: number
  /** Magnification of the whirl, 0 for none. */
  readonly whirl: number
  readonly glass: boolean
  readonly glow: boolean
  /** Turns of the crankshaft in a second. */
  readonly pace: number
  readonly theme: Theme
  /** Large, without controls: for an audience. */
  readonly present: boolean
  /** With counterweights and balance shafts. */
  readonly fitted: boolean
  /** The engine beside it: a catalog name, `2` for the second of a page, empty for none. */
  readonly beside: string
  /** Which of the engines on the stage the panels show. */
  readonly panel: 'both' | '1' | '2'
  /** Units of all numbers, as --units takes them; empty for those of the host. */
  readonly units: string
  /** Language of the page; empty for that of its host. */
  readonly language: string
  /** What is chosen within panels, by `panel.choice`. */
  readonly choices: Choices
}

export type Choices = Readonly<Record<string, string>>

export const OPENING: State = {
  engine: '',
  angle: null,
  camera: null,
  section: 0,
  tab: 'orders',
  force: true,
  couple: true,
  roll: true,
  axes: false,
  each: 'engine',
  orders: null,
  quantity: null,
  scale: 1,
  whirl: 0,
  glass: true,
  glow: true,
  pace: USUAL,
  theme: 'auto',
  present: false,
  fitted: false,
  beside: '',
  panel: 'both',
  units: '',
  language: '',
  choices: {},
}

/** How a part of the state is written; `read` gives undefined for nonsense. */
interface Field<T> {
  readonly key: string
  read(text: string): T | undefined
  write(value: T): string
}

const yesNo = (key: string): Field<boolean> => ({
  key,
  read: (text) => (text === '1' ? true : text === '0' ? false : undefined),
  write: (value) => (value ? '1' : '0'),
})

const oneOf = <T extends string>(key: string, choices: readonly T[]): Field<T> => ({
  key,
  read: (text) => choices.find((choice) => choice === text),
  write: (value) => value,
})

const between = (key: string, low: number, high: number): Field<number> => ({
  key,
  read: (text) => {
    const value = text.trim() === '' ? Number.NaN : Number(text)
    return value >= low && value <= high ? value : undefined
  },
  write: (value) => String(Number(value.toPrecision(12))),
})

const count = (key: string, most: number): Field<number> => ({
  key,
  read: (text) => (/^\d{1,9}$/.test(text) && Number(text) <= most ? Number(text) : undefined),
  write: String,
})

const words = (key: string, longest: number): Field<string> => ({
  key,
  read: (text) => (text.length <= longest ? text : undefined),
  write: (value) => value,
})

const angle: Field<number | null> = {
  ...between('a', -1e7, 1e7),
  write: (value) => (value === null ? '' : String(Number(value.toFixed(9)))),
}

const orders: Field<readonly number[] | null> = {
  key: 'orders',
  read: (text) => {
    const values = text.split('_').map((part) => (part === '' ? Number.NaN : Number(part)))
    const good = values.every((value) => value > 0 && value <= 1000) && values.length <= 64
    return good ? [...new Set(values)].sort((one, other) => one - other) : undefined
  },
  write: (value) => (value ?? []).join('_'),
}

/** What a choice within a panel is called in an address, and what it may be. */
const CHOICE = /^[a-z]{1,20}\.[a-z]{1,20}$/
const CHOSEN = /^[\w-]{1,120}$/
/** Choices by a name that a file gives, which is any text, and by a number. */
const NAMED: Readonly<Record<string, RegExp>> = {
  'torque.load': /^[^\p{C}]{1,200}$/u,
  'twist.order': /^\d{1,3}(\.\d{1,6})?$/,
  'mounts.rpm': /^\d{1,6}(\.\d{1,3})?$/,
}
const MOST_CHOICES = 32

type Single = Omit<State, 'choices'>
const FIELDS: { readonly [K in keyof Single]: Field<Single[K]> } = {
  engine: words('engine', 60_000),
  angle,
  camera: { ...oneOf('camera', SIGHTS), write: (value) => value ?? '' },
  section: count('section', 256),
  tab: { ...words('tab', 20), read: (text) => (/^[a-z]{1,20}$/.test(text) ? text : undefined) },
  force: yesNo('force'),
  couple: yesNo('couple'),
  roll: yesNo('roll'),
  axes: yesNo('axes'),
  each: oneOf('each', EACH),
  orders,
  quantity: { ...oneOf('of', QUANTITIES), write: (value) => value ?? '' },
  scale: between('scale', 0.05, 20),
  whirl: between('whirl', 0, 1e6),
  glass: yesNo('glass'),
  glow: yesNo('glow'),
  pace: between('speed', SLOWEST, FASTEST),
  theme: oneOf('theme', THEMES),
  present: yesNo('present'),
  fitted: yesNo('fitted'),
  beside: words('beside', 60_000),
  panel: oneOf('panel', ['both', '1', '2']),
  units: words('units', 200),
  language: words('lang', 12),
}
const SINGLE = Object.keys(FIELDS) as readonly (keyof Single)[]
const NAMES: readonly (keyof State)[] = [...SINGLE, 'choices']

/** The state as text for an address, only differences from the opening. */
export function stateText(state: State): string {
  const text = new URLSearchParams()
  const add = <K extends keyof Single>(name: K): void => {
    const written = FIELDS[name].write(state[name])
    if (written !== FIELDS[name].write(OPENING[name])) text.set(FIELDS[name].key, written)
  }
  SINGLE.forEach(add)
  for (const [name, value] of Object.entries(state.choices).sort()) text.set(name, value)
  return text.toString()
}

/** The state that a text stands for. Whatever is not understood is as a page opens. */
export function stateOf(text: string): State {
  const given = new URLSearchParams(text.replace(/^#/, ''))
  const state: Single = { ...OPENING }
  const take = <K extends keyof Single>(name: K): void => {
    const written = given.get(FIELDS[name].key)
    const value = written === null ? undefined : FIELDS[name].read(written)
    if (value !== undefined) Object.assign(state, { [name]: value })
  }
  for (const name of SINGLE) take(name)
  const choices = [...given].filter(
    ([name, value]) => CHOICE.test(name) && (NAMED[name] ?? CHOSEN).test(value),
  )
  return { ...state, choices: Object.fromEntries(choices.slice(0, MOST_CHOICES)) }
}

/** The state as signals, one for each part. */
export type Store = { readonly [K in keyof State]: Signal<State[K]> }

export function storeOf(state: State): Store {
  return Object.fromEntries(NAMES.map((name) => [name, signal(state[name])])) as unknown as Store
}

/** Gives a signal its value, as an expression. */
export function set<T>(part: Signal<T>, value: T): void {
  part.value = value
}

/** The state at this moment; an effect that reads it runs again when any part changes. */
export function snapshot(store: Store): State {
  return Object.fromEntries(NAMES.map((name) => [name, store[name].value])) as unknown as State
}

/** Puts every part of a state into the store at once. */
export function restore(store: Store, state: State): void {
  const put = <K extends keyof State>(name: K): void =>
    set(store[name] as Signal<State[K]>, state[name])
  batch(() => NAMES.forEach(put))
}
