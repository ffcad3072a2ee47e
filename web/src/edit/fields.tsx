import type { ComponentChildren } from 'preact'
import { useRef, useState } from 'preact/hooks'
import { Coded } from '../coded'
import { t } from '../language/messages'
import { choiceText } from './choices'
import { idOf, useSentences, useSession, useValue } from './context'
import { Dial } from './dial'
import {
  angle,
  type Dimension,
  degrees,
  parsed,
  rewritten,
  roundNumber,
  ruled,
  type Scale,
  scale,
  textOf,
  typed,
  wrapped,
} from './quantity'
import { type Field, type Kind, measured, type Of } from './schema'
import { TYPING } from './session'
import { at, type Path, same } from './tree'

export interface FieldProps {
  readonly field: Field
  readonly path: Path
  /** In a list of alike records: the help is not said again for each of them. */
  readonly quiet?: boolean
}

const USUAL: Record<Dimension, string> = {
  angle: 'deg',
  length: 'mm',
  mass: 'g',
  speed: 'rpm',
  other: '',
}

/** A label with its field, help and mistakes. */
export function Labelled({
  field,
  path,
  quiet,
  below = false,
  children,
}: FieldProps & { below?: boolean; children: ComponentChildren }) {
  const wrong = useSentences(path, below)
  const id = idOf(path)
  return (
    <div class={wrong.length ? 'field wrong' : 'field'}>
      <label for={id} title={quiet ? field.help : undefined}>
        {field.label}
      </label>
      <div class="taking">{children}</div>
      {field.help && (
        <p class={quiet ? 'unseen' : 'help'} id={`${id}-help`}>
          <Coded text={field.help} />
        </p>
      )}
      <Sentences path={path} below={below} />
    </div>
  )
}

/** The mistakes of a field; with `below` also those inside it. */
export function Sentences({ path, below = false }: { path: Path; below?: boolean }) {
  const lines = useSentences(path, below)
  const id = `${idOf(path)}-wrong`
  if (!lines.length) return null
  return (
    <div class="sentences" id={id}>
      {lines.map((line) => (
        <p key={line}>{line}</p>
      ))}
    </div>
  )
}

interface BoxProps {
  readonly path: Path
  readonly label?: string
  readonly example?: string
  readonly take: (text: string) => unknown
  readonly below?: boolean
  readonly long?: boolean
  readonly numeric?: boolean
}

/** A box for the value at a path. Typed text stays while it means what the file holds. */
export function Box({
  path,
  label,
  example,
  take,
  below = false,
  long = false,
  numeric = false,
}: BoxProps) {
  const session = useSession()
  const [raw, setRaw] = useState<string | null>(null)
  const wrong = useSentences(path, below).length > 0
  const value = useValue(path)
  const id = idOf(path)
  const meant = (text: string) =>
    text.trim() || typeof path.at(-1) === 'number' ? take(text) : undefined
  const text = raw !== null && same(meant(raw), value) ? raw : textOf(value)
  const props = {
    id,
    value: text,
    placeholder: example,
    'aria-label': label,
    'aria-invalid': wrong,
    'aria-describedby': `${wrong ? `${id}-wrong ` : ''}${id}-help`,
    autocomplete: 'off',
    spellcheck: false,
    onInput: (event: { currentTarget: HTMLInputElement | HTMLTextAreaElement }) => {
      const typedNow = event.currentTarget.value
      setRaw(typedNow)
      session.set(path, meant(typedNow), TYPING + id)
    },
    onBlur: () => {
      setRaw(null)
      session.rest()
    },
  }
  if (long) return <textarea rows={3} {...props} />
  return <input type="text" inputMode={numeric ? 'decimal' : 'text'} {...props} />
}

export function TextField(props: FieldProps) {
  const { field, path } = props
  const long = field.kind.is === 'text' && field.kind.long
  const take = field.kind.is === 'text' ? (text: string) => text : typed
  return (
    <Labelled {...props}>
      <Box path={path} example={field.example} take={take} long={long} />
    </Labelled>
  )
}

/** The ends of a number's slider: its own limits, or about its value where it has none. */
function limitsOf({ low, high }: Of<'number'>, number: number): Scale {
  if (Number.isFinite(low) && Number.isFinite(high))
    return ruled({ low, high, step: roundNumber((high - low) / 200) })
  const about = scale({ number, unit: '' }, 'other', low >= 0)
  return ruled({ ...about, low: Math.max(about.low, low), high: Math.min(about.high, high) })
}

export function NumberField(props: FieldProps & { kind: Of<'number'> }) {
  const { field, path, kind } = props
  const value = useValue(path)
  const bounded = Number.isFinite(kind.low) && Number.isFinite(kind.high)
  const number = typeof value === 'number' ? value : bounded ? kind.low : null
  const limits = number === null || kind.whole ? null : limitsOf(kind, number)
  return (
    <Labelled {...props}>
      <Box path={path} example={defaulted(field)} take={typed} numeric />
      {limits && number !== null && (
        <Slider
          path={path}
          label={field.label}
          limits={limits}
          number={number}
          written={(moved) => moved}
        />
      )}
    </Labelled>
  )
}

/** Numbers with commas, or with dashes as a firing order is written. */
const numbersIn = (text: string): unknown[] =>
  text
    .split(/[\s,;–-]+/)
    .filter(Boolean)
    .map(typed)

/** Lists of numbers, with semicolons between them. */
const listsIn = (text: string): unknown[] =>
  text
    .split(';')
    .filter((part) => part.trim())
    .map(numbersIn)

/** Numbers of cylinders, or lists of them. */
export function NumbersField(props: FieldProps) {
  const { field, path } = props
  return (
    <Labelled {...props} below>
      <Box
        path={path}
        example={field.example}
        take={field.kind.is === 'lists' ? listsIn : numbersIn}
        below
      />
    </Labelled>
  )
}

export function ChoiceField(props: FieldProps & { kind: Of<'choice'> }) {
  const { field, path, kind } = props
  const session = useSession()
  const value = useValue(path) ?? field.initial
  const known = kind.among.includes(String(value))
  const absent = value === undefined || value === null
  return (
    <Labelled {...props}>
      <select
        id={idOf(path)}
        aria-describedby={`${idOf(path)}-help`}
        value={absent ? '' : String(value)}
        onChange={({ currentTarget: { value: chosen } }) =>
          session.set(path, kind.logical && chosen ? chosen === 'true' : chosen || undefined)
        }
      >
        {absent ? (
          <option value="">{field.required ? t('choose') : t('not given')}</option>
        ) : (
          <>
            {!known && <option value={String(value)}>{String(value)}</option>}
            {!field.required && field.initial == null && <option value="">{t('not given')}</option>}
          </>
        )}
        {kind.among.map((each) => (
          <option key={each} value={each}>
            {choiceText(each)}
          </option>
        ))}
      </select>
    </Labelled>
  )
}

export function MarksField(props: FieldProps & { kind: Of<'marks'> }) {
  const { field, path, kind } = props
  const session = useSession()
  const value = useValue(path)
  const on = Array.isArray(value) ? value.map(String) : []
  return (
    <fieldset class="field marks" id={idOf(path)} tabIndex={-1}>
      <legend>{field.label}</legend>
      {kind.among.map((each) => (
        <label key={each}>
          <input
            type="checkbox"
            checked={on.includes(each)}
            onChange={(event) => {
              const next = kind.among.filter((other) =>
                other === each ? event.currentTarget.checked : on.includes(other),
              )
              session.set(path, next.length ? next : undefined)
            }}
          />
          {choiceText(each)}
        </label>
      ))}
      <p class="help">
        <Coded text={field.help} />
      </p>
      <Sentences path={path} below />
    </fieldset>
  )
}

interface SliderProps {
  readonly path: Path
  readonly label: string
  readonly limits: Scale
  readonly number: number
  /** What the engine file holds for a number. */
  readonly written: (number: number) => unknown
}

/** A slider beside a box; a drag is one step of the history and keeps its scale. */
function Slider({ path, label, limits, number, written }: SliderProps) {
  const session = useSession()
  const held = useRef<Scale | null>(null)
  const { low, high, step } = held.current ?? limits
  const rest = () => {
    held.current = null
    session.rest()
  }
  return (
    <input
      type="range"
      aria-label={t('{name}, slider', { name: label })}
      aria-valuetext={textOf(written(number))}
      min={low}
      max={high}
      step={step}
      value={number}
      onPointerDown={() => {
        held.current = limits
      }}
      onInput={(event) => {
        held.current ??= limits
        session.set(path, written(Number(event.currentTarget.value)), `drag ${idOf(path)}`)
      }}
      onChange={rest}
      onBlur={rest}
    />
  )
}

/** The placeholder of a box: the default, or an example. */
function defaulted(field: Field): string {
  if (field.initial !== undefined && field.initial !== null && field.initial !== '')
    return String(field.initial)
  return field.example ? t('e.g. {example}', { example: field.example }) : ''
}

/** Text as a value: a bare number takes the unit that was there, or the usual one. */
function useTake(path: Path, kind: Kind): (text: string) => unknown {
  const { tree, relative } = useSession()
  const value = at(tree.peek(), path)
  const unit = useRef('')
  const now = parsed(Array.isArray(value) ? value[0] : value)
  if (now) unit.current = now.unit
  else if (value === undefined && kind.is === 'quantity' && measured(kind, relative))
    unit.current ||= USUAL[kind.dimension]
  const one = (text: string): unknown => {
    const meant = typed(text)
    return typeof meant === 'number' && unit.current ? `${text.trim()} ${unit.current}` : meant
  }
  const several = kind.is === 'quantity' && kind.several
  return (text) =>
    several && text.includes(',') ? text.split(',').map((part) => one(part.trim())) : one(text)
}

/** A dial for the angle at a path; a turn is one step of the history. */
function Wheel({ path, label, at }: { path: Path; label: string; at: number | null }) {
  const session = useSession()
  const value = useValue(path)
  return (
    <Dial
      degrees={at}
      label={t('{name}, wheel', { name: label })}
      turned={(deg) => session.set(path, angle(deg, value), `turn ${idOf(path)}`)}
      rested={session.rest}
    />
  )
}

export function QuantityField(props: FieldProps & { kind: Of<'quantity'> }) {
  const { field, path, kind } = props
  const value = useValue(path)
  const take = useTake(path, kind)
  const given = parsed(value) ?? (value === undefined ? parsed(field.initial) : null)
  const whole =
    given && kind.dimension === 'angle'
      ? { number: degrees(value ?? field.initial) ?? 0, unit: 'deg' }
      : given
  const slides = whole && (kind.dimension === 'angle' || value !== undefined)
  const written = (number: number) =>
    kind.dimension === 'angle'
      ? angle(number, value)
      : rewritten(number, value, USUAL[kind.dimension])
  const number = whole && kind.dimension === 'angle' ? wrapped(whole.number, 1e-6) : whole?.number
  return (
    <Labelled {...props}>
      {kind.dimension === 'angle' && <Wheel path={path} label={field.label} at={number ?? null} />}
      <Box path={path} example={defaulted(field)} take={take} numeric />
      {slides && number !== undefined ? (
        <Slider
          path={path}
          label={field.label}
          limits={scale(whole, kind.dimension, kind.positive)}
          number={number}
          written={written}
        />
      ) : (
        <span class="room" />
      )}
    </Labelled>
  )
}

/** One angle or place of a list: a box and, for an angle, a wheel to turn. */
export function Item({ field, path, label }: { field: Field; path: Path; label: string }) {
  const angular = field.kind.is === 'quantity' && field.kind.dimension === 'angle'
  const value = useValue(path)
  const take = useTake(path, field.kind)
  return (
    <>
      {angular && <Wheel path={path} label={label} at={degrees(value)} />}
      <Box path={path} label={label} example={field.example} take={take} numeric />
      <Sentences path={path} />
    </>
  )
}
