import type { Bytes } from './bytes'
import type { Chunk, Track } from './container'
import { type Film, type Recorder, waited } from './film'

/** Bits for each pixel of a frame: lines stay sharp, and a film of seconds some megabytes. */
const BITS = 0.2
const LEAST = 2_000_000
/** Frames that may wait for the encoder. */
const WAITING = 4
/** Milliseconds after which it is asked again. */
const PAUSE = 5

function settingsOf(codec: string, width: number, height: number, perSecond: number) {
  return {
    ...{ codec, width, height, framerate: perSecond },
    bitrate: Math.round(Math.max(LEAST, BITS * width * height * perSecond)),
    latencyMode: 'quality' as const, // no frame is left out
    ...(codec.startsWith('avc1') && { avc: { format: 'avc' as const } }),
  }
}

/** The first of some codes that the browser can write at a size; undefined for none. */
export async function encodable(
  codecs: readonly string[],
  { width, height, perSecond }: { width: number; height: number; perSecond: number },
): Promise<string | undefined> {
  if (typeof VideoEncoder !== 'function') return undefined
  for (const codec of codecs) {
    const settings = settingsOf(codec, width, height, perSecond)
    const answer = await VideoEncoder.isConfigSupported(settings).catch(() => null)
    if (answer?.supported) return codec
  }
  return undefined
}

/** A recorder of a film by the browser's encoder, each frame at its own time. */
export function encoding(codec: string, written: (track: Track) => Blob) {
  return (
    { width, height }: HTMLCanvasElement,
    { perSecond }: Film,
    signal: AbortSignal,
  ): Recorder => {
    const chunks: Chunk[] = []
    let description: Bytes = new Uint8Array()
    let failed: Error | null = null
    const encoder = new VideoEncoder({
      output: (chunk, metadata) => {
        const data = new Uint8Array(chunk.byteLength)
        chunk.copyTo(data)
        chunks.push({ data, key: chunk.type === 'key' })
        const told = metadata?.decoderConfig?.description
        if (told) description = copied(told)
      },
      error: (error) => {
        failed = error
      },
    })
    encoder.configure(settingsOf(codec, width, height, perSecond))
    let frames = 0
    const lasts = 1e6 / perSecond
    return {
      async frame(canvas) {
        const timestamp = Math.round(frames * lasts)
        const frame = new VideoFrame(canvas, { timestamp, duration: Math.round(lasts) })
        encoder.encode(frame, { keyFrame: frames % perSecond === 0 })
        frame.close()
        frames += 1
        do await waited(encoder.encodeQueueSize > WAITING ? PAUSE : 0, signal)
        while (!failed && encoder.encodeQueueSize > WAITING)
        if (failed) throw failed
      },
      async done() {
        await encoder.flush()
        if (failed) throw failed
        return written({ codec, description, width, height, perSecond, chunks })
      },
      dispose() {
        if (encoder.state !== 'closed') encoder.close()
      },
    }
  }
}

function copied(source: AllowSharedBufferSource): Bytes {
  const view = ArrayBuffer.isView(source)
    ? new Uint8Array(source.buffer, source.byteOffset, source.byteLength)
    : new Uint8Array(source)
  return Uint8Array.from(view)
}
