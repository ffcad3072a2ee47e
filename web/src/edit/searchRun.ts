import { useEffect, useRef, useState } from 'preact/hooks'
import type { Problem, SearchShown } from '../exhibit'
import type { Answer } from '../host/host'
import { optionsOf, type SearchForm } from './searchForm'
import { answered, type Session } from './session'

/** Milliseconds between two requests for the progress. */
const EVERY = 250

/** A search that is started, followed and cancelled. */
export function useSearch(session: Session) {
  const [state, setState] = useState<SearchShown | null>(null)
  const [problems, setProblems] = useState<readonly Problem[]>([])
  const [ending, setEnding] = useState(false)
  const following = useRef('')
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined)
  const { service } = session
  useEffect(() => {
    // an abandoned search would keep the processors busy
    const leave = () => {
      if (following.current) void answered(service.cancelSearch(following.current))
      following.current = ''
      clearTimeout(timer.current)
    }
    window.addEventListener('pagehide', leave)
    return () => {
      window.removeEventListener('pagehide', leave)
      leave()
    }
  }, [service])

  const take = (answer: Answer<SearchShown>) => {
    if (!answer.ok) {
      setProblems(answer.problems)
      setState(null)
      following.current = ''
      return
    }
    setState(answer.value)
    following.current = answer.value.state === 'running' ? answer.value.id : ''
    if (following.current) timer.current = setTimeout(() => void follow(answer.value.id), EVERY)
  }
  const follow = async (id: string) => {
    const answer = await answered(service.search(id))
    if (following.current === id) take(answer)
  }
  return {
    state,
    problems,
    ending,
    start: async (form: SearchForm) => {
      setProblems([])
      setState(null)
      setEnding(false)
      take(
        await answered(
          service.startSearch(form.of === 'engine' ? session.tree.value : null, optionsOf(form)),
        ),
      )
    },
    stop: async () => {
      const id = following.current
      clearTimeout(timer.current)
      setEnding(true)
      if (id) take(await answered(service.cancelSearch(id)))
    },
  }
}
