/** Indices of the convex hull of points [x, y], counter-clockwise (A. Andrew's chain). */
export function hull(points: ArrayLike<number>): number[] {
  const x = (index: number) => points[2 * index] as number
  const y = (index: number) => points[2 * index + 1] as number
  const order = Array.from({ length: points.length / 2 }, (_, index) => index).sort(
    (a, b) => x(a) - x(b) || y(a) - y(b),
  )
  const left = (a: number, b: number, c: number) =>
    (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a)) > 0
  const half = (indices: readonly number[]) => {
    const chain: number[] = []
    for (const index of indices) {
      while (
        chain.length > 1 &&
        !left(chain[chain.length - 2] as number, chain[chain.length - 1] as number, index)
      ) {
        chain.pop()
      }
      chain.push(index)
    }
    chain.pop()
    return chain
  }
  return [...half(order), ...half(order.reverse())]
}
