import { useSignal } from '@preact/signals'
import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { set } from '../state'
import { useApp } from './context'

/** That an engine rests on estimates; where it has no masses, the button that estimates them. */
export function Estimates({ exhibit }: { exhibit: Exhibit }) {
  const { host, estimate } = useApp()
  const busy = useSignal(false)
  if (exhibit.estimated.length)
    return (
      <span class="badge" title={t('Estimated: {paths}', { paths: exhibit.estimated.join(', ') })}>
        {t('estimated')}
      </span>
    )
  if (!exhibit.can_estimate || !host.estimate) return null
  return (
    <button
      type="button"
      class="plain estimate-masses"
      disabled={busy.value}
      title={t('Fills in what the file leaves out, each value with its range and source')}
      onClick={() => {
        busy.value = true
        void estimate(exhibit).finally(() => set(busy, false))
      }}
    >
      {t('Estimate masses')}
    </button>
  )
}
