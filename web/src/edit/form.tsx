import { idOf, useSession } from './context'
import { Fit } from './fit'
import { TYPES, withLayout } from './layouts'
import { AnyField, Fields, Folded } from './records'
import { EXPLICIT, type Field } from './schema'
import type { Placed } from './session'

interface Group {
  readonly title: string
  readonly keys: readonly string[]
  readonly open: boolean
}

const COUNTERWEIGHTS = 'Counterweights and balance shafts'

/** What engineers change first stands first. Keys that no group names, new ones too, stand under the last. */
const GROUPS: readonly Group[] = [
  { title: 'Engine', keys: ['name', 'cycle', 'rotation', 'firing_order', 'speed'], open: true },
  { title: 'Layout', keys: ['layout'], open: true },
  { title: 'Shafts, throws and weights', keys: ['shaft', 'bore_pitch'], open: true },
  { title: 'Cylinder', keys: ['cylinder'], open: true },
  { title: COUNTERWEIGHTS, keys: ['balance_factor'], open: true },
  { title: 'Cylinders one by one', keys: ['cylinders'], open: false },
  { title: 'Block', keys: ['block'], open: false },
  { title: 'Valves or ports', keys: ['valves'], open: false },
]
const REST = 'Sources, notes and the rest'

/** The whole form of the engine file. */
export function EngineForm() {
  const session = useSession()
  const form = session.form.value
  if (!form) return <p class="help">The form is on its way ...</p>
  const named = new Set(GROUPS.flatMap((group) => group.keys))
  const rest = {
    title: REST,
    keys: form.fields.filter((field) => !named.has(field.key)).map((field) => field.key),
    open: false,
  }
  // The explicit form has its counterweights at the shafts; that it can be fitted with others stands here all the same.
  const groups = [...GROUPS, rest].map((group) => ({
    ...group,
    fields: group.keys.flatMap((key) => form.fields.filter((f) => f.key === key)),
  }))
  return (
    <form class="form" onSubmit={(event) => event.preventDefault()}>
      {groups
        .filter((group) => group.fields.length > 0 || group.title === COUNTERWEIGHTS)
        .map((group) => (
          <GroupOf key={`${form.type} ${group.title}`} title={group.title} open={group.open} fields={group.fields} />
        ))}
    </form>
  )
}

function GroupOf({ title, open, fields }: { title: string; open: boolean; fields: readonly Field[] }) {
  const session = useSession()
  return (
    <Folded title={title} open={open} paths={fields.map((field) => [field.key])}>
      {() => (
        <>
          {title === 'Layout' && <LayoutType />}
          {title === COUNTERWEIGHTS && <Fit />}
          {fields.map((field) => {
            const { kind, key } = field
            // A group with one table in it is that table: it needs no frame of its own.
            if (
              kind.is === 'record' &&
              fields.length === 1 &&
              !kind.fields.some((inner) => inner.required && key !== 'layout')
            )
              return (
                <div key={key} id={idOf([key])} tabIndex={-1}>
                  <p class="help">{key === 'layout' ? session.form.value?.help : field.help}</p>
                  <Fields fields={kind.fields} path={[key]} />
                </div>
              )
            return <AnyField key={key} field={field} path={[key]} />
          })}
        </>
      )}
    </Folded>
  )
}

/** The type of the layout; another one begins with the same cylinders. */
function LayoutType() {
  const session = useSession()
  const type = session.form.value?.type ?? EXPLICIT
  return (
    <div class="field">
      <label for="edit:layout.type">Type</label>
      <div class="taking">
        <select
          id="edit:layout.type"
          value={type}
          onChange={(event) => {
            const chosen = event.currentTarget.value
            if (chosen === EXPLICIT)
              void session.open(session.service.explicit(session.tree.value), 'The explicit form')
            else session.edit(withLayout(session.tree.value, chosen))
          }}
        >
          {TYPES.map((one) => (
            <option key={one} value={one}>
              {one}
            </option>
          ))}
          <option value={EXPLICIT}>explicit: every shaft, throw and weight</option>
        </select>
      </div>
      <p class="help">another type begins with the same cylinders, evenly spaced throws and no firing order</p>
    </div>
  )
}

/** Opens what a field is folded in, brings it into view and puts the focus on it; the nearest one above if it is not there itself. */
export function jump(root: HTMLElement, problem: Placed): void {
  const element = nearest(root, problem.at)
  if (!element) return
  for (let fold = element.closest('details'); fold; fold = fold.parentElement?.closest('details') ?? null)
    fold.open = true
  const reduced = matchMedia('(prefers-reduced-motion: reduce)').matches
  element.scrollIntoView({ block: 'center', behavior: reduced ? 'auto' : 'smooth' })
  element.focus({ preventScroll: true })
}

function nearest(root: HTMLElement, path: Placed['at']): HTMLElement | null {
  for (let length = path.length; length > 0; length--) {
    const found = root.querySelector<HTMLElement>(`#${CSS.escape(idOf(path.slice(0, length)))}`)
    if (found) return found
  }
  return null
}
