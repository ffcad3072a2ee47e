import { useSignal } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import type { Exhibit } from '../exhibit'
import type { Spec } from '../host/host'
import { useApp } from './context'
import { type Drawing, drawn } from './drawing'

/** A figure of an engine by its key; it turns with the engine. */
export function Figure({ exhibit, chart, label }: { exhibit: Exhibit; chart: string; label: string }) {
  const { host, clock } = useApp()
  const place = useRef<HTMLDivElement>(null)
  const trouble = useSignal('')
  const there = useSignal(false)
  const attempt = useSignal(0)
  const again = attempt.value

  useEffect(() => {
    const element = place.current
    if (!element) return undefined
    let ended = false
    let drawing: Drawing | null = null
    let unfollow = (): void => undefined
    trouble.value = ''
    const show = async (spec: Spec): Promise<void> => {
      const made = await drawn(element, spec)
      if (ended) return made.dispose()
      drawing = made
      there.value = true
      if (made.turns) unfollow = clock.follow(() => made.turnTo(clock.degrees() % (360 * exhibit.turns)))
    }
    host
      .chart(exhibit, chart)
      .then((spec) => (ended ? undefined : show(spec)))
      .catch((error: unknown) => {
        if (ended) return
        there.value = false
        trouble.value = error instanceof Error ? error.message : String(error)
      })
    return () => {
      ended = true
      unfollow()
      drawing?.dispose()
    }
  }, [host, clock, exhibit, chart, again])

  return (
    <figure class={`figure${there.value ? '' : ' empty'}`} data-chart={chart}>
      <div class="drawing" ref={place} role="img" aria-label={`${label}. ${exhibit.name}.`} />
      {!there.value && !trouble.value && <p class="wait">Drawing: {label} …</p>}
      {trouble.value && (
        <p class="wait">
          {trouble.value}{' '}
          <button
            type="button"
            onClick={() => {
              attempt.value += 1
            }}
          >
            Try again
          </button>
        </p>
      )}
    </figure>
  )
}
