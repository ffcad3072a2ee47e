import type { ComponentChildren } from 'preact'
import { useEffect, useId, useRef } from 'preact/hooks'
import { t } from '../language/messages'
import { set } from '../state'
import { useApp } from './context'

/** A dialog of the page that is there while it is open; Escape closes it. */
export function Dialog({
  name,
  title,
  children,
}: {
  name: 'export' | 'keys'
  title: string
  children: ComponentChildren
}) {
  const { dialog } = useApp()
  const element = useRef<HTMLDialogElement>(null)
  const id = useId()
  const open = dialog.value === name
  useEffect(() => {
    if (open) element.current?.showModal()
  }, [open])
  if (!open) return null
  return (
    <dialog
      ref={element}
      class={`window ${name}`}
      aria-labelledby={id}
      onClose={() => set(dialog, '')}
      // also by a click beside it
      {...{ closedby: 'any' }}
    >
      <div class="window-inside">
        <header>
          <h2 id={id}>{title}</h2>
          <button type="button" class="plain" onClick={() => element.current?.close()}>
            {t('Close')}
          </button>
        </header>
        {children}
      </div>
    </dialog>
  )
}
