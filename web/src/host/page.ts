import { bytesOf } from '../base64'
import { inflated } from '../deflated'
import type { Exhibit, Exhibition } from '../exhibit'
import { t } from '../language/messages'
import { addressState } from './address'
import { drawing, ofPage } from './drawing'
import type { Host, Spec } from './host'

/** Figures and derivations of one exhibit by their keys. */
export interface Library {
  readonly charts: Readonly<Record<string, Spec>>
  readonly derivations: Readonly<Record<string, string>>
}

/** The data of a file; `libraries` and `fitted` in the order of the engines. */
export interface PageData {
  readonly exhibition: Exhibition
  readonly libraries: readonly Library[]
  readonly fitted: readonly (Library | null)[]
  /** What differs in other units, by their name. */
  readonly units?: Readonly<Record<string, Differences>>
}

interface Differences {
  readonly engines: readonly Partial<Exhibit>[]
  readonly cured: readonly (Partial<Exhibit> | null)[]
  readonly libraries: readonly Library[]
  readonly fitted: readonly (Library | null)[]
}

/** An exhibit and its figures with what differs in other units. */
function changed(library: Library | null | undefined, by: Library | null | undefined): Library {
  return {
    charts: { ...library?.charts, ...by?.charts },
    derivations: { ...library?.derivations, ...by?.derivations },
  }
}

/** JSON, plain or packed: `{"encoding": "gzip+base64", "data": "..."}`. */
export async function unpacked(text: string): Promise<unknown> {
  const whole: unknown = JSON.parse(text)
  if (!isPacked(whole)) return whole
  return JSON.parse(await inflated(bytesOf(whole.data)))
}

function isPacked(value: unknown): value is { encoding: string; data: string } {
  return (
    typeof value === 'object' &&
    value !== null &&
    'encoding' in value &&
    value.encoding === 'gzip+base64'
  )
}

/** Charts, derivations and fitted engines that a file holds. */
export function shelf(data: PageData): Pick<Host, 'chart' | 'derivation' | 'fitted' | 'inUnits'> {
  const libraries = new Map<Exhibit, Library>()
  const cured = new Map<Exhibit, Exhibit | null>()
  const inOthers = new Map<Exhibit, Map<string, Exhibit>>()
  data.exhibition.engines.forEach((exhibit, index) => {
    const library = data.libraries[index]
    if (library) libraries.set(exhibit, library)
    const fitted = data.exhibition.fitted[index] ?? null
    cured.set(exhibit, fitted)
    const beside = data.fitted[index]
    if (fitted && beside) libraries.set(fitted, beside)
    const others = new Map([[exhibit.units.chosen, exhibit]])
    for (const [name, differences] of Object.entries(data.units ?? {})) {
      const other = { ...exhibit, ...differences.engines[index] }
      others.set(name, other)
      libraries.set(other, changed(library, differences.libraries[index]))
      const after = fitted && { ...fitted, ...differences.cured[index] }
      cured.set(other, after)
      if (after) libraries.set(after, changed(beside, differences.fitted[index]))
    }
    for (const other of others.values()) inOthers.set(other, others)
  })
  const held = <T>(item: T | undefined, missing: string): Promise<T> =>
    item === undefined ? Promise.reject(new Error(missing)) : Promise.resolve(item)
  return {
    chart: (exhibit, key) =>
      held(libraries.get(exhibit)?.charts[key], t('This file does not hold the figure.')),
    derivation: (exhibit, key) =>
      held(libraries.get(exhibit)?.derivations[key], t('This file does not hold the derivation.')),
    fitted: (exhibit) => Promise.resolve(cured.get(exhibit) ?? null),
    inUnits: (exhibit, units) =>
      held(
        inOthers.get(exhibit)?.get(units),
        t('This file does not hold the units {units}. Write it with --units.', { units }),
      ),
  }
}

function isPageData(value: unknown): value is PageData {
  if (typeof value !== 'object' || value === null) return false
  const { exhibition, libraries, fitted } = value as Partial<PageData>
  const whole = (engine: Partial<Exhibit> | null) =>
    !!engine?.scene && !!engine.whirl && !!engine.total && !!engine.table
  const { engines } = exhibition ?? {}
  return (
    Array.isArray(libraries) && Array.isArray(fitted) && !!engines?.length && engines.every(whole)
  )
}

/** A file that was opened from disk or the web: everything is in it. */
export async function pageHost(holder: Document): Promise<Host> {
  const text = holder.getElementById('crankstar-data')?.textContent
  // The browser's own words about incomplete data help nobody.
  const data = text ? await unpacked(text).catch(() => null) : null
  if (!isPageData(data)) {
    const command = 'crankstar page ENGINE -o FILE.html'
    throw new Error(
      t('The engine in this file cannot be read. Write the file again: {command}', { command }),
    )
  }
  return {
    kind: 'page',
    exhibition: data.exhibition,
    written: holder.documentElement.lang,
    anyUnits: false,
    ...shelf(data),
    drawing: drawing(() => ofPage(holder)),
    ...addressState(),
  }
}
