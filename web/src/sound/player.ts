import { type ReadonlySignal, signal } from '@preact/signals'
import type { Exhaust } from '../exhibit'
import { channelsOf, cyclesAt, echoesOf, gainOf, heard } from './exhaust'

/** Seconds in which a sound comes and goes, and in which it takes on another speed. */
const FADE = 0.03
const GLIDE = 0.08
/** Seconds after which nothing is left of a sound that fades. */
const LAST = 6 * FADE

/** The exhaust of an engine in an audio context. */
export interface Source {
  /** Turns to another speed, rpm. */
  tune(rpm: number): void
  /** Fades it out, and ends it. */
  end(): void
}

/**
 * What a pulse becomes in a pipe with an open end, `y(s) = x(s) - r y(s - back)`: itself and its
 * echoes, as far as they can be heard. A loop of nodes would be a block of samples longer.
 */
function echoesIn(context: BaseAudioContext, { back, reflected }: Exhaust): AudioBuffer {
  const taps = echoesOf(reflected)
  const step = Math.max(1, Math.round(back * context.sampleRate))
  const buffer = context.createBuffer(1, step * (taps.length - 1) + 1, context.sampleRate)
  const samples = buffer.getChannelData(0)
  taps.forEach((tap, index) => {
    samples[step * index] = tap
  })
  return buffer
}

/** Puts the exhaust of an engine into a context, which a click has begun or which is offline. */
export function sourceIn(context: BaseAudioContext, exhaust: Exhaust, rpm: number): Source {
  const waves = channelsOf(exhaust).map((shares) => heard(exhaust, shares))
  const level = gainOf(waves, exhaust.reflected)
  const out = context.createGain()
  const now = context.currentTime
  out.gain.setValueAtTime(0, now)
  out.gain.linearRampToValueAtTime(level, now + FADE)
  const echoes = echoesIn(context, exhaust)
  const merger = context.createChannelMerger(waves.length)
  merger.connect(out).connect(context.destination)
  const oscillators = waves.map((wave, channel) => {
    const oscillator = context.createOscillator()
    oscillator.setPeriodicWave(
      context.createPeriodicWave(wave.real, wave.imag, { disableNormalization: true }),
    )
    oscillator.frequency.setValueAtTime(cyclesAt(rpm, exhaust), now)
    const pipe = context.createConvolver()
    pipe.normalize = false
    pipe.buffer = echoes
    oscillator.connect(pipe).connect(merger, 0, channel)
    oscillator.start(now)
    return oscillator
  })
  return {
    tune(next) {
      for (const { frequency } of oscillators)
        frequency.setTargetAtTime(cyclesAt(next, exhaust), context.currentTime, GLIDE)
    },
    end() {
      const last = context.currentTime + LAST
      out.gain.setTargetAtTime(0, context.currentTime, FADE)
      for (const oscillator of oscillators) oscillator.stop(last)
    },
  }
}

/** Plays one engine at a time, and nothing without being asked. */
export interface Player {
  /** The place of the engine that is heard; null for none. */
  readonly playing: ReadonlySignal<number | null>
  /** Rejects where the browser has no sound. */
  play(place: number, exhaust: Exhaust, rpm: number): Promise<void>
  tune(rpm: number): void
  stop(): void
  /** Ends it for good. */
  dispose(): void
}

export function createPlayer(): Player {
  const playing = signal<number | null>(null)
  let context: AudioContext | null = null
  let source: Source | null = null
  let later = 0
  const stop = (): void => {
    if (!source) return
    source.end()
    source = null
    playing.value = null
    // a context without sound would keep the loudspeakers awake
    later = window.setTimeout(() => void context?.suspend(), 1e3 * LAST)
  }
  const seen = (): void => {
    if (document.visibilityState === 'hidden') stop()
  }
  document.addEventListener('visibilitychange', seen)
  return {
    playing,
    async play(place, exhaust, rpm) {
      stop()
      window.clearTimeout(later)
      context ??= new AudioContext({ latencyHint: 'playback' })
      source = sourceIn(context, exhaust, rpm)
      playing.value = place
      return context.resume()
    },
    tune: (rpm) => source?.tune(rpm),
    stop,
    dispose() {
      document.removeEventListener('visibilitychange', seen)
      stop()
      window.clearTimeout(later)
      const ending = context
      context = null
      // after it has faded
      window.setTimeout(() => void ending?.close(), 1e3 * LAST)
    },
  }
}
