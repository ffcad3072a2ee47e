import { counted } from './activity'

/** No engine file is longer than this; what unpacks to more was not packed here. */
const LONGEST = 1_000_000

/** Bytes sent through a compressing or expanding stream. */
export const piped = (
  bytes: Uint8Array<ArrayBuffer>,
  through: GenericTransformStream,
): Promise<Uint8Array<ArrayBuffer>> => counted(gone(bytes, through))

async function gone(
  bytes: Uint8Array<ArrayBuffer>,
  through: GenericTransformStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(through).getReader()
  const parts: Uint8Array<ArrayBuffer>[] = []
  let length = 0
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    const part = next.value as Uint8Array<ArrayBuffer>
    length += part.length
    if (length > LONGEST) {
      await reader.cancel()
      throw new RangeError('more than an engine file')
    }
    parts.push(part)
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer())
}

/** An engine file as a short text of letters that need no escape in an address. */
export async function packedTree(tree: Readonly<Record<string, unknown>>): Promise<string> {
  const bytes = await piped(
    new TextEncoder().encode(JSON.stringify(tree)),
    new CompressionStream('deflate-raw'),
  )
  const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')
}

/** Text that was packed with gzip. */
export async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))
  return counted(new Response(stream).text())
}
