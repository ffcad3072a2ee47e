import type { Pen } from './pen'
import type { Vector } from './vector'

/** Draws a straight arrow on the screen; one that is hardly long is left out. */
export function straight(
  to: Pen,
  [fromX, fromY]: Vector,
  [tipX, tipY]: Vector,
  colour: string,
  width: number,
): void {
  const long = Math.hypot(tipX - fromX, tipY - fromY)
  if (long < 3) return
  const [dx, dy] = [(tipX - fromX) / long, (tipY - fromY) / long]
  const head = Math.min(12, 0.7 * long)
  to.strokeStyle = to.fillStyle = colour
  to.lineWidth = width
  to.beginPath()
  to.moveTo(fromX, fromY)
  to.lineTo(tipX - head * dx, tipY - head * dy)
  to.stroke()
  to.beginPath()
  to.moveTo(tipX, tipY)
  to.lineTo(tipX - head * dx + 0.45 * head * dy, tipY - head * dy - 0.45 * head * dx)
  to.lineTo(tipX - head * dx - 0.45 * head * dy, tipY - head * dy + 0.45 * head * dx)
  to.fill()
}
