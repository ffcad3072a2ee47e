import { useSignal } from '@preact/signals'
import { useMemo } from 'preact/hooks'
import { message, t } from '../language/messages'
import { set } from '../state'
import { Choice } from '../ui/Choice'
import { useApp } from '../ui/context'
import { Dialog } from '../ui/Dialog'
import { csv, rowsOf } from './csv'
import { Embedding } from './Embedding'
import { FilePart } from './FilePart'
import { FilmPart } from './FilmPart'
import { figuresIn, rastered, standalone, tablesIn } from './figures'
import { angleWord, fileName } from './fileNames'
import { drawnAsSvg, GROUNDS, type Ground, photographed, pictureName } from './picture'
import { type Running, useRunning } from './running'
import { png, svg } from './saving'

const GROUND = {
  light: message('light'),
  dark: message('dark'),
} as const satisfies Record<Ground, string>
/** Pixels of a picture to one of the page. */
const DENSITIES = [2, 4] as const

/** All that a reader can take away from the page. */
export function ExportDialog() {
  const { dialog } = useApp()
  return (
    <Dialog name="export" title={t('Export')}>
      {dialog.value === 'export' && <Inside />}
    </Dialog>
  )
}

function Inside() {
  const app = useApp()
  const ground = useSignal<Ground>(app.dark.peek() ? 'dark' : 'light')
  const running = useRunning()
  const { said } = running
  return (
    <>
      <Choice
        label={t('Background of pictures')}
        value={ground.value}
        choices={GROUNDS.map((value) => ({ value, label: t(GROUND[value]) }))}
        chosen={(value) => set(ground, value)}
      />
      <Stages ground={ground.value} running={running} />
      <FilmPart ground={ground.value} running={running} />
      <Panels ground={ground.value} running={running} />
      <FilePart running={running} />
      <Embedding />
      <p class={`saying${said.value.wrong ? ' wrong' : ''}`} role="status">
        {said.value.text}
      </p>
    </>
  )
}

interface PartProps {
  readonly ground: Ground
  readonly running: Running
}

function Stages({ ground, running: { keep, busy } }: PartProps) {
  const app = useApp()
  return (
    <section>
      <h3>{t('The engine as it stands')}</h3>
      <div class="buttons">
        {DENSITIES.map((density) => (
          <button
            key={density}
            type="button"
            disabled={busy.value}
            data-file={`png-${density}`}
            onClick={() =>
              void keep(
                pictureName(app, 'png', angleWord(app.clock.degrees()), `${density}x`),
                () => png(photographed(app, density, ground)),
              )
            }
          >
            {t('PNG, {times} ×', { times: density })}
          </button>
        ))}
        <button
          type="button"
          disabled={busy.value}
          data-file="svg"
          onClick={() => void keep(pictureName(app, 'svg'), () => svg(drawnAsSvg(app, ground)))}
        >
          SVG
        </button>
        <span class="soft small">{t('SVG is drawn flat, as lines that stay sharp.')}</span>
      </div>
    </section>
  )
}

/** Figures and tables of the panel that is open behind the dialog. */
function Panels({ ground, running: { keep, busy } }: PartProps) {
  const app = useApp()
  const panel = useMemo(() => document.querySelector('.crankstar [data-panel]'), [])
  const name = app.shown.value[app.subject.value]?.name ?? ''
  const [figures, tables] = useMemo(
    () => (panel ? [figuresIn(panel, name), tablesIn(panel)] : [[], []]),
    [panel, name],
  )
  const key = app.store.tab.value
  const angle = app.clock.degrees()
  const drawing = (figure: (typeof figures)[number]): string =>
    standalone(figure.element, ground, `${name}. ${figure.label}`)
  if (!figures.length && !tables.length) return null
  return (
    <section>
      <h3>
        {t('The open panel: {panel}', { panel: panel?.querySelector('h2')?.textContent ?? key })}
      </h3>
      <ul class="exports">
        {figures.map((figure) => (
          <li key={figure.label}>
            <span>{figure.label}</span>
            <span class="buttons">
              {(['png', 'svg'] as const).map((kind) => (
                <button
                  key={kind}
                  type="button"
                  disabled={busy.value}
                  aria-label={`${figure.label}: ${kind.toUpperCase()}`}
                  onClick={() =>
                    void keep(
                      fileName(app, kind, key, figure.label.split(':')[0] ?? '', angleWord(angle)),
                      () => (kind === 'svg' ? svg(drawing(figure)) : rastered(drawing(figure))),
                    )
                  }
                >
                  {kind.toUpperCase()}
                </button>
              ))}
            </span>
          </li>
        ))}
        {tables.map((table) => (
          <li key={table.label}>
            <span>{t('Table: {name}', { name: table.label })}</span>
            <button
              type="button"
              disabled={busy.value}
              aria-label={`${table.label}: CSV`}
              onClick={() =>
                void keep(
                  fileName(app, 'csv', key, table.label === key ? '' : table.label),
                  () => new Blob([csv(rowsOf(table.element))], { type: 'text/csv' }),
                )
              }
            >
              CSV
            </button>
          </li>
        ))}
      </ul>
    </section>
  )
}
