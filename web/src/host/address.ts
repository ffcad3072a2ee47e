import type { Host } from './host'

/**
 * The state in the address, after `#`; the entry in the history is replaced, so that the back
 * button leaves the page. The language is that of `?lang=ru`, else that of the document.
 */
export function addressState(): Pick<Host, 'language' | 'readState' | 'writeState' | 'onState'> {
  return {
    language: new URLSearchParams(location.search).get('lang') ?? document.documentElement.lang,
    readState: () => location.hash.slice(1),
    writeState: (text) => {
      if (text === location.hash.slice(1)) return
      const address = `${location.pathname}${location.search}${text && `#${text}`}`
      history.replaceState(history.state, '', address)
    },
    onState: (changed) => {
      const listener = (): void => changed(location.hash.slice(1))
      addEventListener('hashchange', listener)
      return () => removeEventListener('hashchange', listener)
    },
  }
}
