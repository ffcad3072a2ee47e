import { language, message, t } from '../../language/messages'
import { set } from '../../state'
import { Choice } from '../Choice'
import { useApp } from '../context'
import { Heading } from '../Heading'
import { KeyList } from '../keyList'
import { NOTICES } from '../notices'
import type { Panel } from '../panel'

export const about: Panel = {
  key: 'about',
  label: message('About'),
  Content: About,
  of: 'all',
}

/** Each language by its own name. */
const LANGUAGES = [
  { value: 'en', label: 'English' },
  { value: 'ja', label: '日本語' },
  { value: 'ru', label: 'Русский' },
]

/** Sources, assumptions, how to read the page, and how to write it again. */
function About() {
  const { host, shown, store, engines } = useApp()
  const { command, version, sources = [] } = host.exhibition
  const asOpened = (index: number): boolean =>
    same(engines.value[index]?.file, host.exhibition.engines[index]?.file)
  return (
    <>
      {shown.value.map((exhibit, index) => (
        <section key={index}>
          <h2>{exhibit.name}</h2>
          <Heading exhibit={exhibit} />
          {sourceOf(exhibit.file).map((line) => (
            <p key={line}>
              <span class="soft">{t('Source:')}</span> {line}
            </p>
          ))}
          {sources[index] && asOpened(index) && (
            <p>
              <span class="soft">{t('Opened as')}</span> <code>{sources[index]}</code>
            </p>
          )}
          <Assumptions lines={[...exhibit.scene.assumed, ...exhibit.whirl.assumed]} />
        </section>
      ))}
      <section>
        <h2>{t('Conventions')}</h2>
        <p>
          {t(
            'The engine is seen from the front, the end opposite the flywheel. The crank angle θ is zero at top dead centre of cylinder 1 and grows in the direction of rotation. A couple is drawn in the plane in which it acts.',
          )}
        </p>
        <h3>{t('Keys')}</h3>
        <KeyList />
      </section>
      <section>
        <h2>{t('This page')}</h2>
        <Choice
          label={t('Language')}
          value={language.value}
          choices={LANGUAGES}
          chosen={(code) => set(store.language, code)}
        />
        {host.written && host.written !== language.value && (
          <p>
            {t(
              'Verdict, tables and figures are in the language in which this file was written. {option} with crankstar page writes them in this one.',
              { option: `--lang ${language.value}` },
            )}
          </p>
        )}
        <p>{t('Made by crankstar {version}.', { version })}</p>
        {store.engine.value.startsWith('~') && (
          <p>
            {t('This engine is only in the link of the page. Save it as TOML (Edit) to keep it.')}
          </p>
        )}
        {command && asOpened(0) && (
          <p>
            {t('Command:')} <code>{command}</code>
          </p>
        )}
        <details class="notices">
          <summary>{t('Licences of the software in this page')}</summary>
          <pre>{NOTICES}</pre>
        </details>
      </section>
    </>
  )
}

function Assumptions({ lines }: { lines: readonly string[] }) {
  if (!lines.length) return null
  return (
    <>
      <h3>{t('Assumptions')}</h3>
      <ul class="heading">
        {lines.map((line) => (
          <li key={line}>{line}</li>
        ))}
      </ul>
    </>
  )
}

const same = (one: unknown, other: unknown): boolean =>
  JSON.stringify(one) === JSON.stringify(other)

/** The `source` of the engine file, if it is text. */
function sourceOf(file: Readonly<Record<string, unknown>>): string[] {
  const { source } = file
  if (typeof source === 'string') return [source]
  return Array.isArray(source)
    ? source.filter((line): line is string => typeof line === 'string')
    : []
}
