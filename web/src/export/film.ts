import type { App } from '../app'
import { cameraOf, type Ground } from './picture'

/** One turn of the engines as they are shown: frames at even angles, the last before the first. */
export interface Film {
  readonly frames: number
  readonly perSecond: number
  readonly ground: Ground
  readonly density: number
}

/** Kinds of films, in the order in which they are offered; of a kind the first that is known. */
export const KINDS = {
  webm: ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'],
  mp4: ['video/mp4;codecs=avc1.640028', 'video/mp4;codecs=avc1.42E01E', 'video/mp4'],
  gif: [],
} as const satisfies Record<string, readonly string[]>
export type Kind = keyof typeof KINDS

/** Frames in a second: of a GIF as many as it can count in hundredths. */
export const RATES: Readonly<Record<Kind, number>> = { webm: 30, mp4: 30, gif: 20 }

/** How a browser calls the kind of film that it can record; undefined where it cannot. */
export function recordable(kind: Kind): string | undefined {
  const known = (type: string): boolean =>
    typeof MediaRecorder === 'function' && MediaRecorder.isTypeSupported(type)
  return KINDS[kind].find(known)
}

/** The kinds of films that this browser makes. */
export const kinds = (): readonly Kind[] =>
  (Object.keys(KINDS) as Kind[]).filter((kind) => kind === 'gif' || recordable(kind))

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

/**
 * Films a turn of the engines. The engine on the page stands still meanwhile; it is at the angle
 * at which it was when the film ends, and turns again if it did. Rejects when `signal` is aborted.
 */
export async function filmed(
  app: App,
  film: Film,
  recorder: (canvas: HTMLCanvasElement, film: Film, signal: AbortSignal) => Recorder,
  progress: Progress,
  signal: AbortSignal,
): Promise<Blob> {
  const { clock } = app
  const turning = clock.playing.peek()
  if (turning) clock.stop()
  const cycle = 360 * clock.turns.peek()
  const camera = cameraOf(app, film.density, film.ground, { even: true })
  const into = recorder(camera.canvas, film, signal)
  // as many decimals at all angles, so that nothing in the picture jumps
  const written = (degrees: number): string => degrees.toFixed(0)
  try {
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
    into.dispose()
    camera.end()
    if (turning) clock.play()
  }
}
