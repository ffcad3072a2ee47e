import type { Exhibit, Problem } from '../exhibit'
import type { Answer, CatalogEntry, SearchState, Service, Tree } from './host'

interface Call {
  readonly method?: 'GET' | 'POST' | 'DELETE'
  readonly body?: unknown
  readonly signal?: AbortSignal | undefined
}

/** An answer of the API: what was asked for, or every mistake in the question. Rejects only if the server is not there. */
async function called<T>(base: string, path: string, { method = 'GET', body, signal }: Call = {}): Promise<Answer<T>> {
  const response = await fetch(`${base}/api/${path}`, {
    method,
    keepalive: method === 'DELETE', // also as the page is left
    headers: body === undefined ? {} : { 'Content-Type': 'application/json' },
    ...(body === undefined ? {} : { body: JSON.stringify(body) }),
    ...(signal ? { signal } : {}),
  })
  const said: unknown = await response.json().catch(() => null)
  if (response.ok && said !== null) return { ok: true, value: said as T }
  const problems = (said as { problems?: unknown } | null)?.problems
  if (Array.isArray(problems) && problems.length) return { ok: false, problems: problems as Problem[] }
  return {
    ok: false,
    problems: [{ path: '', message: `The server answers with ${response.status}. Try again, or start it anew.` }],
  }
}

/** What must be there, as a value; rejects with the sentences if it is not. */
async function needed<T>(answer: Promise<Answer<T>>): Promise<T> {
  const found = await answer
  if (found.ok) return found.value
  throw new Error(found.problems.map(({ message }) => message).join(' '))
}

function part<T, U>(answer: Answer<T>, taken: (value: T) => U): Answer<U> {
  return answer.ok ? { ok: true, value: taken(answer.value) } : answer
}

/** Live editing by the API of `crankstar serve`; `base` is '' for the server that the page came from. */
export function service(base = ''): Service {
  const post = <T>(path: string, body: unknown, signal?: AbortSignal) =>
    called<T>(base, path, { method: 'POST', body, signal })
  const search = (id: string, method: 'GET' | 'DELETE') =>
    called<SearchState>(base, `search/${encodeURIComponent(id)}`, { method })
  return {
    schema: () => needed(called<Tree>(base, 'schema')),
    catalog: () => needed(called<CatalogEntry[]>(base, 'catalog')),
    engine: (name) => called<Tree>(base, `catalog/${encodeURIComponent(name)}`),
    exhibit: (tree, signal) => post<Exhibit>('exhibit', { engine: tree }, signal),
    toml: async (tree) => part(await post<{ toml: string }>('toml', { engine: tree }), ({ toml }) => toml),
    explicit: async (tree) => part(await post<{ tree: Tree }>('explicit', { engine: tree }), (found) => found.tree),
    read: async (text) => part(await post<{ tree: Tree }>('read', { text }), ({ tree }) => tree),
    fitted: async (tree, options) =>
      part(
        await post<{ exhibit: Exhibit | null }>('fitted', { engine: tree, ...options }),
        ({ exhibit }) => exhibit?.file ?? null,
      ),
    startSearch: (tree, wish) => post<SearchState>('search', tree === null ? wish : { engine: tree, ...wish }),
    search: (id) => search(id, 'GET'),
    cancelSearch: (id) => search(id, 'DELETE'),
  }
}
