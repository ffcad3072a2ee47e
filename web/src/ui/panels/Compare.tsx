import { useSignal } from '@preact/signals'
import { useEffect, useMemo, useRef } from 'preact/hooks'
import type { Exhibit, Row } from '../../exhibit'
import type { CatalogEntry } from '../../host/host'
import { QUANTITIES } from '../../state'
import { useApp, useFollower } from '../context'
import { dotOf, moveDots } from '../dots'
import { isNothing, Path } from '../Path'

const SAME = 1e-6

/** A second engine at the same crank angle, and what the two do order by order. */
export function Compare() {
  const { host, shown, store } = useApp()
  const [one, other] = shown.value
  const second = host.exhibition.engines.length > 1
  return (
    <>
      {second && (
        <label class="switch">
          <input
            type="checkbox"
            checked={store.beside.value !== '0'}
            onChange={(event) => {
              store.beside.value = event.currentTarget.checked ? '' : '0'
            }}
          />
          <span>Show both engines</span>
        </label>
      )}
      {host.service && <Picker />}
      {one && other ? (
        <Both one={one} other={other} />
      ) : (
        <p class="soft">Choose an engine to see it beside this one.</p>
      )}
    </>
  )
}

function Both({ one, other }: { one: Exhibit; other: Exhibit }) {
  const table = useRef<HTMLTableElement>(null)
  const lines = useMemo(() => pairs(one, other), [one, other])
  const dots = useMemo(
    () => lines.flatMap(({ rows: [a, b] }) => [...(a ? [dotOf(one, a)] : []), ...(b ? [dotOf(other, b)] : [])]),
    [lines, one, other],
  )
  useFollower((theta) => moveDots(table.current, dots, theta), [dots])
  const same = one.units.force === other.units.force
  return (
    <>
      {!same && <p class="soft small">The two are counted in different units: give both a speed, or neither.</p>}
      <section class="scroll" aria-label="Orders of both engines">
        <table class="orders" ref={table}>
          <thead>
            <tr>
              <th scope="col">order</th>
              <th scope="col">{one.name}</th>
              <th scope="col">{other.name}</th>
            </tr>
          </thead>
          <tbody>
            {lines.map((line) => (
              <tr key={line.label}>
                <th scope="row">{line.label}</th>
                <Cell row={line.rows[0]} unit={unitOf(one, line.quantity)} />
                <Cell row={line.rows[1]} unit={unitOf(other, line.quantity)} />
              </tr>
            ))}
          </tbody>
        </table>
      </section>
    </>
  )
}

function Cell({ row, unit }: { row: Row | undefined; unit: string }) {
  if (!row) return <td class="soft">none</td>
  return (
    <td class={isNothing(row) ? 'nothing' : ''}>
      <span class="drawn">
        <Path row={row} />
        <span>
          {row.greatest} {isNothing(row) ? '' : unit}
          <br />
          <span class="soft small">{row.path}</span>
        </span>
      </span>
    </td>
  )
}

interface Line {
  readonly label: string
  readonly quantity: Row['quantity']
  readonly rows: readonly [Row | undefined, Row | undefined]
}

/** The rows of two tables side by side. */
function pairs(one: Exhibit, other: Exhibit): Line[] {
  const orders = [...one.orders, ...other.orders].sort((a, b) => a - b)
  const different = orders.filter((order, index) => index === 0 || order - (orders[index - 1] ?? 0) > SAME)
  const row = ({ table }: Exhibit, quantity: Row['quantity'], order: number): Row | undefined =>
    table.find((each) => each.quantity === quantity && Math.abs(each.order - order) < SAME)
  return QUANTITIES.flatMap((quantity) =>
    different.flatMap((order) => {
      const rows = [row(one, quantity, order), row(other, quantity, order)] as const
      const label = rows[0]?.label ?? rows[1]?.label
      return label === undefined ? [] : [{ label: `${quantity} ${label}`, quantity, rows }]
    }),
  )
}

function unitOf({ units }: Exhibit, quantity: Row['quantity']): string {
  return quantity === 'torque' ? units.roll : units[quantity]
}

/** An engine of the catalog, found by typing a part of what is known of it. */
function Picker() {
  const { host, store, trouble } = useApp()
  const entries = useSignal<readonly CatalogEntry[]>([])
  const wanted = useSignal('')
  useEffect(() => {
    host.service?.catalog().then(
      (found) => {
        entries.value = found
      },
      (error: unknown) => {
        trouble.value = error instanceof Error ? error.message : String(error)
      },
    )
  }, [host])
  const words = wanted.value.toLowerCase().split(/\s+/)
  const fitting = entries.value.filter((entry) => {
    const text = `${entry.name} ${entry.title} ${entry.layout} ${entry.cylinders} ${entry.cycle}`.toLowerCase()
    return words.every((word) => text.includes(word))
  })
  return (
    <div class="picker">
      <label>
        <span>Compare with</span>
        <input
          type="search"
          placeholder="name, layout, number of cylinders"
          value={wanted.value}
          onInput={(event) => {
            wanted.value = event.currentTarget.value
          }}
        />
      </label>
      <ul aria-label="Engines of the catalog">
        {fitting.map((entry) => (
          <li key={entry.name}>
            <button
              type="button"
              class="plain"
              aria-pressed={store.beside.value === entry.name}
              onClick={() => {
                store.beside.value = store.beside.value === entry.name ? '0' : entry.name
              }}
            >
              <span>{entry.title}</span> <code>{entry.name}</code>
            </button>
          </li>
        ))}
      </ul>
    </div>
  )
}
