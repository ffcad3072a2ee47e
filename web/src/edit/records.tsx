import type { ComponentChildren, JSX } from 'preact'
import { useState } from 'preact/hooks'
import { Coded } from '../coded'
import { plural, t } from '../language/messages'
import { idOf, useSession, useValue } from './context'
import {
  ChoiceField,
  type FieldProps,
  Item,
  MarksField,
  NumberField,
  NumbersField,
  QuantityField,
  Sentences,
  TextField,
} from './fields'
import { another, recordOf } from './newRecords'
import { textOf } from './quantity'
import type { Field, Of } from './schema'
import { at, moved, type Path, within } from './tree'

/** Keys that lie open in a table; the others are under "More", except in short tables. */
const OPEN = new Set(
  `name bearing cylinders throws angle radius z unbalance speed_ratio lag bore_pitch bank_offset row_pitch knuckle_radius crank_distance
  banks rows cranks throw weight number shaft master rod_length reciprocating_mass bore stroke rod_ratio rotating_mass up right mass
  centre inertia status source`.split(/\s+/),
)
const FEW = 4

/** The field of a key, as its kind takes it. */
export function AnyField(props: FieldProps): JSX.Element | null {
  const { kind } = props.field
  switch (kind.is) {
    case 'fixed':
      return null
    case 'choice':
      return <ChoiceField {...props} kind={kind} />
    case 'text':
    case 'ratio':
      return <TextField {...props} />
    case 'number':
      return <NumberField {...props} kind={kind} />
    case 'quantity':
      return <QuantityField {...props} kind={kind} />
    case 'numbers':
    case 'lists':
      return <NumbersField {...props} />
    case 'marks':
      return <MarksField {...props} kind={kind} />
    case 'quantities':
      return <QuantitiesField {...props} kind={kind} />
    case 'record':
      return <RecordField {...props} kind={kind} />
    case 'records':
      return <RecordsField {...props} kind={kind} />
    case 'table':
      return <TableField {...props} kind={kind} />
  }
}

/** The fields of a table: what engineers change first lies open, the rest is folded. */
export function Fields({
  fields,
  path,
  quiet = false,
}: {
  fields: readonly Field[]
  path: Path
  quiet?: boolean
}) {
  const session = useSession()
  const here = at(session.tree.peek(), path)
  const chief = fields.filter((field) => field.required || OPEN.has(field.key))
  const open = chief.length === 0 || fields.length <= FEW ? fields : chief
  const folded = fields.filter((field) => !open.includes(field) && field.kind.is !== 'fixed')
  const given = folded.filter((field) => at(here, [field.key]) !== undefined)
  const each = (list: readonly Field[]) =>
    list.map((field) => (
      <AnyField key={field.key} field={field} path={[...path, field.key]} quiet={quiet} />
    ))
  return (
    <>
      {each(open)}
      {folded.length > 0 && (
        <Folded
          title={t('More: {fields}', {
            fields: folded.map((field) => field.label.toLowerCase()).join(', '),
          })}
          open={given.length > 0}
          paths={folded.map((field) => [...path, field.key])}
        >
          {() => each(folded)}
        </Folded>
      )}
    </>
  )
}

interface FoldedProps {
  readonly title: string
  readonly open: boolean
  /** Its contents: the title counts their mistakes. */
  readonly paths: readonly Path[]
  readonly children: () => ComponentChildren
}

/** Contents that are drawn once they have been opened or have a mistake. */
export function Folded({ title, open, paths, children }: FoldedProps) {
  const [begins] = useState(open)
  const [seen, setSeen] = useState(open)
  const wrong = useSession().problems.value.filter((problem) =>
    paths.some((path) => within(problem.at, path)),
  ).length
  return (
    <details
      class="folded"
      open={begins}
      onToggle={(event) => event.currentTarget.open && setSeen(true)}
    >
      <summary>
        {title}
        {wrong > 0 && (
          <span class="count">
            {' '}
            {plural('{count} mistake', '{count} mistakes', wrong, { count: wrong })}
          </span>
        )}
      </summary>
      <div class="within">{(seen || wrong > 0) && children()}</div>
    </details>
  )
}

/** A button with a sign in place of a word. */
function Sign({ sign, label, does }: { sign: string; label: string; does?: () => void }) {
  return (
    <button type="button" aria-label={label} title={label} disabled={!does} onClick={does}>
      {sign}
    </button>
  )
}

/** Up, down and away for an item of a list. */
function Buttons({ list, index, name }: { list: Path; index: number; name: string }) {
  const session = useSession()
  const items = at(session.tree.peek(), list)
  const to = (place: number) =>
    Array.isArray(items) && place in items
      ? { does: () => session.set(list, at(moved(session.tree.value, list, index, place), list)) }
      : {}
  return (
    <span class="buttons">
      <Sign sign="↑" label={t('{name}: move up', { name })} {...to(index - 1)} />
      <Sign sign="↓" label={t('{name}: move down', { name })} {...to(index + 1)} />
      <Remove path={[...list, index]} name={name} />
    </span>
  )
}

function Remove({ path, name }: { path: Path; name: string }) {
  const session = useSession()
  const does = () => session.set(path, undefined)
  return <Sign sign="×" label={t('{name}: remove', { name })} does={does} />
}

/** A field that holds others: name, help, contents, mistakes. */
function Frame({
  field,
  path,
  kind,
  below = false,
  children,
}: FieldProps & { kind: string; below?: boolean; children: ComponentChildren }) {
  return (
    <fieldset class={`field ${kind}`} id={idOf(path)} tabIndex={-1}>
      <legend>{field.label}</legend>
      <p class="help">
        <Coded text={field.help} />
      </p>
      {children}
      <Sentences path={path} below={below} />
    </fieldset>
  )
}

function Add({ name, does }: { name: string; does: () => void }) {
  return (
    <button type="button" class="add" onClick={does}>
      {t('Add {name}', { name: name.toLowerCase() })}
    </button>
  )
}

/** The name of one item of a list. */
const singular = ({ label }: Field): string => label.replace(/s$/, '')

function QuantitiesField({ field, path, kind }: FieldProps & { kind: Of<'quantities'> }) {
  const session = useSession()
  const value = useValue(path)
  const items: unknown[] = Array.isArray(value) ? value : []
  const name = singular(field)
  return (
    <Frame field={field} path={path} kind="list">
      <ol class="items">
        {items.map((_, index) => (
          <li key={index}>
            <span class="place">{index + 1}</span>
            <Item field={kind.item} path={[...path, index]} label={`${name} ${index + 1}`} />
            <Buttons list={path} index={index} name={`${name} ${index + 1}`} />
          </li>
        ))}
      </ol>
      <Add
        name={name}
        does={() => session.set(path, [...items, items.at(-1) ?? kind.item.example])}
      />
    </Frame>
  )
}

function RecordField({ field, path, kind }: FieldProps & { kind: Of<'record'> }) {
  const session = useSession()
  const there = useValue(path) !== undefined
  const always = field.required || kind.fields.every((inner) => !inner.required)
  const put = (value: unknown) => session.set(path, value)
  const name = field.label.toLowerCase()
  return (
    <Frame field={field} path={path} kind="record" below={!there}>
      {(there || always) && <Fields fields={kind.fields} path={path} />}
      {!always && there && (
        <button type="button" class="add" onClick={() => put(undefined)}>
          {t('Remove {name}', { name })}
        </button>
      )}
      {!always && !there && (
        <Add name={name} does={() => put(recordOf(kind.fields, session.relative))} />
      )}
    </Frame>
  )
}

/** A record of a list by its number or place, its name and its direction. */
function nameOf(field: Field, record: unknown, index: number): string {
  const number = at(record, ['number'])
  const direction = at(record, ['angle']) ?? at(record, ['bearing'])
  const which = `${singular(field)} ${typeof number === 'number' ? number : index + 1}`
  const more = [at(record, ['name']), direction].map(textOf).filter(Boolean)
  return more.length ? `${which}: ${more.join(', ')}` : which
}

/** So many records lie open. */
const MANY = 4

function RecordsField({ field, path, kind }: FieldProps & { kind: Of<'records'> }) {
  const session = useSession()
  const value = useValue(path)
  const records: unknown[] = Array.isArray(value) ? value : []
  return (
    <Frame field={field} path={path} kind="records">
      {records.map((record, index) => {
        const name = nameOf(field, record, index)
        return (
          <Card
            key={index}
            path={[...path, index]}
            title={name}
            fields={kind.fields}
            open={records.length <= MANY}
            quiet={index > 0}
          >
            <Buttons list={path} index={index} name={name} />
          </Card>
        )
      })}
      <Add
        name={singular(field)}
        does={() =>
          session.set(path, [...records, another(records, kind.fields, session.relative)])
        }
      />
    </Frame>
  )
}

interface CardProps {
  readonly path: Path
  readonly title: ComponentChildren
  readonly fields: readonly Field[]
  readonly open?: boolean
  readonly quiet?: boolean
  readonly children: ComponentChildren
}

/** A record that can be folded, with its buttons. */
function Card({ path, title, fields, open = false, quiet = true, children }: CardProps) {
  return (
    <div class="card">
      <details id={idOf(path)} open={open}>
        <summary>{title}</summary>
        <div class="within">
          <Fields fields={fields} path={path} quiet={quiet} />
        </div>
      </details>
      {children}
      <Sentences path={path} />
    </div>
  )
}

function TableField({ field, path, kind }: FieldProps & { kind: Of<'table'> }) {
  const session = useSession()
  const [key, setKey] = useState('')
  const keys = Object.keys((useValue(path) ?? {}) as object)
  const add = () => {
    if (!key.trim() || keys.includes(key)) return
    session.set([...path, key.trim()], recordOf(kind.fields, session.relative))
    setKey('')
  }
  return (
    <Frame field={field} path={path} kind="table">
      {keys.map((name) => (
        <Card key={name} path={[...path, name]} title={<code>{name}</code>} fields={kind.fields}>
          <span class="buttons">
            <Remove path={[...path, name]} name={name} />
          </span>
        </Card>
      ))}
      <div class="taking">
        <input
          type="text"
          aria-label={t('{name}: key path', { name: field.label })}
          placeholder="cylinder.bore"
          value={key}
          onInput={(event) => setKey(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key !== 'Enter') return
            event.preventDefault()
            add()
          }}
        />
        <button type="button" class="add" onClick={add}>
          {t('Add')}
        </button>
      </div>
    </Frame>
  )
}
