/** Milliseconds after which no download reads its address any more. */
const READ = 20_000

/** Gives the browser a file to keep. */
export function save(blob: Blob, name: string): void {
  const address = URL.createObjectURL(blob)
  const link = document.createElement('a')
  link.href = address
  link.download = name
  link.click()
  setTimeout(() => URL.revokeObjectURL(address), READ)
}

/** A canvas as a PNG. */
export function png(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) resolve(blob)
      else reject(new RangeError('no picture of this size'))
    }, 'image/png')
  })
}

export const svg = (text: string): Blob => new Blob([text], { type: 'image/svg+xml' })
