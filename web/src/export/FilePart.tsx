import type { Exhibit } from '../exhibit'
import type { ExportForm } from '../host/host'
import { message, t } from '../language/messages'
import { useApp } from '../ui/context'
import { CopyButton } from './CopyButton'
import { AMPLITUDES, amplitudes, csv } from './csv'
import { angleWord, engineName, sourceName } from './fileNames'
import type { Running } from './running'

/** What only Python writes: its form, the end of its name, and what it is. */
const FORMS = [
  ['xlsx', '.xlsx', message('All tables, with the engine, for Excel')],
  ['report', '-report.html', message('The report, for print')],
  ['page', '.html', message('This page as one file')],
  ['glb', '.glb', message('The moving parts for slides and viewers (glTF)')],
  ['stl', '.stl', message('The moving parts for CAD (STL)')],
  ['py', '.py', message('A multibody model for EXUDYN')],
] as const satisfies readonly (readonly [ExportForm, string, string])[]
const SOLID: readonly ExportForm[] = ['glb', 'stl']
const VERBS: Readonly<Partial<Record<ExportForm, string>>> = {
  xlsx: 'analyze',
  report: 'report',
  page: 'page',
}

/** The engine that the panels show as files: its own, its numbers, and what Python makes of it. */
export function FilePart({ running: { keep, busy } }: { running: Running }) {
  const app = useApp()
  const { host, clock } = app
  const exhibit = app.shown.value[app.subject.value]
  if (!exhibit) return null
  const name = engineName(app, exhibit)
  const degrees = Number(clock.degrees().toFixed(2))
  const json = (): Blob =>
    new Blob([`${JSON.stringify(exhibit.file, null, 2)}\n`], { type: 'application/json' })
  const toml = async (): Promise<Blob> => {
    const answer = await host.service?.toml(exhibit.file)
    if (answer?.ok) return new Blob([answer.value], { type: 'application/toml' })
    throw new Error(answer?.problems.map(({ message }) => message).join(' '))
  }
  const numbers = (): Blob =>
    new Blob([csv([AMPLITUDES, ...amplitudes(exhibit)])], { type: 'text/csv' })
  return (
    <section>
      <h3>{t('The engine: {engine}', { engine: exhibit.name })}</h3>
      <ul class="exports">
        <li>
          <span>{t('The engine file, which crankstar reads')}</span>
          <span class="buttons">
            {host.service && (
              <button
                type="button"
                disabled={busy.value}
                onClick={() => void keep(`${name}.toml`, toml)}
              >
                TOML
              </button>
            )}
            <button
              type="button"
              disabled={busy.value}
              onClick={() => void keep(`${name}.json`, json)}
            >
              JSON
            </button>
          </span>
        </li>
        <li>
          <span>{t('Amplitude and phase of every order')}</span>
          <button
            type="button"
            disabled={busy.value}
            data-file="amplitudes"
            onClick={() => void keep(`${name}-amplitudes.csv`, numbers)}
          >
            CSV
          </button>
        </li>
        {host.service &&
          FORMS.map(([form, end, about]) => (
            <li key={form}>
              <span>{t(about)}</span>
              <button
                type="button"
                disabled={busy.value}
                data-file={form}
                onClick={() =>
                  void keep(
                    `${name}${SOLID.includes(form) ? `-${angleWord(degrees)}` : ''}${end}`,
                    () => host.service?.exported(exhibit, form, degrees) ?? Promise.reject(),
                  )
                }
              >
                {end.split('.').pop()?.toUpperCase()}
              </button>
            </li>
          ))}
      </ul>
      {!host.service && <Commands exhibit={exhibit} name={name} />}
    </section>
  )
}

/** How the command line writes what a page without Python cannot. */
function Commands({ exhibit, name }: { exhibit: Exhibit; name: string }) {
  const app = useApp()
  const source = sourceName(app, exhibit)
  const from = quoted(source ?? `${name}.json`)
  return (
    <>
      <p class="soft small">
        {source === null
          ? t('The command line writes the rest, from the engine file that you save as JSON:')
          : t('The command line writes the rest:')}
      </p>
      <ul class="exports">
        {FORMS.filter(([form]) => form !== 'page' || app.host.kind === 'widget').map(
          ([form, end, about]) => {
            const command = `crankstar ${VERBS[form] ?? 'export'} ${from} -o ${quoted(`${name}${end}`)}`
            return (
              <li key={form}>
                <span>
                  {t(about)}
                  <br />
                  <code>{command}</code>
                </span>
                <CopyButton text={command} label={t('Copy the command')} />
              </li>
            )
          },
        )}
      </ul>
    </>
  )
}

/** A word of a command line. */
const quoted = (word: string): string =>
  /^[\w./:@%+,-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`
