import { useMemo, useRef } from 'preact/hooks'
import type { Exhibit, Row } from '../exhibit'
import { t } from '../language/messages'
import { typeset } from '../language/typeset'
import { QUANTITIES, type Quantity } from '../state'
import { useFollower } from './context'
import { dotOf, moveDots, sharesOf } from './dots'
import { factorOf, quantityName, TERMS, unitOf } from './names'
import { OrderRow } from './OrderRow'
import { Path } from './Path'
import { Scroller } from './Scroller'
import { Term } from './Term'

/** The orders of two engines beside each other, to one scale, and by how much they differ. */
export function BothOrders({ one, other }: { one: Exhibit; other: Exhibit }) {
  const table = useRef<HTMLTableElement>(null)
  const lines = useMemo(() => pairs(one, other), [one, other])
  const same = alike(one, other)
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
      {same && one.units.counted[0] !== 'N' && (
        <p class="soft small">{t('Each engine is counted in its own m, r and a.')}</p>
      )}
      <Scroller label={t('Orders of both engines')}>
        <table class="orders both" ref={table}>
          <thead>
            <tr>
              <th scope="col">
                <Term word="order">{t('order')}</Term>
              </th>
              <th scope="col">{one.name}</th>
              <th scope="col">{other.name}</th>
              <th scope="col" class="right">
                {t('difference, second − first')}
              </th>
            </tr>
          </thead>
          {QUANTITIES.map((quantity) => {
            const own = lines.filter((line) => line.quantity === quantity)
            const unit = unitOf(other, quantity)
            const common = unitOf(one, quantity) === unit
            return own.length === 0 ? null : (
              <tbody key={quantity}>
                <tr class="group">
                  <th colSpan={4} scope="rowgroup">
                    <Term word={TERMS[quantity]}>{quantityName(quantity)}</Term>{' '}
                    <span class="unit">{common && unit}</span>
                  </th>
                </tr>
                {own.map((line) => (
                  <OrderRow key={line.label} {...line}>
                    <Cell
                      row={line.rows[0]}
                      shares={shares}
                      unit={common ? '' : unitOf(one, quantity)}
                    />
                    <Cell row={line.rows[1]} shares={shares} unit={common ? '' : unit} />
                    <td class="right">
                      {same && <Difference lines={line} unit={common ? '' : unit} />}
                    </td>
                  </OrderRow>
                ))}
              </tbody>
            )
          })}
        </table>
      </Scroller>
      <p class="soft small">
        {t('Orders of which nothing remains in either engine are left out.')}
      </p>
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
          <span class="whole">
            {typeset(row.greatest)} {row.remains || row.estimated ? unit : ''}
          </span>
          <br />
          <span class="soft small">{row.path}</span>
        </span>
      </span>
    </td>
  )
}

/** By how much the greatest value is greater in the second engine, and as a share of the first. */
function Difference({ lines, unit }: { lines: Line; unit: string }) {
  const [first, second] = lines.rows
  const change = (second?.size ?? 0) - (first?.size ?? 0)
  const most = Math.max(first?.size ?? 0, second?.size ?? 0)
  if (most === 0) return null
  const factor = lines.factor
  const text = differenceText(change * factor, most * factor)
  return (
    <>
      <span class="whole">
        {typeset(text)} {text !== '0' && unit}
      </span>
      {!!first?.size && !!second?.size && text !== '0' && (
        <>
          <br />
          <span class="soft small">
            {t('{share} of the first', { share: shareText(second?.size ?? 0, first.size) })}
          </span>
        </>
      )}
    </>
  )
}

function shareText(size: number, first: number): string {
  return `${Number(((100 * size) / first).toPrecision(4))} %`
}

/** A difference with its sign, to five figures of the greater of the two; equal sizes are 0. */
export function differenceText(change: number, most: number): string {
  const step = 10 ** (Math.floor(Math.log10(most)) - 4)
  const size = Math.round(Math.abs(change) / step) * step
  if (size === 0) return '0'
  const [digits = '', power] = figures(size).split('e')
  const text = power ? `${digits}e${power.replace('-', '−')}` : digits
  return `${change < 0 ? '−' : '+'}${text}`
}

/** Five figures without closing zeros, as the tables of the analysis have them. */
function figures(size: number): string {
  const plain = Number(size.toPrecision(5))
  if (plain >= 1e-4 && plain < 1e6) return String(plain)
  const [digits, power = 0] = plain.toExponential().split('e')
  return `${digits}e${Number(power) < 0 ? '-' : '+'}${String(Math.abs(Number(power))).padStart(2, '0')}`
}

/** Whether two engines are counted in the same units, so that they have one scale. */
export function alike(one: Exhibit, other: Exhibit): boolean {
  return `${one.units.counted}` === `${other.units.counted}`
}

interface Line {
  readonly label: string
  readonly order: number
  readonly quantity: Quantity
  readonly rows: readonly [Row | undefined, Row | undefined]
  /** What a size is multiplied with to be in the unit of its quantity. */
  readonly factor: number
}

/** The rows of two tables side by side, by quantity and order, of what remains in either. */
function pairs(one: Exhibit, other: Exhibit): Line[] {
  return QUANTITIES.flatMap((quantity) => {
    const rows = [...one.table, ...other.table].filter(
      (row) => row.quantity === quantity && (row.remains || row.estimated),
    )
    const labels = new Set(rows.sort((a, b) => a.order - b.order).map(({ label }) => label))
    return [...labels].map((label) => {
      const row = ({ table }: Exhibit): Row | undefined =>
        table.find((each) => each.quantity === quantity && each.label === label)
      const [first, second] = [row(one), row(other)]
      return {
        label,
        order: (first ?? second)?.order ?? 0,
        quantity,
        rows: [first, second],
        factor: factorOf(other, quantity),
      }
    })
  })
}
