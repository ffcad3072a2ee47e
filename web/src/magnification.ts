/** A magnification near a factor: 1, 2 or 5 times a power of ten. */
export function roundFactor(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  const first = value / power
  return Number(((first < 1.5 ? 1 : first < 3.5 ? 2 : first < 7.5 ? 5 : 10) * power).toPrecision(1))
}
