import type { Exhibit, Exhibition } from '../exhibit'
import { addressState } from './address'
import type { Host, Spec } from './host'
import { service } from './service'

/** Figures and derivations that are kept; a session of editing asks for many. */
const KEPT = 60

async function asked<T>(path: string, body?: unknown): Promise<T> {
  const response = await fetch(`/api/${path}`, {
    method: body === undefined ? 'GET' : 'POST',
    headers: body === undefined ? {} : { 'Content-Type': 'application/json' },
    ...(body === undefined ? {} : { body: JSON.stringify(body) }),
  }).catch(() => {
    throw new Error('The server does not answer. Is crankstar serve still running?')
  })
  const said: unknown = await response.json().catch(() => null)
  if (response.ok && said !== null) return said as T
  const problems = (said as { problems?: { message: string }[] } | null)?.problems ?? []
  const sentences = problems.map(({ message }) => message).join(' ')
  throw new Error(sentences || `The server answers with ${response.status}. Try again, or start it anew.`)
}

/** Answers that were given, the oldest forgotten first; what failed is asked for again. */
function remembered<T>(limit: number): (key: string, ask: () => Promise<T>) => Promise<T> {
  const answers = new Map<string, Promise<T>>()
  return (key, ask) => {
    const known = answers.get(key)
    if (known) return known
    const answer = ask()
    answers.set(key, answer)
    answer.catch(() => answers.delete(key))
    const oldest = answers.keys().next().value
    if (answers.size > limit && oldest !== undefined) answers.delete(oldest)
    return answer
  }
}

/** The local server, `crankstar serve`. */
export async function serverHost(): Promise<Host> {
  const exhibition = await asked<Exhibition>('opening')
  const names = new WeakMap<Exhibit, number>()
  let count = 0
  // an exhibit never changes, so that one number stands for its whole engine file
  const nameOf = (exhibit: Exhibit): number => {
    const name = names.get(exhibit) ?? ++count
    names.set(exhibit, name)
    return name
  }
  const charts = remembered<Spec>(KEPT)
  const derivations = remembered<string>(KEPT)
  const fitted = remembered<Exhibit | null>(KEPT)
  exhibition.engines.forEach((exhibit, index) => {
    const found = exhibition.fitted[index]
    if (found) void fitted(`${nameOf(exhibit)}`, () => Promise.resolve(found))
  })
  return {
    kind: 'server',
    exhibition,
    chart: (exhibit, key) =>
      charts(`${nameOf(exhibit)} ${key}`, () => asked<Spec>('chart', { engine: exhibit.file, key })),
    derivation: (exhibit, key) =>
      derivations(`${nameOf(exhibit)} ${key}`, async () => {
        const { html } = await asked<{ html: string }>('derivation', { engine: exhibit.file, key })
        return html
      }),
    fitted: (exhibit) =>
      fitted(`${nameOf(exhibit)}`, async () => {
        const { exhibit: found } = await asked<{ exhibit: Exhibit | null }>('fitted', { engine: exhibit.file })
        return found
      }),
    service: service(),
    ...addressState(),
  }
}
