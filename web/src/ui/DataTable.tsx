import type { Table } from '../exhibit'

const SHORT = 22
const NUMERIC = /^[-−+~≈]?[\d.]/

/** A table of text; it scrolls sideways by itself where it is too wide. */
export function DataTable({ table }: { table: Table }) {
  const { title, heads, rows, notes = [] } = table
  if (!rows.length && !notes.length) return title ? <h3>{title}</h3> : null
  return (
    <section class="table">
      {title && <h3>{title}</h3>}
      {rows.length > 0 && (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls is reached by keyboard
        <section class="scroll" tabIndex={0} aria-label={title || 'Table'}>
          <table>
            {heads.length > 0 && (
              <thead>
                <tr>
                  {heads.map((head, column) =>
                    head ? (
                      <th key={column} scope="col" class={isNumeric(rows, column) ? 'right' : ''}>
                        {head}
                      </th>
                    ) : (
                      <td key={column} />
                    ),
                  )}
                </tr>
              </thead>
            )}
            <tbody>
              {rows.map((row, index) => (
                <tr key={index}>
                  {row.map((cell, column) => (
                    <td key={column} class={cellClass(rows, column)}>
                      {cell}
                    </td>
                  ))}
                </tr>
              ))}
            </tbody>
          </table>
        </section>
      )}
      {notes.map((note) => (
        <p key={note} class="soft small">
          {note}
        </p>
      ))}
    </section>
  )
}

/** Numbers stand at the right; what is short stays on one line. */
function cellClass(rows: readonly (readonly string[])[], column: number): string {
  const short = rows.every((row) => (row[column]?.length ?? 0) <= SHORT)
  return `${isNumeric(rows, column) ? 'right' : ''}${short ? ' short' : ''}`
}

function isNumeric(rows: readonly (readonly string[])[], column: number): boolean {
  return rows.every((row) => !row[column] || NUMERIC.test(row[column]))
}
