import { useState } from 'preact/hooks'
import type { Tree } from '../host/host'
import { t } from '../language/messages'
import { changes } from './changes'
import { useSession } from './context'

/** Steps that are listed: of more, those about the present one. */
const LISTED = 40
/** Keys that are named of a step; where more changed it is called by the engine's name. */
const NAMED = 3

/** What a step did, in a few words. */
export function stepText(before: Tree | undefined, after: Tree): string {
  const name = String(after.name ?? '')
  if (!before) return t('Opened: {name}', { name })
  const found = changes(before, after).filter(({ path }) => path !== 'name')
  const [first] = found
  if (!first) return t('Name: {name}', { name })
  if (found.length > NAMED) return name
  const nothing = t('nothing')
  return found
    .map(({ path, from, to }) => `${path}: ${from || nothing} → ${to || nothing}`)
    .join('; ')
}

/** All that was done, to go back to with a click; what was undone stands after it. */
export function Steps() {
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
                  {stepText(all[step - 1], tree)}
                </button>
              </li>
            )
          })}
        </ol>
      )}
    </details>
  )
}
