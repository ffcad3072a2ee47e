/** Bytes, or what they are put together from. */
export type Bytes = Uint8Array<ArrayBuffer>

/** Pieces one after the other; a text by its letters, a number as one byte. */
export function bytes(...pieces: readonly (Bytes | string | number)[]): Bytes {
  const parts = pieces.map((piece) =>
    typeof piece === 'string'
      ? Uint8Array.from(piece, (letter) => letter.charCodeAt(0))
      : typeof piece === 'number'
        ? Uint8Array.of(piece)
        : piece,
  )
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0))
  let at = 0
  for (const part of parts) {
    all.set(part, at)
    at += part.length
  }
  return all
}

/** A whole number of so many bytes, the greatest first. */
export function uint(value: number, count: number): Bytes {
  const out = new Uint8Array(count)
  let left = value
  for (let index = count - 1; index >= 0; index--) {
    out[index] = left % 256
    left = Math.floor(left / 256)
  }
  return out
}

/** A number of 64 bits with a fraction. */
export function float64(value: number): Bytes {
  const out = new DataView(new ArrayBuffer(8))
  out.setFloat64(0, value)
  return new Uint8Array(out.buffer)
}
