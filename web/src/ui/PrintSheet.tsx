import { render } from 'preact'
import type { App } from '../app'
import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { typeset } from '../language/typeset'
import { QUANTITIES } from '../state'
import { Shared } from './context'
import { judged, quantityName, unitOf } from './names'

/** Puts the sheet below the drawing while the page is printed. Returns what ends it. */
export function printing(app: App, page: HTMLElement | null): () => void {
  const place = document.createElement('div')
  place.className = 'on-paper'
  const begin = (): void => {
    // at once: the browser does not wait
    render(
      <Shared.Provider value={app}>
        {app.shown.peek().map((exhibit, index) => (
          <Sheet key={index} exhibit={exhibit} named={app.shown.peek().length > 1} />
        ))}
        <p class="soft">
          {t('At θ = {angle}° of {cycle}°. Made by crankstar {version}.', {
            angle: Number(app.clock.degrees().toFixed(2)),
            cycle: 360 * app.clock.turns.peek(),
            version: app.host.exhibition.version,
          })}
        </p>
      </Shared.Provider>,
      place,
    )
    page?.querySelector('.left')?.append(place)
  }
  const end = (): void => {
    render(null, place)
    place.remove()
  }
  addEventListener('beforeprint', begin)
  addEventListener('afterprint', end)
  return () => {
    end()
    removeEventListener('beforeprint', begin)
    removeEventListener('afterprint', end)
  }
}

/** The orders and the verdict of an engine, as small as they can be read. */
function Sheet({ exhibit, named }: { exhibit: Exhibit; named: boolean }) {
  return (
    <section>
      {named && <h2>{exhibit.name}</h2>}
      <OrderTable exhibit={exhibit} />
      <div class="judged">
        {named && <h2>{exhibit.name}</h2>}
        <dl class="verdict">
          {judged(exhibit).map(([about, facts]) => (
            <div key={about}>
              <dt>{about}</dt>
              {facts.map(({ sentence }) => (
                <dd key={sentence}>{typeset(sentence)}</dd>
              ))}
            </div>
          ))}
        </dl>
      </div>
    </section>
  )
}

function OrderTable({ exhibit }: { exhibit: Exhibit }) {
  const rows = exhibit.table
    .filter(({ remains, estimated }) => remains || estimated)
    .sort((one, other) => QUANTITIES.indexOf(one.quantity) - QUANTITIES.indexOf(other.quantity))
  return (
    <table>
      <thead>
        <tr>
          <th scope="col">{t('quantity')}</th>
          <th scope="col">{t('order')}</th>
          <th scope="col">{t('path')}</th>
          <th scope="col" class="right">
            {t('greatest')}
          </th>
          <th scope="col">{t('vertical')}</th>
          <th scope="col">{t('horizontal')}</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <tr key={`${row.quantity} ${row.order}`}>
            <th scope="row">{quantityName(row.quantity)}</th>
            <td>{row.label}</td>
            <td>{row.path}</td>
            <td class="right">
              {typeset(row.greatest)} {unitOf(exhibit, row.quantity)}
            </td>
            <td>{typeset(row.up)}</td>
            <td>{typeset(row.right)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  )
}
