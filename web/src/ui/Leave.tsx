import { useEffect, useRef } from 'preact/hooks'
import { t } from '../language/messages'
import { useApp } from './context'
import { isFull, present } from './presenting'

/** The way out of a presentation, for who does not know the key. */
export function Leave() {
  const app = useApp()
  const on = app.store.present.value
  const filled = useRef(false)
  useEffect(() => {
    filled.current = isFull()
    // the browser keeps Escape for itself while the page fills the screen
    const changed = (): void => {
      const now = isFull()
      if (filled.current && !now && app.store.present.peek()) present(app, false)
      filled.current = now
    }
    document.addEventListener('fullscreenchange', changed)
    return () => document.removeEventListener('fullscreenchange', changed)
  }, [app])
  if (!on) return null
  return (
    <button type="button" class="leave" onClick={() => present(app, false)}>
      {t('End presentation')} <kbd>Esc</kbd>
    </button>
  )
}
