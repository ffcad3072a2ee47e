import type { Row } from '../exhibit'

/** Paths shorter than this share of the longest are drawn as a point. */
const POINT = 0.004

/**
 * The path of a vector over a turn with the present point; a line for a signal. `share` is its
 * length in shares of the longest of its quantity, to whose scale all are drawn.
 */
export function Path({ row, share }: { row: Row; share: number }) {
  const nothing = !row.remains || share < POINT
  return (
    <svg class="path" viewBox="-1.25 -1.25 2.5 2.5" aria-hidden="true">
      <path class="cross" d="M-1.15 0H1.15M0 -1.15V1.15" />
      {!nothing &&
        (row.semi_axes ? (
          <Ellipse row={row} axes={row.semi_axes} share={share} />
        ) : (
          <path class="line" d={`M${-share} 0H${share}`} />
        ))}
      <circle class={row.remains ? 'now' : 'still'} r={nothing ? 0.09 : 0.16} />
    </svg>
  )
}

function Ellipse({
  row,
  axes,
  share,
}: {
  row: Row
  axes: readonly [number, number]
  share: number
}) {
  const [long, short] = axes
  const turned = ((row.direction ?? 0) / Math.PI) * 180 - 90
  return (
    <ellipse
      class="line"
      rx={share}
      ry={Math.max(0.01, (share * short) / long)}
      transform={`rotate(${turned.toFixed(3)})`}
    />
  )
}
