import { message } from '../language/messages'

/** An example: a question, what to look at, and the state of the page that shows it. */
export interface Tour {
  readonly title: string
  readonly text: string
  readonly state: string
}

/** The engines of a tour by their names in the catalog: that on the stage, that beside it. */
export function enginesOf(tour: Tour): readonly string[] {
  const state = new URLSearchParams(tour.state)
  return ['engine', 'beside'].flatMap((key) => state.get(key) ?? [])
}

/** The tour on a page that was opened with its engines. */
export function onThisPage(tour: Tour): string {
  const state = new URLSearchParams(tour.state)
  for (const key of ['engine', 'beside']) state.delete(key)
  return state.toString()
}

/** Examples from the catalog, as links would open them. */
export const TOURS: readonly Tour[] = [
  {
    title: message('Why does a flat-plane V8 buzz?'),
    text: message(
      'Its secondary force remains and shakes it from side to side; beside it the cross-plane V8, which has none.',
    ),
    state: 'engine=v8-flat-plane&beside=v8-cross-plane&orders=2&of=force&tab=compare',
  },
  {
    title: message('Why does a cross-plane V8 burble?'),
    text: message(
      'Its banks fire unevenly, which leaves half orders of the exhaust: hear it beside the flat-plane V8.',
    ),
    state: 'engine=v8-flat-plane&beside=v8-cross-plane&tab=sound',
  },
  {
    title: message('What does a balance shaft do?'),
    text: message(
      'A 360° twin as it is; the switch under Balancing fits the shafts that take its force away.',
    ),
    state: 'engine=i2-360&orders=1&of=force&tab=remedies',
  },
  {
    title: message('What is a balance factor?'),
    text: message(
      'Counterweights turn the primary force of a single from an up-and-down line into a circle.',
    ),
    state: 'engine=single&orders=1&of=force&tab=remedies&camera=front',
  },
  {
    title: message('The Kawasaki KR250'),
    text: message('Two crankshafts geared together: what one sense or the other leaves.'),
    state: 'engine=kr250-racer&beside=kr250-production&of=couple&tab=compare',
  },
]
