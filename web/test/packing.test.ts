import { expect, test } from 'vitest'
import { unpacked } from '../src/host/page'
import { packedTree, unpackedTree } from '../src/packing'

const TREE = {
  format: 1,
  name: '</script><img src=x onerror=alert(1)> ü 直列',
  layout: { banks: [{ bearing: '45 deg' }] },
}

test('an engine file survives its way through an address', async () => {
  const packed = await packedTree(TREE)
  expect(packed).toMatch(/^[\w-]+$/)
  expect(await unpackedTree(packed)).toEqual({ ok: true, value: TREE })
})

test.each(['', '!!!', 'AAAA', '~~', 'x'.repeat(1000)])(
  'what is no engine file is told in a sentence: %.20s',
  async (text) => {
    const answer = await unpackedTree(text)
    expect(answer.ok).toBe(false)
    expect(answer.ok ? '' : answer.problems[0]?.message).toMatch(/cannot be read/)
  },
)

test('a link that unpacks to far too much is refused', async () => {
  const packed = await packedTree({ name: ' '.repeat(3_000_000) })
  expect(packed.length).toBeLessThan(10_000)
  expect((await unpackedTree(packed)).ok).toBe(false)
})

test('what a file holds is read packed and plain', async () => {
  const bytes = await new Response(
    new Blob(['{"a": "ü"}']).stream().pipeThrough(new CompressionStream('gzip')),
  ).arrayBuffer()
  const data = btoa(String.fromCharCode(...new Uint8Array(bytes)))
  expect(await unpacked(JSON.stringify({ encoding: 'gzip+base64', data }))).toEqual({ a: 'ü' })
  expect(await unpacked('{"a": 1}')).toEqual({ a: 1 })
})
