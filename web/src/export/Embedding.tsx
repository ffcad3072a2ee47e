import { useMemo, useRef } from 'preact/hooks'
import type { App } from '../app'
import { t } from '../language/messages'
import { snapshot, stateText } from '../state'
import { useApp } from '../ui/context'
import { CopyButton } from './CopyButton'
import { engineName } from './fileNames'

/** The size of the frame, pixels: the page has two columns in it. */
const [WIDTH, HEIGHT] = [1000, 640]

/** The frame that shows this page in another one, at the present view. */
export function embedding(app: App): string {
  const { host, store, clock, shown } = app
  const first = shown.peek()[0]
  const own = location.pathname.split('/').pop()
  const name =
    host.kind === 'page' && own ? own : `${first ? engineName(app, first) : 'engine'}.html`
  const angle = clock.playing.peek() ? null : Number(clock.degrees().toFixed(2))
  const state = { ...snapshot(store), angle, present: false, engine: '', beside: '' }
  const view = stateText({ ...state, beside: host.kind === 'page' ? store.beside.peek() : '' })
  const title = shown.peek().map((exhibit) => exhibit.name)
  const address = `${name}${view && `#${view}`}`
  const attributes = [
    `src="${escaped(address)}"`,
    `title="${escaped(title.join(' · '))}"`,
    `width="${WIDTH}" height="${HEIGHT}"`,
    'loading="lazy" allowfullscreen',
  ]
  return `<iframe ${attributes.join(' ')}></iframe>`
}

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;')

/** The code for a website; a notebook has no page of its own. */
export function Embedding() {
  const app = useApp()
  const field = useRef<HTMLTextAreaElement>(null)
  const code = useMemo(() => embedding(app), [app])
  if (app.host.kind === 'widget') return null
  return (
    <section>
      <h3>{t('In a website or in slides')}</h3>
      <p class="soft small">
        {app.host.kind === 'server'
          ? t('Save this page as one file, put it beside yours, and show it in a frame:')
          : t('Put this file beside yours, and show it in a frame:')}
      </p>
      <div class="code">
        <textarea
          ref={field}
          readOnly
          rows={3}
          spellcheck={false}
          aria-label={t('Code of the frame')}
          value={code}
          onFocus={(event) => event.currentTarget.select()}
        />
        <CopyButton text={code} label={t('Copy the code of the frame')} />
      </div>
    </section>
  )
}
