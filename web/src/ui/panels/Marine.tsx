import { message, t } from '../../language/messages'
import { useExhibit } from '../context'
import type { Panel } from '../panel'
import { Told } from '../Told'

export const marine: Panel = {
  key: 'marine',
  label: message('Ship'),
  Content: MarinePanel,
  when: ({ shown }) => shown.value.some(({ marine: tables }) => tables.length > 0),
  of: 'each',
}

/** What a large two-stroke engine does to its ship: external moments, guide-force moments. */
function MarinePanel() {
  const exhibit = useExhibit()
  const needs = t(
    'This is of large two-stroke engines in line, with masses, sizes, speed and gas in their file.',
  )
  return <Told exhibit={exhibit} figure="guide-moments" tables={exhibit.marine} needs={needs} />
}
