import { useSignal } from '@preact/signals'
import { useEffect, useMemo, useRef } from 'preact/hooks'
import { CatalogPicker } from '../../edit/catalog'
import type { CatalogEntry, Exhibit, Row } from '../../exhibit'
import { message, t } from '../../language/messages'
import { reasonOf } from '../../reason'
import { Switch } from '../../Switch'
import { QUANTITIES, set } from '../../state'
import { useApp, useFollower } from '../context'
import { dotOf, moveDots, sharesOf } from '../dots'
import { quantityName, unitOf } from '../names'
import { Path } from '../Path'
import type { Panel } from '../panel'

export const compare: Panel = {
  key: 'compare',
  label: message('Compare'),
  Content: Compare,
  ofAll: true,
  when: ({ host }) => !!host.service || host.exhibition.engines.length > 1,
}

/** A second engine at the same crank angle, and the orders of both. */
function Compare() {
  const { host, shown, store } = useApp()
  const [one, other] = shown.value
  const second = other !== undefined || host.exhibition.engines.length > 1
  return (
    <>
      {second && (
        <Switch
          label={t('Show both engines')}
          on={store.beside.value !== '0'}
          change={(on) => set(store.beside, on ? '' : '0')}
        />
      )}
      {host.service && <Picker />}
      {one && other ? (
        <Both one={one} other={other} />
      ) : (
        <p class="soft">{t('Choose a second engine.')}</p>
      )}
    </>
  )
}

function Both({ one, other }: { one: Exhibit; other: Exhibit }) {
  const table = useRef<HTMLTableElement>(null)
  const lines = useMemo(() => pairs(one, other), [one, other])
  const same = `${one.units.counted}` === `${other.units.counted}`
  // what can be compared has one scale
  const shares = useMemo(
    () =>
      same
        ? sharesOf([...one.table, ...other.table])
        : new Map([...sharesOf(one.table), ...sharesOf(other.table)]),
    [one, other, same],
  )
  const dots = useMemo(() => {
    const dot = (exhibit: Exhibit, row: Row | undefined) =>
      row ? [dotOf(exhibit, row, shares.get(row) ?? 0)] : []
    return lines.flatMap(({ rows: [a, b] }) => [...dot(one, a), ...dot(other, b)])
  }, [lines, shares, one, other])
  useFollower((theta) => moveDots(table.current, dots, theta), [dots])
  return (
    <>
      {!same && (
        <p class="soft small">
          {t(
            'The engines have different units. Give both a speed, masses and sizes to compare forces.',
          )}
        </p>
      )}
      <section class="scroll" aria-label={t('Orders of both engines')}>
        <table class="orders" ref={table}>
          <thead>
            <tr>
              <th scope="col">{t('order')}</th>
              <th scope="col">{one.name}</th>
              <th scope="col">{other.name}</th>
              <th scope="col">{t('of the first')}</th>
            </tr>
          </thead>
          <tbody>
            {lines.map((line) => (
              <tr key={line.label}>
                <th scope="row">{line.label}</th>
                <Cell row={line.rows[0]} shares={shares} unit={unitOf(one, line.quantity)} />
                <Cell row={line.rows[1]} shares={shares} unit={unitOf(other, line.quantity)} />
                <td>{same ? shareOf(line.rows[1], line.rows[0]) : ''}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </section>
    </>
  )
}

function Cell({
  row,
  shares,
  unit,
}: {
  row: Row | undefined
  shares: ReadonlyMap<Row, number>
  unit: string
}) {
  if (!row) return <td class="soft">{t('none')}</td>
  return (
    <td class={row.remains || row.estimated ? '' : 'nothing'}>
      <span class="drawn">
        <Path row={row} share={shares.get(row) ?? 0} />
        <span>
          {row.greatest} {row.remains || row.estimated ? unit : ''}
          <br />
          <span class="soft small">{row.path}</span>
        </span>
      </span>
    </td>
  )
}

/** The greatest value of an order as a share of that of the first engine, where this has one. */
function shareOf(row: Row | undefined, first: Row | undefined): string {
  return first?.size ? `${Number(((100 * (row?.size ?? 0)) / first.size).toPrecision(4))} %` : ''
}

/** The rows of two tables side by side, by quantity and order. */
function pairs(one: Exhibit, other: Exhibit) {
  return QUANTITIES.flatMap((quantity) => {
    const rows = [...one.table, ...other.table].filter((row) => row.quantity === quantity)
    const labels = new Set(rows.sort((a, b) => a.order - b.order).map(({ label }) => label))
    return [...labels].map((label) => {
      const row = ({ table }: Exhibit): Row | undefined =>
        table.find((each) => each.quantity === quantity && each.label === label)
      return { label: `${quantityName(quantity)} ${label}`, quantity, rows: [row(one), row(other)] }
    })
  })
}

/** A second engine from the catalog. */
function Picker() {
  const { host, store, trouble } = useApp()
  const entries = useSignal<readonly CatalogEntry[]>([])
  useEffect(() => {
    host.service?.catalog().then(
      (catalog) => set(entries, catalog),
      (error: unknown) => set(trouble, reasonOf(error)),
    )
  }, [host])
  return (
    <CatalogPicker
      label={t('Compare with')}
      entries={entries.value}
      take={({ name }) => set(store.beside, name)}
    />
  )
}
