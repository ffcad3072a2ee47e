import type { Exhibit } from '../exhibit'
import { unset } from '../language/typeset'

type Cell = string | number | null

/** Rows as CSV after RFC 4180, with the mark by which spreadsheets know the letters. */
export function csv(rows: readonly (readonly Cell[])[]): string {
  const written = (cell: Cell): string => {
    const given = cell === null ? '' : String(cell)
    // a spreadsheet would take it for a formula
    const text = /^[=+\-@]/.test(given) && Number.isNaN(Number(given)) ? `'${given}` : given
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
  }
  return `\ufeff${rows.map((row) => `${row.map(written).join(',')}\r\n`).join('')}`
}

type Complex = readonly [number, number]

const plus = ([a, b]: Complex, [c, d]: Complex, sign: number): Complex => [
  a + sign * c,
  b + sign * d,
]
const conjugate = ([a, b]: Complex): Complex => [a, -b]
/** A number times -i. */
const turnedBack = ([a, b]: Complex): Complex => [b, -a]

/** Heads of the table of amplitudes, those of `crankstar analyze --csv`. */
export const AMPLITUDES = [
  'engine',
  'speed_rpm',
  'part',
  'order',
  'quantity',
  'direction',
  'amplitude',
  'phase_deg',
  'unit',
] as const

/**
 * The amplitudes of the whole engine, in the units of the page: one row an amplitude c of order k,
 * which stands for |c| cos(k theta + phase). As `crankstar analyze --csv` writes them.
 */
export function amplitudes(exhibit: Exhibit): Cell[][] {
  const { total, orders, sense, units } = exhibit
  const waves: [string, string, string, number, Complex[]][] = []
  const vectors = [
    ['force', 'force', 'force', units.force, units.force_factor],
    ['couple', 'pitch', 'yaw', units.couple, units.couple_factor],
  ] as const
  for (const [name, upward, rightward, unit, factor] of vectors) {
    const { forward, backward } = total[name]
    // what turns with growing angle, whichever way the engine turns
    const [first, second] = sense > 0 ? [forward, backward] : [backward, forward]
    const pairs = first.map((each, index) => [each, conjugate(second[index] ?? [0, 0])] as const)
    const up = pairs.map(([one, other]) => plus(one, other, 1))
    const right = pairs.map(([one, other]) => turnedBack(plus(one, other, -1)))
    waves.push([upward, 'vertical', unit, factor, up])
    waves.push([rightward, 'horizontal', unit, factor, right])
    waves.push([name, 'forward', unit, factor, forward])
    waves.push([name, 'backward', unit, factor, backward])
  }
  for (const name of ['roll', 'torque'] as const)
    waves.push([name, 'axial', units.roll, units.roll_factor, total[name]])
  return waves.flatMap(([quantity, direction, unit, factor, values]) =>
    values.map(([real, imaginary], index) => {
      const size = Math.hypot(real, imaginary)
      const phase = size > 0 ? (Math.atan2(imaginary, real) * 180) / Math.PI : 0
      const order = orders[index] ?? 0
      const whose = [exhibit.name, exhibit.speed_rpm, 'engine', order]
      return [...whose, quantity, direction, size * factor, phase, unit]
    }),
  )
}

/** A table of the page as rows: heads, then what is printed; the name of a group before its rows. */
export function rowsOf(table: HTMLTableElement): string[][] {
  const rows: string[][] = []
  const grouped = table.querySelector('tr.group') !== null
  let group = ''
  for (const row of table.rows) {
    const cells = [...row.cells]
    if (row.classList.contains('group')) {
      group = textOf(cells[0])
      continue
    }
    if (cells.some((cell) => cell.colSpan > 1)) continue // a remark
    const first = row.parentElement?.tagName === 'THEAD' ? '' : group
    rows.push([...(grouped ? [first] : []), ...cells.map(textOf)])
  }
  return rows
}

/** What a cell says; a number as a spreadsheet reads it. */
function textOf(cell: HTMLTableCellElement | undefined): string {
  const text = (cell?.textContent ?? '').replace(/\s+/g, ' ').trim()
  return unset(text)
}
