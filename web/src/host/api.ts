import { begin } from '../activity'
import type { Problem } from '../exhibit'
import { language, t } from '../language/messages'
import type { Answer } from './host'

interface Request {
  readonly method?: 'GET' | 'POST' | 'DELETE'
  readonly body?: unknown
  readonly signal?: AbortSignal | undefined
  /** Sent again and again as long as the page is there: the page settles without its answer. */
  readonly polls?: boolean
}

/** The value, or every fault of the request. Rejects only if the server cannot be reached. */
export async function requested<T>(path: string, request: Request = {}): Promise<Answer<T>> {
  const end = request.polls ? undefined : begin()
  try {
    const response = await answered(path, request)
    const answer: unknown = await response.json().catch(() => null)
    if (response.ok && answer !== null) return { ok: true, value: answer as T }
    return { ok: false, problems: problemsOf(response.status, answer) }
  } finally {
    end?.()
  }
}

/** A file. Rejects with the sentences of all faults. */
export async function sent(path: string, body: unknown): Promise<Blob> {
  const response = await answered(path, { body })
  if (response.ok) return response.blob()
  const problems = problemsOf(response.status, await response.json().catch(() => null))
  throw new Error(problems.map(({ message }) => message).join(' '))
}

function answered(
  path: string,
  { body, method = body === undefined ? 'GET' : 'POST', signal }: Request,
): Promise<Response> {
  return fetch(`/api/${path}`, {
    method,
    keepalive: method === 'DELETE', // also as the page is left
    headers: {
      'Accept-Language': language.value,
      ...(body === undefined ? {} : { 'Content-Type': 'application/json' }),
    },
    ...(body === undefined ? {} : { body: JSON.stringify(body) }),
    ...(signal ? { signal } : {}),
  }).catch((error: unknown) => {
    if (signal?.aborted) throw error
    throw new Error(t('The server does not answer. Is crankstar serve still running?'))
  })
}

/** The faults in an answer that is no success. */
function problemsOf(status: number, answer: unknown): Problem[] {
  const problems = (answer as { problems?: unknown } | null)?.problems
  if (Array.isArray(problems) && problems.length) return problems as Problem[]
  const message = t('The server answered with HTTP status {status}. Try again, or restart it.', {
    status,
  })
  return [{ path: '', message }]
}

/** The value of an answer; rejects with the sentences of its faults. */
export async function required<T>(answer: Promise<Answer<T>>): Promise<T> {
  const settled = await answer
  if (settled.ok) return settled.value
  throw new Error(settled.problems.map(({ message }) => message).join(' '))
}

/** A part of the value of an answer. */
export function part<T, U>(answer: Answer<T>, taken: (value: T) => U): Answer<U> {
  return answer.ok ? { ok: true, value: taken(answer.value) } : answer
}
