import type { Host } from './host'

/** The state in the address, after `#`. It replaces the entry in the history: the back button leaves the page. */
export function addressState(): Pick<Host, 'readState' | 'writeState' | 'onState'> {
  return {
    readState: () => location.hash.slice(1),
    writeState: (text) => {
      if (text !== location.hash.slice(1))
        history.replaceState(history.state, '', `${location.pathname}${location.search}${text && `#${text}`}`)
    },
    onState: (changed) => {
      const told = (): void => changed(location.hash.slice(1))
      addEventListener('hashchange', told)
      return () => removeEventListener('hashchange', told)
    },
  }
}
