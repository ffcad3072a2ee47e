import type { Answer, Tree } from './host/host'
import { t } from './language/messages'

/** No engine file is longer than this; what unpacks to more was not packed here. */
const LONGEST = 1_000_000

async function piped(
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
export async function packedTree(tree: Tree): Promise<string> {
  const bytes = await piped(
    new TextEncoder().encode(JSON.stringify(tree)),
    new CompressionStream('deflate-raw'),
  )
  const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')
}

/** The engine file in a text made by `packedTree`. */
export async function unpackedTree(packed: string): Promise<Answer<Tree>> {
  try {
    const text = atob(packed.replaceAll('-', '+').replaceAll('_', '/'))
    const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0))
    const whole = await piped(bytes, new DecompressionStream('deflate-raw'))
    const tree: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(whole))
    if (typeof tree === 'object' && tree !== null && !Array.isArray(tree))
      return { ok: true, value: tree as Tree }
  } catch {
    // the same sentence for all that is no engine file
  }
  const message = t('The engine in this link cannot be read; the link may be incomplete.')
  return { ok: false, problems: [{ path: '', message }] }
}
