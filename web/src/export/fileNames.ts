import type { App } from '../app'
import type { Exhibit } from '../exhibit'

/** Letters of an engine in the name of a file. */
const LONGEST = 60

/** A text as a part of a file's name: letters and digits of any script, and dashes. */
export function slug(text: string): string {
  const plain = text
    .normalize('NFC')
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .slice(0, LONGEST)
  return plain.replace(/^-+|-+$/g, '')
}

/** The name or file by which an engine was asked for; null where it has been changed since. */
export function sourceName({ host, store }: App, exhibit: Exhibit): string | null {
  const { engines, fitted, sources = [] } = host.exhibition
  const place = engines.findIndex((one) => sameFile(one, exhibit))
  if (place >= 0) return sources[place] || null
  const named = store.engine.peek()
  return named && !named.startsWith('~') && !fitted.includes(exhibit) ? named : null
}

/** What an engine is called in file names: as it was asked for, else by its own name. */
export function engineName(app: App, exhibit: Exhibit): string {
  const asked = sourceName(app, exhibit)
  const base = asked
    ?.split(/[\\/]/)
    .pop()
    ?.replace(/\.(toml|json|xlsx)$/i, '')
  return slug(base || exhibit.name) || 'engine'
}

const sameFile = (one: Exhibit, other: Exhibit): boolean =>
  one.file === other.file || JSON.stringify(one.file) === JSON.stringify(other.file)

/** The name of a file that says what is in it: `v8-cross-plane-sheet-40deg.png`. */
export function fileName(app: App, kind: string, ...words: readonly string[]): string {
  const engines = app.shown.peek().map((exhibit) => engineName(app, exhibit))
  return `${[...engines, ...words.map(slug)].filter(Boolean).join('-')}.${kind}`
}

/** A crank angle in a file's name, such as `40deg`. */
export const angleWord = (degrees: number): string =>
  `${Number(degrees.toFixed(2))}deg`.replace('.', 'p').replace('-', 'minus')
