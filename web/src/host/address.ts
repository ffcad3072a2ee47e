import type { Host } from './host'

/**
 * The state in the address, after `#`. What is another visit (`visits.ts`) is an entry of its own,
 * so that Back and Forward step through what was looked at; all else replaces the entry. An address
 * that was changed from outside and is not heard of yet is left. The language is that of `?lang=ru`,
 * else that of the document.
 */
export function addressState(): Pick<Host, 'language' | 'readState' | 'writeState' | 'onState'> {
  let known = location.hash
  return {
    language: new URLSearchParams(location.search).get('lang') ?? document.documentElement.lang,
    readState: () => location.hash.slice(1),
    writeState: (text, visit = false) => {
      if (location.hash !== known || text === known.slice(1)) return
      const address = `${location.pathname}${location.search}${text && `#${text}`}`
      if (visit) history.pushState(null, '', address)
      else history.replaceState(history.state, '', address)
      known = location.hash
    },
    onState: (changed) => {
      const listener = (): void => {
        known = location.hash
        changed(known.slice(1))
      }
      addEventListener('hashchange', listener)
      return () => removeEventListener('hashchange', listener)
    },
  }
}
