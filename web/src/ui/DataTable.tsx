import type { Table } from '../exhibit'
import { t } from '../language/messages'
import { typeset } from '../language/typeset'
import { Lettered } from './Lettered'
import { Scroller } from './Scroller'
import { Term } from './Term'

/** Letters of a cell that stays on one line. */
const SHORT = 22

/** A table; it scrolls sideways by itself where it is too wide. */
export function DataTable({ table }: { table: Table }) {
  const { title, heads, rows, numeric = [], notes = [] } = table
  const short = rows[0]?.map((_, column) =>
    rows.every((row) => (row[column]?.length ?? 0) <= SHORT),
  )
  if (!rows.length && !notes.length) return title ? <h3>{title}</h3> : null
  return (
    <section class="table">
      {title && <h3>{title}</h3>}
      {rows.length > 0 && (
        <Scroller label={title || t('Table')}>
          <table>
            {heads.length > 0 && (
              <thead>
                <tr>
                  {heads.map((head, column) =>
                    head ? (
                      <th key={column} scope="col" class={numeric[column] ? 'right' : ''}>
                        <Heading text={head} />
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
                    <td
                      key={column}
                      class={`${numeric[column] ? 'right' : ''}${short?.[column] ? ' short' : ''}`}
                    >
                      {numeric[column] ? typeset(cell) : cell}
                    </td>
                  ))}
                </tr>
              ))}
            </tbody>
          </table>
        </Scroller>
      )}
      {notes.map((note) => (
        <p key={note} class="soft small">
          {note}
        </p>
      ))}
    </section>
  )
}

/** A heading, explained where the glossary has it; its unit stays on one line. */
function Heading({ text }: { text: string }) {
  const [words = '', unit] = text.split(/(?=\[)/)
  return (
    <Term word={text.replace(/\s*[[(].*$/, '')}>
      <Lettered text={words} />
      {unit && <span class="unit">{unit}</span>}
    </Term>
  )
}
