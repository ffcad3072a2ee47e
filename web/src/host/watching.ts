import type { Problem, WatchedShown } from '../exhibit'
import { requested } from './api'
import type { Tree } from './host'

/** How often the server is asked whether the file was saved, milliseconds. */
const EVERY = 600

/** What is new of a watched file: what is wrong with it, and its engine if that is another one. */
export interface News {
  readonly file: string
  readonly problems: readonly Problem[]
  readonly tree: Tree | null
}

/**
 * Asks for news of the file that the server watches, until it watches none or the result is called.
 * `known` is its engine so far.
 */
export function watched(known: Tree, changed: (news: News) => void): () => void {
  let [version, tree, timer, ended] = [0, JSON.stringify(known), 0, false]
  const ask = async (): Promise<void> => {
    const answer = document.hidden
      ? null
      : await requested<WatchedShown>(`watched?after=${version}`, { polls: true }).catch(() => null)
    if (ended) return
    if (answer?.ok) {
      const { value } = answer
      if (value.version === 0) return
      if (value.version !== version) {
        version = value.version
        const { file = '', problems = [] } = value
        const now = JSON.stringify(value.tree ?? null)
        const other = now === tree ? null : (value.tree ?? null)
        tree = now
        if (other || problems.length || version > 1) changed({ file, problems, tree: other })
      }
    }
    timer = window.setTimeout(ask, EVERY)
  }
  void ask()
  return () => {
    ended = true
    window.clearTimeout(timer)
  }
}
