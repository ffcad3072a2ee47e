import { useSignal } from '@preact/signals'
import { message, t } from '../language/messages'
import { set, snapshot, stateText, THEMES, type Theme } from '../state'
import { Above } from './Above'
import { useApp } from './context'
import { EngineName } from './EngineName'
import { Estimates } from './Estimates'
import { Icon } from './icons'
import { canFill, present, toggleFull } from './presenting'
import { rotationText } from './rotation'
import { UnitChoice } from './UnitChoice'

const THEME = {
  auto: message('Colours: as the system'),
  light: message('Colours: light'),
  dark: message('Colours: dark'),
} as const satisfies Record<Theme, string>
/** Milliseconds for which a note stays. */
const NOTED = 4000

/** The first stop of the keyboard, seen while it has the focus: past the controls to the panels. */
function SkipLink() {
  return (
    <button
      type="button"
      class="skip"
      onClick={({ currentTarget }) => {
        const page = currentTarget.closest('.crankstar')
        page?.querySelector<HTMLElement>('.tabs [aria-selected=true]')?.focus()
      }}
    >
      {t('Skip to the panels')}
    </button>
  )
}

/** The engine's name, how it turns, and what concerns the page as a whole. */
export function Header() {
  const app = useApp()
  const { shown, store, clock, host, guide, dialog } = app
  const note = useSignal('')
  const theme = store.theme.value
  const next = THEMES[(THEMES.indexOf(theme) + 1) % THEMES.length] ?? 'auto'

  async function copy(): Promise<void> {
    // the link shows the present view, so it holds the angle even while the engine turns
    const text = stateText({ ...snapshot(store), angle: Number(clock.degrees().toFixed(2)) })
    const address = `${location.href.split('#')[0]}#${text}`
    try {
      await navigator.clipboard.writeText(address)
      note.value =
        location.protocol === 'file:'
          ? t('Link copied. It opens this file: send the file with it.')
          : t('Link copied.')
    } catch {
      host.writeState(text)
      note.value = t('Copy the link from the address bar.')
    }
    window.setTimeout(() => set(note, ''), NOTED)
  }

  return (
    <header class="head">
      {host.kind !== 'widget' && <SkipLink />}
      <div class="names">
        {shown.value.map((exhibit, index) => (
          <div class="name" key={index}>
            <EngineName index={index} />
            <p class="about">
              {rotationText(exhibit)}
              {exhibit.speed_rpm !== null && (
                <>
                  {' · '}
                  <span class="whole">
                    {t('{speed} rpm', { speed: Number(exhibit.speed_rpm.toPrecision(6)) })}
                  </span>
                </>
              )}
              <Estimates exhibit={exhibit} />
            </p>
          </div>
        ))}
      </div>
      <div class="tools">
        <Above />
        <UnitChoice />
        <span class="said" role="status">
          {note.value}
        </span>
        <button
          type="button"
          class="plain"
          aria-pressed={guide.value > 0}
          aria-label={t('Guide')}
          onClick={() => set(guide, guide.value ? 0 : 1)}
        >
          <Icon name="guide" />
          <span>{t('Guide')}</span>
        </button>
        <button type="button" class="plain" onClick={() => set(dialog, 'export')}>
          <Icon name="export" />
          <span>{t('Export')}</span>
        </button>
        {host.kind !== 'widget' && (
          <button
            type="button"
            class="plain"
            aria-label={t('Copy link')}
            onClick={() => void copy()}
          >
            <Icon name="link" />
            <span>{t('Copy link')}</span>
          </button>
        )}
        <button
          type="button"
          class="plain terse"
          title={t('Presentation: large type, no controls (p)')}
          onClick={() => present(app, true)}
        >
          <Icon name="present" />
          <span>{t('Present')}</span>
        </button>
        {canFill() && (
          <button
            type="button"
            class="plain terse"
            title={t('Full screen (f)')}
            onClick={({ currentTarget }) =>
              void toggleFull(currentTarget.closest<HTMLElement>('.crankstar'))
            }
          >
            <Icon name="full" />
            <span>{t('Full screen')}</span>
          </button>
        )}
        <button
          type="button"
          class="plain terse"
          onClick={() => set(store.theme, next)}
          aria-label={t(THEME[theme])}
          title={t(THEME[theme])}
        >
          <Icon name={theme} />
          <span>{t('Colours')}</span>
        </button>
      </div>
    </header>
  )
}
