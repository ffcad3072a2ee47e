import { Figure } from '../Figure'
import { useExhibit } from '../context'
export function Forces() {
  const exhibit = useExhibit()
  return <div class="figures">{exhibit.charts.filter((one) => ['over-turn','hodograph'].includes(one.figure)).slice(0,8).map((one) => <Figure key={one.key} exhibit={exhibit} chart={one.key} label={one.label} />)}</div>
}
