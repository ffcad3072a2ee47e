import type { Exhibit, Table } from '../exhibit'
import { DataTable } from './DataTable'
import { Figure } from './Figure'

/** A panel that shows what a command prints: its figure, then its tables; or what they need. */
export function Told({
  exhibit,
  figures,
  tables,
  needs,
}: {
  exhibit: Exhibit
  figures: readonly string[]
  tables: readonly Table[]
  needs: string
}) {
  if (!tables.length) return <p class="needs">{needs}</p>
  return (
    <div class="stacked">
      <div class="figures">
        {exhibit.charts
          .filter((chart) => figures.includes(chart.figure))
          .map(({ key, label }) => (
            <Figure key={key} exhibit={exhibit} chart={key} label={label} />
          ))}
      </div>
      {tables.map((table, place) => (
        <DataTable key={place} table={table} />
      ))}
    </div>
  )
}
