import { useEffect } from 'preact/hooks'
import type { Exhibit, Row } from '../../exhibit'
import { message, t } from '../../language/messages'
import { set } from '../../state'
import { Choice } from '../Choice'
import { useApp, useSubject } from '../context'
import { DataTable } from '../DataTable'
import { Figure } from '../Figure'
import { quantityName, unitOf } from '../names'
import type { Panel } from '../panel'

/** The spectra of both on common axes: the key BEFORE_AND_AFTER of Python. */
const COMPARED = 'spectrum:fitted'

export const remedies: Panel = {
  key: 'remedies',
  label: message('Balancing'),
  Content: Remedies,
  of: 'each',
}

/** The engine as it is, and with counterweights and balance shafts. */
function Remedies() {
  const { store, cured, engines, cure } = useApp()
  const place = useSubject()
  const before = engines.value[place]
  const after = cured.value[place]
  useEffect(cure, [before, cure])
  if (!before) return null
  if (after === undefined) return <p class="soft">{t('Fitting weights and shafts …')}</p>
  if (after === null)
    return (
      <p>
        {t('Counterweights and balance shafts cannot reduce the primary or secondary unbalance.')}
      </p>
    )
  return (
    <>
      <Choice
        label={t('On the stage and in all panels')}
        value={store.fitted.value ? 'after' : 'before'}
        choices={[
          { value: 'before', label: t('as it is') },
          { value: 'after', label: t('with weights and shafts') },
        ]}
        chosen={(value) => set(store.fitted, value === 'after')}
      />
      <Grown before={before} after={after} />
      <div class="figures">
        <Figure
          exhibit={before}
          chart={COMPARED}
          label={t('Spectrum with and without weights and shafts, on common axes')}
        />
      </div>
      <div class="figures pair">
        <Side title={t('As it is')} exhibit={before} />
        <Side title={t('With weights and shafts')} exhibit={after} />
      </div>
      {after.remedies
        .filter((table) => table.rows.length > 0)
        .map((table) => (
          <DataTable key={table.title} table={table} />
        ))}
    </>
  )
}

/** A rise below this share of what it is compared with is not told. */
const RISE = 0.01

/** The orders of which weights and shafts leave more than there was. */
function Grown({ before, after }: { before: Exhibit; after: Exhibit }) {
  const most = (quantity: Row['quantity']): number =>
    Math.max(
      ...[...before.table, ...after.table].map((row) => (row.quantity === quantity ? row.size : 0)),
    )
  const grown = after.table.flatMap((row) => {
    const was = before.table.find(
      (each) => each.quantity === row.quantity && each.label === row.label,
    )
    return row.size - (was?.size ?? 0) > RISE * most(row.quantity) ? [{ row, was }] : []
  })
  if (!grown.length) return null
  return (
    <div class="estimate">
      <p>{t('Weights and shafts leave more of:')}</p>
      <ul>
        {grown.map(({ row, was }) => (
          <li key={`${row.quantity} ${row.label}`}>
            {t('{quantity}, order {order}: {after} {unit} instead of {before}', {
              quantity: quantityName(row.quantity),
              order: row.label,
              after: row.greatest,
              before: was?.greatest ?? '0',
              unit: unitOf(after, row.quantity),
            })}
          </li>
        ))}
      </ul>
    </div>
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
