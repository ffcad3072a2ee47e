import { useState } from 'preact/hooks'
import { sessionOf } from '../edit/session'
import { t } from '../language/messages'
import { useApp } from './context'

/** The name of an engine as heading; where a server edits engines, a click renames the first. */
export function EngineName({ index }: { index: number }) {
  const { host, shown, engines, put, store } = useApp()
  const [writing, setWriting] = useState(false)
  const exhibit = shown.value[index]
  const own = engines.value[0]
  if (!exhibit) return null
  if (!host.service || !own || index > 0 || store.fitted.value) return <h1>{exhibit.name}</h1>
  const session = sessionOf(host.service, own, put)
  const done = (text: string): void => {
    setWriting(false)
    const name = text.trim()
    if (name && name !== exhibit.name) session.edit({ ...session.tree.peek(), name })
  }
  if (!writing)
    return (
      <h1>
        <button
          type="button"
          class="plain rename"
          title={t('Rename the engine')}
          onClick={() => setWriting(true)}
        >
          {exhibit.name}
        </button>
      </h1>
    )
  return (
    <h1>
      <input
        type="text"
        class="rename"
        aria-label={t('Name of the engine')}
        value={exhibit.name}
        maxLength={200}
        ref={(box) => box?.focus()}
        onBlur={(event) => done(event.currentTarget.value)}
        onKeyDown={(event) => {
          event.stopPropagation()
          if (event.key === 'Enter') done(event.currentTarget.value)
          if (event.key === 'Escape') setWriting(false)
        }}
      />
    </h1>
  )
}
