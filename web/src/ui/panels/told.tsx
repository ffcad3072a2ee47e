import type { App } from '../../app'
import type { PanelShown } from '../../exhibit'
import { useExhibit } from '../context'
import type { Panel } from '../panel'
import { Told } from '../Told'

const made = new Map<string, Panel>()

/** The panels of analyses that are shown as their command prints them, which the page brings. */
export function toldPanels({ host }: App): Panel[] {
  return host.exhibition.panels.map((shown) => {
    const panel = made.get(shown.key) ?? toldPanel(shown)
    made.set(shown.key, panel)
    return panel
  })
}

function toldPanel({ key, label, needs, figures }: PanelShown): Panel {
  return {
    key,
    label,
    when: ({ shown }) => shown.value.some(({ told }) => told[key]),
    of: 'each',
    Content: () => {
      const exhibit = useExhibit()
      return (
        <Told exhibit={exhibit} figures={figures} tables={exhibit.told[key] ?? []} needs={needs} />
      )
    },
  }
}
