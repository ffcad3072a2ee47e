import type { Places } from '../../motion'

/** A moving part of the engine, placed by the rods and the crank angle (radians). */
export interface Part {
  move(places: Places, theta: number): void
  dispose(): void
}
