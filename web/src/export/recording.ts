import { type Film, type Recorder, waited } from './film'

/** Bits for each pixel of a frame: lines stay sharp, and a film of seconds some megabytes. */
const BITS = 0.2
const LEAST = 2_000_000

/**
 * A recorder of a film by the browser. It counts real time, so that it is stopped while a frame is
 * drawn: however slow that is, each frame lasts as long as it should.
 */
export function recording(type: string) {
  return (canvas: HTMLCanvasElement, { perSecond }: Film, signal: AbortSignal): Recorder => {
    const stream = canvas.captureStream(0)
    const [track] = stream.getVideoTracks() as CanvasCaptureMediaStreamTrack[]
    const pixels = canvas.width * canvas.height
    const recorder = new MediaRecorder(stream, {
      mimeType: type,
      videoBitsPerSecond: Math.max(LEAST, BITS * pixels * perSecond),
    })
    const parts: Blob[] = []
    recorder.ondataavailable = ({ data }) => parts.push(data)
    const ended = new Promise<void>((resolve, reject) => {
      recorder.onstop = () => resolve()
      recorder.onerror = () => reject(new Error('The browser stopped recording.'))
    })
    ended.catch(() => {}) // heard by `done`
    return {
      async frame() {
        if (recorder.state === 'inactive') {
          recorder.start()
          recorder.pause()
        }
        recorder.resume()
        track?.requestFrame()
        await waited(1000 / perSecond, signal)
        recorder.pause()
      },
      async done() {
        // the last frame once more, or it would last no time
        recorder.resume()
        track?.requestFrame()
        await waited(1, signal)
        recorder.stop()
        await ended
        return new Blob(parts, { type: type.split(';')[0] ?? type })
      },
      dispose() {
        if (recorder.state !== 'inactive') recorder.stop()
        track?.stop()
      },
    }
  }
}
