import type { ComponentChildren, JSX } from 'preact'
import { useState } from 'preact/hooks'
import { another, recordOf } from './beginnings'
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
import { shown } from './quantity'
import type { Field, Kind } from './schema'
import { at, moved, type Path, within } from './tree'

type Of<T extends Kind['is']> = Extract<Kind, { is: T }>

/** Keys that lie open in a table; all others are under "More", unless the table is as short as that. */
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
export function Fields({ fields, path, quiet = false }: { fields: readonly Field[]; path: Path; quiet?: boolean }) {
  const session = useSession()
  const here = at(session.tree.peek(), path)
  const chief = fields.filter((field) => field.required || OPEN.has(field.key))
  const open = chief.length === 0 || fields.length <= FEW ? fields : chief
  const folded = fields.filter((field) => !open.includes(field) && field.kind.is !== 'fixed')
  const given = folded.filter((field) => at(here, [field.key]) !== undefined)
  const each = (list: readonly Field[]) =>
    list.map((field) => <AnyField key={field.key} field={field} path={[...path, field.key]} quiet={quiet} />)
  return (
    <>
      {each(open)}
      {folded.length > 0 && (
        <Folded
          title={`More: ${folded.map((field) => field.label.toLowerCase()).join(', ')}`}
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
  /** What is in it: a mistake there is told in its title. */
  readonly paths: readonly Path[]
  readonly children: () => ComponentChildren
}

/** What is drawn only once it has been opened, or has a mistake in it; it stays in the page after that. */
export function Folded({ title, open, paths, children }: FoldedProps) {
  const [begins] = useState(open)
  const [seen, setSeen] = useState(open)
  const wrong = useSession().problems.value.filter((problem) => paths.some((path) => within(problem.at, path))).length
  return (
    <details class="folded" open={begins} onToggle={(event) => event.currentTarget.open && setSeen(true)}>
      <summary>
        {title}
        {wrong > 0 && <span class="count"> {wrong === 1 ? 'a mistake' : `${wrong} mistakes`}</span>}
      </summary>
      <div class="within">{(seen || wrong > 0) && children()}</div>
    </details>
  )
}

/** Up, down and away for an item of a list. */
function Buttons({ list, index, count, name }: { list: Path; index: number; count: number; name: string }) {
  const session = useSession()
  const to = (place: number) => session.set(list, at(moved(session.tree.value, list, index, place), list))
  return (
    <span class="buttons">
      <button type="button" aria-label={`${name}: up`} title="up" disabled={index === 0} onClick={() => to(index - 1)}>
        ↑
      </button>
      <button
        type="button"
        aria-label={`${name}: down`}
        title="down"
        disabled={index === count - 1}
        onClick={() => to(index + 1)}
      >
        ↓
      </button>
      <button
        type="button"
        aria-label={`${name}: remove`}
        title="remove"
        onClick={() => session.set([...list, index], undefined)}
      >
        ×
      </button>
    </span>
  )
}

function QuantitiesField({ field, path, kind }: FieldProps & { kind: Of<'quantities'> }) {
  const session = useSession()
  const value = useValue(path)
  const items: unknown[] = Array.isArray(value) ? value : []
  const id = idOf(path)
  const name = field.label.replace(/s$/, '')
  return (
    <fieldset class="field list" id={id} tabIndex={-1}>
      <legend>{field.label}</legend>
      <p class="help">{field.help}</p>
      <ol class="items">
        {items.map((_, index) => (
          <li key={index}>
            <span class="place">{index + 1}</span>
            <Item field={kind.item} path={[...path, index]} label={`${name} ${index + 1}`} />
            <Buttons list={path} index={index} count={items.length} name={`${name} ${index + 1}`} />
          </li>
        ))}
      </ol>
      <button
        type="button"
        class="add"
        onClick={() => session.set(path, [...items, items.at(-1) ?? kind.item.example])}
      >
        Add {name.toLowerCase()}
      </button>
      <Sentences path={path} />
    </fieldset>
  )
}

function RecordField({ field, path, kind }: FieldProps & { kind: Of<'record'> }) {
  const session = useSession()
  const there = useValue(path) !== undefined
  const id = idOf(path)
  const always = field.required || kind.fields.every((inner) => !inner.required)
  return (
    <fieldset class="field record" id={id} tabIndex={-1}>
      <legend>{field.label}</legend>
      <p class="help">{field.help}</p>
      {(there || always) && <Fields fields={kind.fields} path={path} />}
      {!always && (
        <button
          type="button"
          class="add"
          onClick={() => session.set(path, there ? undefined : recordOf(kind.fields, session.tree.value))}
        >
          {there ? `Leave out ${field.label.toLowerCase()}` : `Give ${field.label.toLowerCase()}`}
        </button>
      )}
      <Sentences path={path} below={!there} />
    </fieldset>
  )
}

/** A record of a list, by what tells it from the others: its number or place, its name, where it points. */
function nameOf(kind: string, record: unknown, index: number): string {
  const number = at(record, ['number'])
  const name = at(record, ['name'])
  const angle = at(record, ['angle']) ?? at(record, ['bearing'])
  const which = `${kind.replace(/s$/, '')} ${typeof number === 'number' ? number : index + 1}`
  const said = [name, angle].filter((one) => one !== undefined && one !== null && one !== '')
  return said.length ? `${which}: ${said.map(shown).join(', ')}` : which
}

const MANY = 4

function RecordsField({ field, path, kind }: FieldProps & { kind: Of<'records'> }) {
  const session = useSession()
  const value = useValue(path)
  const records: unknown[] = Array.isArray(value) ? value : []
  const id = idOf(path)
  const one = field.label.replace(/s$/, '').toLowerCase()
  return (
    <fieldset class="field records" id={id} tabIndex={-1}>
      <legend>{field.label}</legend>
      <p class="help">{field.help}</p>
      {records.map((record, index) => (
        <div key={index} class="card">
          <details id={idOf([...path, index])} open={records.length <= MANY}>
            <summary>{nameOf(field.label, record, index)}</summary>
            <div class="within">
              <Fields fields={kind.fields} path={[...path, index]} quiet={index > 0} />
            </div>
          </details>
          <Buttons list={path} index={index} count={records.length} name={nameOf(field.label, record, index)} />
          <Sentences path={[...path, index]} />
        </div>
      ))}
      <button
        type="button"
        class="add"
        onClick={() => session.set(path, [...records, another(records, kind.fields, session.tree.value)])}
      >
        Add {one}
      </button>
      <Sentences path={path} />
    </fieldset>
  )
}

function TableField({ field, path, kind }: FieldProps & { kind: Of<'table'> }) {
  const session = useSession()
  const [key, setKey] = useState('')
  const value = useValue(path)
  const keys = Object.keys((value ?? {}) as object)
  const id = idOf(path)
  const add = () => {
    if (!key.trim() || keys.includes(key)) return
    session.set([...path, key.trim()], recordOf(kind.fields, session.tree.value))
    setKey('')
  }
  return (
    <fieldset class="field table" id={id} tabIndex={-1}>
      <legend>{field.label}</legend>
      <p class="help">{field.help}</p>
      {keys.map((one) => (
        <div key={one} class="card">
          <details id={idOf([...path, one])}>
            <summary>
              <code>{one}</code>
            </summary>
            <div class="within">
              <Fields fields={kind.fields} path={[...path, one]} quiet />
            </div>
          </details>
          <span class="buttons">
            <button
              type="button"
              aria-label={`${one}: remove`}
              title="remove"
              onClick={() => session.set([...path, one], undefined)}
            >
              ×
            </button>
          </span>
          <Sentences path={[...path, one]} />
        </div>
      ))}
      <div class="taking">
        <input
          type="text"
          aria-label={`${field.label}: key path`}
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
          Add
        </button>
      </div>
      <Sentences path={path} />
    </fieldset>
  )
}
