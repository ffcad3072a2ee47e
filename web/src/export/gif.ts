import { applyPalette, GIFEncoder, quantize } from 'gifenc'
import { type Film, type Recorder, waited } from './film'

const COLOURS = 256

function joined(pictures: Uint8ClampedArray[]): Uint8ClampedArray {
  const all = new Uint8ClampedArray(pictures.reduce((sum, { length }) => sum + length, 0))
  let at = 0
  for (const picture of pictures.splice(0)) {
    all.set(picture, at)
    at += picture.length
  }
  return all
}

/** A recorder of an animated GIF that begins again when it ends. */
export function gif(_: HTMLCanvasElement, { perSecond }: Film, signal: AbortSignal): Recorder {
  const encoder = GIFEncoder()
  const delay = 1000 / perSecond
  const seen: Uint8ClampedArray[] = []
  let palette: number[][] | null = null
  const pixels = (canvas: HTMLCanvasElement): Uint8ClampedArray =>
    canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ??
    new Uint8ClampedArray()
  return {
    look(canvas) {
      seen.push(pixels(canvas))
    },
    async frame(canvas) {
      const { width, height } = canvas
      const data = pixels(canvas)
      // the same at all angles, or resting colours would flicker
      palette ??= quantize(joined(seen.length ? seen : [data]), COLOURS)
      encoder.writeFrame(applyPalette(data, palette), width, height, { palette, delay, repeat: 0 })
      await waited(0, signal) // the page stays alive
    },
    async done() {
      encoder.finish()
      return new Blob([encoder.bytes() as Uint8Array<ArrayBuffer>], { type: 'image/gif' })
    },
    dispose() {},
  }
}
