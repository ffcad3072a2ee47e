import { Coded } from '../coded'
import { message, t } from '../language/messages'
import { choiceText } from './choices'
import { idOf, useSession } from './context'
import { Fit } from './fit'
import { TYPES, withLayout } from './layouts'
import { MountLayout } from './MountLayout'
import { AnyField, Fields, Folded } from './records'
import { EXPLICIT, type Field } from './schema'
import type { Placed } from './session'
import { at } from './tree'

interface Group {
  readonly title: string
  readonly keys: readonly string[]
  readonly open: boolean
}

const BLOCK = message('Block and mounts')
const COUNTERWEIGHTS = message('Counterweights and balance shafts')

/** The usual changes first. Keys of no group, new ones too, stand in the last. */
const GROUPS: readonly Group[] = [
  {
    title: message('Engine'),
    keys: ['name', 'cycle', 'rotation', 'firing_order', 'speed'],
    open: true,
  },
  { title: message('Layout'), keys: ['layout'], open: true },
  { title: message('Shafts, throws and weights'), keys: ['shaft', 'bore_pitch'], open: true },
  { title: message('Cylinder'), keys: ['cylinder'], open: true },
  { title: COUNTERWEIGHTS, keys: ['balance_factor', 'crankshaft', 'balance_shaft'], open: true },
  { title: message('Individual cylinders'), keys: ['cylinders'], open: false },
  { title: BLOCK, keys: ['block', 'mounts', 'foundation'], open: false },
  { title: message('Valves or ports'), keys: ['valves'], open: false },
  { title: message('Gas and load'), keys: ['gas', 'drive'], open: false },
  { title: message('Torsional vibration'), keys: ['torsion'], open: false },
]
const REST = message('Sources and notes')

/** The whole form of the engine file. */
export function EngineForm() {
  const session = useSession()
  const form = session.form.value
  if (!form) return <p class="help">{t('Loading the form …')}</p>
  const named = new Set(GROUPS.flatMap((group) => group.keys))
  const rest = {
    title: REST,
    keys: form.fields.filter((field) => !named.has(field.key)).map((field) => field.key),
    open: false,
  }
  // The explicit form has its counterweights at the shafts; that it can be fitted with others
  // stands here all the same.
  const groups = [...GROUPS, rest].map((group) => ({
    ...group,
    fields: group.keys.flatMap((key) => form.fields.filter((f) => f.key === key)),
  }))
  return (
    <form class="form" onSubmit={(event) => event.preventDefault()}>
      {groups
        .filter((group) => group.fields.length > 0 || group.title === COUNTERWEIGHTS)
        .map((group) => (
          <GroupOf key={`${form.type} ${group.title}`} {...group} />
        ))}
    </form>
  )
}

function GroupOf({ title, open, fields }: Omit<Group, 'keys'> & { fields: readonly Field[] }) {
  const session = useSession()
  const stands = title === BLOCK && at(session.tree.peek(), ['mounts']) !== undefined
  return (
    <Folded title={t(title)} open={open || stands} paths={fields.map((field) => [field.key])}>
      {() => (
        <>
          {title === 'Layout' && <LayoutType />}
          {title === COUNTERWEIGHTS && <Fit />}
          {title === BLOCK && <MountLayout />}
          {fields.map((field) => {
            const { kind, key } = field
            // A group with one table in it is that table: it needs no frame of its own.
            if (
              kind.is === 'record' &&
              fields.length === 1 &&
              !kind.fields.some((inner) => inner.required && key !== 'layout')
            )
              return (
                <div key={key} class="within" id={idOf([key])} tabIndex={-1}>
                  <p class="help">
                    <Coded text={(key === 'layout' && session.form.value?.help) || field.help} />
                  </p>
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
      <label for="edit:layout.type">{t('Type')}</label>
      <div class="taking">
        <select
          id="edit:layout.type"
          value={type}
          onChange={(event) => {
            const chosen = event.currentTarget.value
            if (chosen === EXPLICIT)
              void session.open(
                session.service.explicit(session.tree.value),
                t('The explicit form'),
              )
            else session.edit(withLayout(session.tree.value, chosen))
          }}
        >
          {TYPES.map((each) => (
            <option key={each} value={each}>
              {choiceText(each)}
            </option>
          ))}
          <option value={EXPLICIT}>{t('explicit: every shaft, throw and weight')}</option>
        </select>
      </div>
      <p class="help">
        {t('A new type starts with the same cylinders, evenly spaced throws and no firing order.')}
      </p>
    </div>
  )
}

/** Unfolds the field of a problem, or the nearest above it, and gives it the focus. */
export function jump(root: HTMLElement, problem: Placed): void {
  const element = nearest(root, problem.at)
  if (!element) return
  for (
    let fold = element.closest('details');
    fold;
    fold = fold.parentElement?.closest('details') ?? null
  )
    fold.open = true
  const reduced = matchMedia('(prefers-reduced-motion: reduce)').matches
  element.scrollIntoView({ block: 'center', behavior: reduced ? 'auto' : 'smooth' })
  element.focus({ preventScroll: true })
}

function nearest(root: HTMLElement, path: Placed['at']): HTMLElement | null {
  for (let length = path.length; length > 0; length--) {
    const element = root.querySelector<HTMLElement>(`#${CSS.escape(idOf(path.slice(0, length)))}`)
    if (element) return element
  }
  return null
}
