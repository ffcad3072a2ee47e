import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'

/** Layout, firing, units and unverified values of an engine. */
export function Heading({ exhibit: { heading, unverified } }: { exhibit: Exhibit }) {
  return (
    <ul class="heading">
      {heading.map((line) => (
        <li key={line}>{line}</li>
      ))}
      {unverified.length > 0 && (
        <li class="doubt">{t('Unverified values: {paths}.', { paths: unverified.join(', ') })}</li>
      )}
    </ul>
  )
}
