/** Closed outlines across the crankshaft, x right, y up, counter-clockwise. */
export type Outline = readonly (readonly [number, number])[]

/** A bearing (clockwise from up) as a direction [x, y]. */
export function towards(bearing: number): [number, number] {
  return [Math.sin(bearing), Math.cos(bearing)]
}

export function circle(x: number, y: number, radius: number, corners = 32): Outline {
  return arc(x, y, radius, 0, 2 * Math.PI, corners).slice(0, -1)
}

/** Points along an arc, both ends included; angles counter-clockwise from the x-axis. */
function arc(
  x: number,
  y: number,
  radius: number,
  from: number,
  to: number,
  steps: number,
): [number, number][] {
  return Array.from({ length: steps + 1 }, (_, step) => {
    const angle = from + ((to - from) * step) / steps
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]
  })
}

/** A band round two circles, at (0, 0) and at `distance` in the direction `bearing`. */
export function band(radius: number, distance: number, bearing: number, other: number): Outline {
  if (distance <= Math.abs(radius - other)) {
    const [x, y] = towards(bearing)
    return radius >= other ? circle(0, 0, radius) : circle(x * distance, y * distance, other)
  }
  // The tangent leans towards the smaller circle.
  const lean = Math.acos((radius - other) / distance)
  const middle = Math.PI / 2 - bearing
  const [x, y] = towards(bearing)
  return [
    ...arc(0, 0, radius, middle + lean, middle + 2 * Math.PI - lean, 20),
    ...arc(x * distance, y * distance, other, middle - lean, middle + lean, 14),
  ]
}

/** A piece of a ring, `half` to either side of a bearing; half of it pi or more: a whole disc. */
export function sector(inner: number, outer: number, bearing: number, half: number): Outline {
  if (half >= 3.1) return circle(0, 0, outer, 48)
  const middle = Math.PI / 2 - bearing
  const steps = Math.max(6, Math.ceil(half * 14))
  const back =
    inner > 1e-3 * outer
      ? arc(0, 0, inner, middle + half, middle - half, steps)
      : [[0, 0] as [number, number]]
  return [...arc(0, 0, outer, middle - half, middle + half, steps), ...back]
}

/** A straight-sided strip from one height to another, `from` and `to` wide (halves), x shifted. */
export function strip(low: number, high: number, from: number, to: number): Outline {
  return [
    [-from, low],
    [from, low],
    [to, high],
    [-to, high],
  ]
}

/** A gear wheel of this pitch radius; the first tooth stands at bearing 0. */
export function gear(radius: number, teeth: number): Outline {
  const depth = Math.min(radius * 0.12, (2.1 * radius) / teeth)
  const pitch = (2 * Math.PI) / teeth
  const corners: [number, number][] = []
  for (let tooth = 0; tooth < teeth; tooth++) {
    const middle = Math.PI / 2 + tooth * pitch
    for (const [turn, height] of [
      [-0.3, -0.55],
      [-0.13, 0.45],
      [0.13, 0.45],
      [0.3, -0.55],
    ] as const) {
      const at = radius + height * depth
      corners.push([at * Math.cos(middle + turn * pitch), at * Math.sin(middle + turn * pitch)])
    }
  }
  return corners
}
