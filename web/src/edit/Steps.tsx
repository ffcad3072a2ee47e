import { useState } from 'preact/hooks'
import type { Control } from '../exhibit'
import type { Tree } from '../host/host'
import { t } from '../language/messages'
import { changes } from './changes'
import { useSession } from './context'
import { valueIn } from './control'
import { textOf } from './quantity'

/** Steps that are listed: of more, those about the present one. */
const LISTED = 40
/** Keys that are named of a step; where more changed it is called by the engine's name. */
const NAMED = 3

/** The words of a key in an engine file, where one need not have read of it. */
function keyText(path: string): string {
  if (path === 'firing_order') return t('Firing order')
  return path === 'layout.throws' ? t('Crank throws') : path
}

/** What a step did, in a few words: the control that was moved, or the keys. */
export function stepText(
  before: Tree | undefined,
  after: Tree,
  controls: readonly Control[] = [],
): string {
  const name = String(after.name ?? '')
  if (!before) return t('Opened: {name}', { name })
  const found = changes(before, after).filter(({ path }) => path !== 'name')
  const [first] = found
  if (!first) return t('Name: {name}', { name })
  if (found.length > NAMED) return name
  const moved = controls.find(({ sets }) =>
    found.every(({ path }) => sets.some((setting) => setting.path === path)),
  )
  if (moved) {
    const unit = moved.unit && ` ${moved.unit}`
    const [from, to] = [before, after].map((tree) => textOf(valueIn(tree, moved)))
    return `${moved.label}: ${from} → ${to}${unit}`
  }
  const nothing = t('nothing')
  return found
    .map(({ path, from, to }) => `${keyText(path)}: ${from || nothing} → ${to || nothing}`)
    .join('; ')
}

/** All that was done, to go back to with a click; what was undone stands after it. */
export function Steps({ controls }: { controls: readonly Control[] }) {
  const session = useSession()
  const [open, setOpen] = useState(false)
  const { all, at } = session.steps.value
  const first = Math.max(0, Math.min(at - LISTED / 2, all.length - LISTED))
  return (
    <details class="folded steps" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{t('History ({count})', { count: all.length })}</summary>
      {open && (
        <ol start={first + 1}>
          {all.slice(first, first + LISTED).map((tree, index) => {
            const step = first + index
            return (
              <li key={step} class={step > at ? 'undone' : ''}>
                <button
                  type="button"
                  class="plain"
                  aria-current={step === at ? 'step' : undefined}
                  onClick={() => session.goTo(step)}
                >
                  {stepText(all[step - 1], tree, controls)}
                </button>
              </li>
            )
          })}
        </ol>
      )}
    </details>
  )
}
