import type { Places } from '../../motion'

/** Something of the engine that moves: told where the rods are, and the crank angle (radians). */
export interface Part {
  move(places: Places, theta: number): void
  dispose(): void
}
