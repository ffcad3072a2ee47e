/** A number with four figures. */
function figures(value: number): string {
  if (value === 0) return '0'
  const size = Math.abs(value)
  const text =
    size >= 1e5 || size < 1e-4 ? value.toExponential(3) : Number(value.toPrecision(4)).toString()
  return text.replace('-', '−')
}

/** A length of a scene: in mm or µm where the scene is in metres. */
export function lengthText(length: number, unit: string): string {
  if (unit !== 'm') return `${figures(length)} ${unit}`
  const size = Math.abs(length)
  if (size !== 0 && size < 1e-9) return '0'
  return size !== 0 && size < 1e-4 ? `${figures(length * 1e6)} µm` : `${figures(length * 1e3)} mm`
}

/** A number with its unit. */
export function quantityText(value: number, unit: string): string {
  return `${figures(value)} ${unit}`
}
