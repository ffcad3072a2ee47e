import type { Exhibit, Exhibition } from '../exhibit'
import { addressState } from './address'
import type { Host, Spec } from './host'

/** What goes with one exhibit in a file: its figures and derivations by their keys. */
export interface Library {
  readonly charts: Readonly<Record<string, Spec>>
  readonly derivations: Readonly<Record<string, string>>
}

/** All that a file holds; `libraries` and `fitted` stand in the order of the exhibition's engines. */
export interface PageData {
  readonly exhibition: Exhibition
  readonly libraries: readonly Library[]
  readonly fitted: readonly (Library | null)[]
}

/** JSON, plain or packed: `{"encoding": "gzip+base64", "data": "..."}`. */
export async function unpacked(text: string): Promise<unknown> {
  const whole: unknown = JSON.parse(text)
  if (!isPacked(whole)) return whole
  return JSON.parse(await inflated(bytesOf(whole.data)))
}

/** Text that was packed with gzip. */
export async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))
  return new Response(stream).text()
}

function isPacked(value: unknown): value is { encoding: string; data: string } {
  return typeof value === 'object' && value !== null && 'encoding' in value && value.encoding === 'gzip+base64'
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64)
  const bytes = new Uint8Array(text.length)
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i)
  return bytes
}

/** What a file or a notebook can tell of its exhibits: all of it is there already. */
export function shelf(data: PageData): Pick<Host, 'chart' | 'derivation' | 'fitted'> {
  const libraries = new Map<Exhibit, Library>()
  const cured = new Map<Exhibit, Exhibit | null>()
  data.exhibition.engines.forEach((exhibit, index) => {
    const library = data.libraries[index]
    if (library) libraries.set(exhibit, library)
    const fitted = data.exhibition.fitted[index] ?? null
    cured.set(exhibit, fitted)
    const beside = data.fitted[index]
    if (fitted && beside) libraries.set(fitted, beside)
  })
  const taken = <T>(found: T | undefined, what: string): Promise<T> =>
    found === undefined ? Promise.reject(new Error(`${what} is not in this file.`)) : Promise.resolve(found)
  return {
    chart: (exhibit, key) => taken(libraries.get(exhibit)?.charts[key], 'This figure'),
    derivation: (exhibit, key) => taken(libraries.get(exhibit)?.derivations[key], 'This derivation'),
    fitted: (exhibit) => Promise.resolve(cured.get(exhibit) ?? null),
  }
}

const AGAIN = 'Write it again: crankstar page ENGINE -o FILE.html'

function isPageData(value: unknown): value is PageData {
  if (typeof value !== 'object' || value === null) return false
  const { exhibition, libraries, fitted } = value as Partial<PageData>
  const whole = (engine: Partial<Exhibit> | null) =>
    !!engine?.scene && !!engine.whirl && !!engine.total && !!engine.table
  const { engines } = exhibition ?? {}
  return Array.isArray(libraries) && Array.isArray(fitted) && !!engines?.length && engines.every(whole)
}

/** A file that was opened from disk or the web: everything is in it. */
export async function pageHost(holder: Document): Promise<Host> {
  const text = holder.getElementById('crankstar-data')?.textContent
  if (!text) throw new Error(`This file holds no engine. ${AGAIN}`)
  // What the browser says of data that are cut or changed helps nobody.
  const data = await unpacked(text).catch(() => null)
  if (!isPageData(data)) throw new Error(`This file is damaged: its engine cannot be read. ${AGAIN}`)
  return { kind: 'page', exhibition: data.exhibition, ...shelf(data), ...addressState() }
}
