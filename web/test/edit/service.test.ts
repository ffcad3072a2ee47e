import { afterEach, expect, test, vi } from 'vitest'
import { service } from '../../src/host/service'

afterEach(() => vi.unstubAllGlobals())

function answering(status: number, body: string) {
  const asked: { path: string; method: string; body: unknown }[] = []
  vi.stubGlobal('fetch', async (path: string, init: RequestInit) => {
    asked.push({
      path,
      method: init.method ?? '',
      body: init.body === undefined ? null : JSON.parse(String(init.body)),
    })
    return new Response(body, { status })
  })
  return asked
}

test('an engine is sent as a tree and comes back as an exhibit', async () => {
  const asked = answering(200, '{"name": "V2"}')
  expect(await service.exhibit({ name: 'V2' })).toEqual({ ok: true, value: { name: 'V2' } })
  expect(asked).toEqual([
    { path: '/api/exhibit', method: 'POST', body: { engine: { name: 'V2' } } },
  ])
})

test('mistakes come back as they are', async () => {
  const problems = [{ path: 'layout.banks[1].bearing', message: 'is "xx"' }]
  answering(422, JSON.stringify({ problems }))
  expect(await service.exhibit({})).toEqual({ ok: false, problems })
})

test.each([
  [502, '<html>Bad gateway</html>'],
  [500, '{}'],
  [200, 'not JSON'],
])('an answer %i that is none of ours is a sentence', async (status, body) => {
  answering(status, body)
  const answer = await service.toml({})
  expect(answer.ok).toBe(false)
  expect(!answer.ok && answer.problems[0]?.message).toContain(String(status))
})

test('a name of the catalog cannot leave the catalog', async () => {
  const asked = answering(404, '{"problems": [{"path": "", "message": "none"}]}')
  await service.engine('../health?x#y')
  expect(asked[0]?.path).toBe('/api/catalog/..%2Fhealth%3Fx%23y')
})

test('a search is of an engine, or of a number without one', async () => {
  const asked = answering(200, '{"id": "1"}')
  await service.startSearch({ name: 'I4' }, { minimise: 'M2' })
  await service.startSearch(null, { cylinders: 7, cycle: 'two-stroke' })
  await service.cancelSearch('a/b')
  expect(asked.map(({ body }) => body)).toEqual([
    { engine: { name: 'I4' }, minimise: 'M2' },
    { cylinders: 7, cycle: 'two-stroke' },
    null,
  ])
  expect(asked[2]).toMatchObject({ path: '/api/search/a%2Fb', method: 'DELETE' })
})

test('what is taken out of an answer', async () => {
  answering(200, '{"toml": "x = 1", "tree": {"a": 1}, "exhibit": {"file": {"b": 2}}}')
  expect(await service.toml({})).toEqual({ ok: true, value: 'x = 1' })
  expect(await service.read('')).toEqual({ ok: true, value: { a: 1 } })
  expect(await service.fitted({}, { factor: 0.5 })).toEqual({ ok: true, value: { b: 2 } })
})

test('a server that cannot be reached is named, an aborted request is not', async () => {
  vi.stubGlobal('fetch', async () => {
    throw new TypeError('Failed to fetch')
  })
  await expect(service.catalog()).rejects.toThrow('crankstar serve')
  await expect(service.exhibit({}, AbortSignal.abort())).rejects.toThrow('Failed to fetch')
})
