/** Decimals that give the greatest value four figures, the same at every angle. */
export function decimalsOf(greatest: number): number {
  if (!(greatest > 1e-12)) return 0
  return Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(greatest))))
}

/** A number with its sign in the room of a figure, so that rows of numbers do not jump. */
export function signedText(value: number, digits: number): string {
  const text = Math.abs(value).toFixed(digits)
  const zero = Number(text) === 0
  return `${zero ? '\u2007' : value < 0 ? '−' : '+'}${text}`
}
