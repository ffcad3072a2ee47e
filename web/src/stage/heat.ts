import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { loadName, type Twist, topText } from '../torsion'
import type { Palette } from './palette'
import type { Pen } from './pen'
import type { Slice } from './section'
import { tintOf } from './twist'

/** Where there is room for it: on a stage of this width, at this distance from its edge. */
interface Where {
  readonly width: number
  readonly palette: Palette
  readonly slice: Slice | null
  /** Whether there is little room. */
  readonly small: boolean
  readonly rim: number
}

/**
 * The magnification of the twist, and what the colours of the crank mean: at the upper right, where
 * there is little room in one line at the upper left.
 */
export function heat(
  to: Pen,
  exhibit: Exhibit,
  twist: Twist,
  { width, palette, slice, small, rim }: Where,
): void {
  const times = t('Twist × {times}', { times: Number(twist.times.toPrecision(3)) })
  to.font = '12px system-ui, sans-serif'
  to.textBaseline = 'middle'
  to.textAlign = 'left'
  const widthOf = (text: string): number => to.measureText(text).width
  const said = small || !(twist.top > 0) ? times : `${times} · ${loadName(twist)}`
  const level = small && slice ? 32 : 12
  const begin = small ? 12 : width - rim - widthOf(said)
  outlined(to, palette, said, begin, level)
  if (!(twist.top > 0)) return
  const [least, most] = ['0', topText(exhibit, twist)]
  const long = small ? BAR / 2 : BAR
  const breadth = widthOf(least) + long + widthOf(most) + 12
  const from = small ? begin + widthOf(said) + 10 : width - rim - breadth
  const y = small ? level : level + 18
  const bar = from + widthOf(least) + 6
  const step = long / HEAT_STEPS
  outlined(to, palette, least, from, y)
  for (let place = 0; place < HEAT_STEPS; place++) {
    const [red = 0, green = 0, blue = 0] = tintOf(place / (HEAT_STEPS - 1))
    to.fillStyle = `rgb(${255 * red} ${255 * green} ${255 * blue})`
    to.fillRect(bar + place * step, y - 5, step + 0.5, 10)
  }
  outlined(to, palette, most, bar + long + 6, y)
}

/** Length of the bar of colours, pixels, and in how many steps it is drawn. */
const [BAR, HEAT_STEPS] = [72, 24]

/** A text that can be read on whatever stands behind it. */
function outlined(to: Pen, palette: Palette, text: string, x: number, y: number): void {
  to.lineWidth = 3
  to.strokeStyle = palette.paper
  to.strokeText(text, x, y)
  to.fillStyle = palette.text
  to.fillText(text, x, y)
}
