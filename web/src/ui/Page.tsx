import { useEffect, useRef } from 'preact/hooks'
import { Coded } from '../coded'
import { ExportDialog } from '../export/ExportDialog'
import { language, t } from '../language/messages'
import type { Stage } from '../stage/stage'
import { set } from '../state'
import { useApp } from './context'
import { Editing } from './Editing'
import { Guide } from './Guide'
import { Header } from './Header'
import { KeyDialog } from './KeyDialog'
import { listenForKeys } from './keys'
import { Layers } from './Layers'
import { Leave } from './Leave'
import { Mistakes } from './Mistakes'
import { Now } from './Now'
import { printing } from './PrintSheet'
import { actionOf } from './presenting'
import { StageView } from './StageView'
import { Tabs } from './Tabs'
import { Explanation } from './Term'
import { TimeBar } from './TimeBar'

/** The whole page. `made` gets every stage when it is there, and null when it goes. */
export function Page({ made }: { made: (index: number, stage: Stage | null) => void }) {
  const app = useApp()
  const { shown, host, clock, trouble, dark, store } = app
  const root = useRef<HTMLDivElement>(null)
  useEffect(() => {
    const element = root.current
    if (!element) return undefined
    const heard = host.kind === 'widget' ? element : document
    return listenForKeys(heard, element, clock, (key) => actionOf(app, element, key))
  }, [app, host, clock])
  useEffect(() => printing(app, root.current), [app])
  // a notebook has a main part of its own
  const Body = host.kind === 'widget' ? 'div' : 'main'
  return (
    <div
      class={`crankstar ${host.kind} ${dark.value ? 'dark' : 'light'}${store.present.value ? ' present' : ''}`}
      ref={root}
      lang={language.value}
      data-playing={clock.playing.value}
    >
      <div class="frame">
        <Header />
        {trouble.value && (
          <p class="trouble" role="alert">
            <Coded text={trouble.value} />
            <button type="button" class="plain" onClick={() => set(trouble, '')}>
              {t('Close')}
            </button>
          </p>
        )}
        <Mistakes />
        <Body class="body">
          <div class="left">
            <Layers />
            <div class={`stages${shown.value.length > 1 ? ' two' : ''}`}>
              {shown.value.map((_, index) => (
                <StageView key={index} index={index} made={made} />
              ))}
            </div>
            <Now />
            <TimeBar />
          </div>
          <Tabs />
        </Body>
        <Editing />
      </div>
      <Leave />
      <Guide />
      <ExportDialog />
      <KeyDialog />
      <Explanation />
    </div>
  )
}
