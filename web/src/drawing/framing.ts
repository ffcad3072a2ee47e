import type { View } from 'vega'
import type { Spec } from '../host/host'

/** What of Vega's specifications and scenes is looked at here. */
interface Part {
  readonly type?: string
  readonly name?: string
  readonly layout?: unknown
  readonly marks?: readonly Part[]
}
interface Bounds {
  readonly x1: number
  readonly y1: number
  readonly x2: number
  readonly y2: number
}
interface Item {
  readonly width?: number
  readonly height?: number
  readonly items?: readonly Mark[]
}
interface Mark {
  readonly name?: string
  readonly role?: string
  readonly bounds?: Bounds
  readonly items?: readonly Item[]
}

/** Number of looks at a panel, at angles that no order repeats. */
const LOOKS = 21
const GOLDEN = (Math.sqrt(5) - 1) / 2
/** What a label may reach farther between two looks, px. */
const MARGIN = 3

/** The panels of a figure that stand beside or below each other, by name. */
export function panelsOf(spec: Part): readonly string[] {
  const groups = (spec.marks ?? []).filter((mark) => mark.type === 'group')
  if (!spec.layout) return []
  return groups.flatMap((group) =>
    group.layout ? panelsOf(group) : group.name === undefined ? [] : [group.name],
  )
}

/**
 * The figure with panels that keep their size while it turns: each has an unseen frame about all
 * that its parts reach in a cycle. Without it the layout follows labels that swing out, and the
 * whole figure jumps. `look` is a view of the figure that is not drawn; it is turned to every
 * angle.
 */
export async function framed(
  spec: Spec,
  look: View,
  theta: string,
  cycleDegrees: number,
): Promise<Spec> {
  const names = new Set(panelsOf(spec))
  const reach = new Map<string, Bounds>()
  for (let step = 0; step < LOOKS; step++) {
    await look.signal(theta, cycleDegrees * ((step * GOLDEN) % 1)).runAsync()
    const root = (look.scenegraph() as unknown as { root: Mark }).root
    for (const [name, bounds] of panelsBelow(root, names))
      reach.set(name, united(reach.get(name), bounds))
  }
  return withFrames(spec, reach) as Spec
}

/**
 * The panels below a mark, each with how far it reaches from its own origin, its title left out:
 * that is put above the frame.
 */
function panelsBelow(mark: Mark, names: ReadonlySet<string>): (readonly [string, Bounds])[] {
  return (mark.items ?? []).flatMap((item) => {
    const { width = 0, height = 0, items = [] } = item
    if (mark.name === undefined || !names.has(mark.name))
      return items.flatMap((each) => panelsBelow(each, names))
    const parts = items.flatMap(({ role, bounds }) => (role === 'title' || !bounds ? [] : [bounds]))
    return [[mark.name, parts.reduce(united, { x1: 0, y1: 0, x2: width, y2: height })] as const]
  })
}

function united(one: Bounds | undefined, other: Bounds): Bounds {
  if (!one) return other
  return {
    x1: Math.min(one.x1, other.x1),
    y1: Math.min(one.y1, other.y1),
    x2: Math.max(one.x2, other.x2),
    y2: Math.max(one.y2, other.y2),
  }
}

function withFrames<T extends Part>(part: T, reach: ReadonlyMap<string, Bounds>): T {
  const bounds = part.name === undefined ? undefined : reach.get(part.name)
  const marks = part.marks?.map((mark) => withFrames(mark, reach))
  if (!marks) return part
  return { ...part, marks: bounds ? [frame(bounds), ...marks] : marks }
}

function frame({ x1, y1, x2, y2 }: Bounds): Part {
  const value = (number: number) => ({ value: number })
  const [left, top, right, bottom] = [x1 - MARGIN, y1 - MARGIN, x2 + MARGIN, y2 + MARGIN].map(value)
  const enter = { x: left, y: top, x2: right, y2: bottom, fill: { value: 'transparent' } }
  return { type: 'rect', aria: false, interactive: false, encode: { enter } } as Part
}
