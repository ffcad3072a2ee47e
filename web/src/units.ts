import type { Exhibit } from './exhibit'

const KEPT = 'crankstar.units'

/** The units that were chosen on this machine before; empty for none. */
export function keptUnits(): string {
  try {
    return localStorage.getItem(KEPT) ?? ''
  } catch {
    return '' // a browser may keep nothing for files
  }
}

export function keepUnits(units: string): void {
  try {
    if (units) localStorage.setItem(KEPT, units)
    else localStorage.removeItem(KEPT)
  } catch {
    // then the link still holds them
  }
}

/** Engines in other units than those they came in, each requested once. */
export class InUnits {
  readonly #made = new Map<Exhibit, Map<string, Exhibit>>()

  /** The engine in these units, if it is there; in those it came in if none are named. */
  of(exhibit: Exhibit, units: string): Exhibit | undefined {
    if (!units || exhibit.units.chosen === units) return exhibit
    return this.#made.get(exhibit)?.get(units)
  }

  /** Keeps the answer for an engine. */
  put(exhibit: Exhibit, units: string, other: Exhibit): void {
    const known = this.#made.get(exhibit) ?? new Map<string, Exhibit>()
    this.#made.set(exhibit, known.set(units, other))
  }
}
