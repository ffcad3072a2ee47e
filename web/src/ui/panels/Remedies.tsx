import { useEffect } from 'preact/hooks'
import type { Exhibit } from '../../exhibit'
import { Choice } from '../Choice'
import { useApp } from '../context'
import { DataTable } from '../DataTable'
import { Figure } from '../Figure'

/** The spectra of both on common axes: the key BEFORE_AND_AFTER of Python. */
const COMPARED = 'spectrum:fitted'

/** The engine as it is, and with counterweights and balance shafts. */
export function Remedies() {
  const { store, cured, engines, cure } = useApp()
  const before = engines.value[0]
  const after = cured.value[0]
  useEffect(cure, [before, cure])
  if (!before) return null
  if (after === undefined) return <p class="soft">Weights and shafts are being worked out …</p>
  if (after === null)
    return <p>Counterweights and balance shafts would take nothing of the first two orders from this engine.</p>
  return (
    <>
      <Choice
        label="On the stage, and in all panels"
        value={store.fitted.value ? 'after' : 'before'}
        choices={[
          { value: 'before', label: 'as it is' },
          { value: 'after', label: 'with weights and shafts' },
        ]}
        chosen={(value) => {
          store.fitted.value = value === 'after'
        }}
      />
      <Figure
        exhibit={before}
        chart={COMPARED}
        label="Spectrum, as it is and with weights and shafts, on common axes"
      />
      <div class="figures pair">
        <Side title="As it is" exhibit={before} />
        <Side title="With weights and shafts" exhibit={after} />
      </div>
      {after.remedies
        .filter((table) => table.rows.length > 0)
        .map((table) => (
          <DataTable key={table.title} table={table} />
        ))}
    </>
  )
}

/** The shafts of one of the two, from the side. */
function Side({ title, exhibit }: { title: string; exhibit: Exhibit }) {
  return (
    <div>
      <h3>{title}</h3>
      {exhibit.charts
        .filter((chart) => chart.figure === 'shaft')
        .map((chart) => (
          <Figure key={chart.key} exhibit={exhibit} chart={chart.key} label={chart.label} />
        ))}
    </div>
  )
}
