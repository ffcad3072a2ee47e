import { message, t } from '../language/messages'

/** The keys of the page and what they do, as far as the host has a use for them. */
const KEYS = [
  [message('space'), message('play or stop')],
  [message('comma, full stop'), message('1° back, 1° forward; 10° with shift')],
  [message('arrows'), message('the same, where nothing else uses them')],
  [message('page up, page down'), message('90° forward, 90° back')],
  [message('[ and ]'), message('the panel before, the next one')],
  [message('f'), message('full screen')],
  [message('p'), message('presentation: large type, no controls')],
  [message('e'), message('export pictures, videos, tables, files')],
  [message('?'), message('this list')],
  [message('escape'), message('leaves dialogs, presentation and full screen')],
] as const

export function KeyList() {
  return (
    <dl class="keys">
      {KEYS.map(([key, action]) => (
        <div key={key}>
          <dt>
            <kbd>{t(key)}</kbd>
          </dt>
          <dd>{t(action)}</dd>
        </div>
      ))}
    </dl>
  )
}
