import type { App } from '../app'
import { cameraOf, type Ground } from './picture'

/** One turn of the engines as they are shown: frames at even angles, the last before the first. */
export interface Film {
  readonly frames: number
  readonly perSecond: number
  readonly ground: Ground
  readonly density: number
}

/** Kinds of films and the codes in which they are written; of a kind the first that can be. */
export const KINDS = {
  webm: ['vp09.00.40.08', 'vp09.00.51.08', 'vp8'],
  mp4: ['avc1.640028', 'avc1.640033', 'avc1.42E01F'],
  gif: [],
} as const satisfies Record<string, readonly string[]>
export type Kind = keyof typeof KINDS

/** Frames in a second: of a GIF as many as it can count in hundredths. */
export const RATES: Readonly<Record<Kind, number>> = { webm: 30, mp4: 30, gif: 20 }

/** Frames that a recorder sees before: one of each stroke. */
const LOOKS = 4

/** Tells how far it is, from 0 to 1. */
export type Progress = (share: number) => void

/** A wait that ends with the film. */
export function waited(milliseconds: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const over = (): void => reject(signal.reason)
    if (signal.aborted) return over()
    const timer = setTimeout(() => {
      signal.removeEventListener('abort', over)
      resolve()
    }, milliseconds)
    signal.addEventListener('abort', () => clearTimeout(timer), { once: true })
    signal.addEventListener('abort', over, { once: true })
  })
}

/** What takes the frames of a film one by one; `frame` resolves when the next may come. */
export interface Recorder {
  /** Sees some frames of the film before the first. */
  look?(canvas: HTMLCanvasElement): void
  frame(canvas: HTMLCanvasElement): Promise<void>
  done(): Promise<Blob>
  dispose(): void
}

/** Makes the recorder of a film. */
export type RecorderOf = (canvas: HTMLCanvasElement, film: Film, signal: AbortSignal) => Recorder

/**
 * Films a turn of the engines. The engine on the page stands still meanwhile; it is at the angle
 * at which it was when the film ends, and turns again if it did. Rejects when `signal` is aborted.
 */
export async function filmed(
  app: App,
  film: Film,
  recorder: (canvas: HTMLCanvasElement) => Promise<RecorderOf>,
  progress: Progress,
  signal: AbortSignal,
): Promise<Blob> {
  const { clock } = app
  const turning = clock.playing.peek()
  if (turning) clock.stop()
  const cycle = 360 * clock.turns.peek()
  const camera = cameraOf(app, film.density, film.ground, { even: true })
  let into: Recorder | null = null
  // as many decimals at all angles, so that nothing in the picture jumps
  const written = (degrees: number): string => degrees.toFixed(0)
  try {
    into = (await recorder(camera.canvas))(camera.canvas, film, signal)
    for (let look = 0; into.look && look < LOOKS; look++) {
      camera.take((cycle * look) / LOOKS, '0')
      into.look(camera.canvas)
    }
    for (let index = 0; index < film.frames; index++) {
      signal.throwIfAborted()
      const degrees = (cycle * index) / film.frames
      camera.take(degrees, written(degrees))
      await into.frame(camera.canvas)
      progress((index + 1) / film.frames)
    }
    return await into.done()
  } finally {
    into?.dispose()
    camera.end()
    if (turning) clock.play()
  }
}
