import type { Row } from '../exhibit'

/** The path of a vector over a turn, to its own scale, with the present point; a line for a signal. */
export function Path({ row }: { row: Row }) {
  const nothing = !row.remains
  return (
    <svg class="path" viewBox="-1.25 -1.25 2.5 2.5" aria-hidden="true">
      <path class="cross" d="M-1.15 0H1.15M0 -1.15V1.15" />
      {!nothing &&
        (row.semi_axes ? (
          <Ellipse row={row} axes={row.semi_axes} />
        ) : (
          <path class="line" d="M-1 0H1" />
        ))}
      <circle class={nothing ? 'still' : 'now'} r={nothing ? 0.09 : 0.2} />
    </svg>
  )
}

function Ellipse({ row, axes }: { row: Row; axes: readonly [number, number] }) {
  const [long, short] = axes
  const turned = ((row.direction ?? 0) / Math.PI) * 180 - 90
  return (
    <ellipse
      class="line"
      rx={1}
      ry={Math.max(0.01, short / long)}
      transform={`rotate(${turned.toFixed(3)})`}
    />
  )
}
