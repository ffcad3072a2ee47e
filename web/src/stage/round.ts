/** The greatest of 1, 2, 5, 10, ... that is not above a value. */
export function roundValue(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  const step = value / power
  return power * (step >= 5 ? 5 : step >= 2 ? 2 : 1)
}

/** A round value with its unit. */
export function quantity(value: number, unit: string): string {
  return `${+value.toPrecision(3)} ${unit}`
}
