import type { ChartKey, Exhibit } from '../exhibit'
import { Figure } from './Figure'

/** Figures of the engines; of two engines, those of one kind stand beside each other. */
export function Figures({
  of,
  charts,
}: {
  readonly of: readonly Exhibit[]
  readonly charts: (exhibit: Exhibit) => readonly ChartKey[]
}) {
  const shelves = of.map(charts)
  if (of.length < 2)
    return <div class="figures">{shelves.map((keys, at) => figures(of, keys, at))}</div>
  const keys = [...new Set(shelves.flat().map(({ key }) => key))]
  return (
    <>
      {keys.map((key) => (
        <div class="figures" key={key}>
          {shelves.map((shelf, at) =>
            figures(
              of,
              shelf.filter((chart) => chart.key === key),
              at,
            ),
          )}
        </div>
      ))}
    </>
  )
}

function figures(of: readonly Exhibit[], charts: readonly ChartKey[], at: number) {
  const exhibit = of[at]
  if (!exhibit) return null
  return charts.map((chart) => (
    <Figure key={`${at} ${chart.key}`} exhibit={exhibit} chart={chart.key} label={chart.label} />
  ))
}
