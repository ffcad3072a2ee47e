import { bytesOf } from './base64'
import { piped } from './deflated'
import type { Answer, Tree } from './host/host'
import { t } from './language/messages'

export { packedTree } from './deflated'

/** The engine file in a text made by `packedTree`. */
export async function unpackedTree(packed: string): Promise<Answer<Tree>> {
  try {
    const bytes = bytesOf(packed.replaceAll('-', '+').replaceAll('_', '/'))
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
