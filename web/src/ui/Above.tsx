import { language, t } from '../language/messages'
import { useApp } from './context'
import { Icon } from './icons'

/** The way back to the gallery, where the page has one above it. */
export function Above() {
  const { host } = useApp()
  const up = document.querySelector<HTMLLinkElement>('link[rel=up]')
  if (!up || host.kind === 'widget') return null
  const asked = new URLSearchParams(location.search).has('lang')
  const spoken = host.kind === 'server' && (asked || language.value !== host.language)
  return (
    <a
      class="plain above"
      href={spoken ? `${up.href}?lang=${language.value}` : up.href}
      aria-label={t('All engines')}
    >
      <Icon name="engines" />
      <span>{t('All engines')}</span>
    </a>
  )
}
