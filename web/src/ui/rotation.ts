import type { Exhibit } from '../exhibit'
import { language, t } from '../language/messages'

/** Which way each crankshaft turns, seen from the front. */
export function rotationText({ scene, sense }: Exhibit): string {
  const cranks = scene.shafts.filter(({ kind }) => kind === 'crankshaft')
  const names = (way: 1 | -1): string[] =>
    cranks.filter(({ speed_ratio }) => way * sense * speed_ratio > 0).map(({ name }) => name)
  const [right, left] = [names(1), names(-1)]
  if (right.length > 0 && left.length > 0) {
    const list = new Intl.ListFormat(language.value)
    return t(
      'Crankshafts counter-rotate, seen from the front: {clockwise} clockwise, {other} counter-clockwise',
      {
        clockwise: list.format(right),
        other: list.format(left),
      },
    )
  }
  if (cranks.length > 1)
    return left.length > 0
      ? t('Crankshafts turn counter-clockwise, seen from the front')
      : t('Crankshafts turn clockwise, seen from the front')
  return left.length > 0
    ? t('Crankshaft turns counter-clockwise, seen from the front')
    : t('Crankshaft turns clockwise, seen from the front')
}
