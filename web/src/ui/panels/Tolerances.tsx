import { message, t } from '../../language/messages'
import { useExhibit } from '../context'
import type { Panel } from '../panel'
import { Told } from '../Told'

export const tolerances: Panel = {
  key: 'tolerances',
  label: message('Tolerances'),
  Content: TolerancesPanel,
  when: ({ shown }) => shown.value.some(({ tolerances: tables }) => tables.length > 0),
  of: 'each',
}

/** How engines built to the tolerances of the file scatter, and which tolerance matters most. */
function TolerancesPanel() {
  const exhibit = useExhibit()
  const needs = t(
    'The file of this engine has no tolerances; write them behind the values, as in 650 g +- 2 g.',
  )
  return <Told exhibit={exhibit} figure="scatter" tables={exhibit.tolerances} needs={needs} />
}
