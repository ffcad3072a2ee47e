import { computed, effect, untracked } from '@preact/signals'
import { useLayoutEffect, useRef } from 'preact/hooks'
import type { App } from '../app'
import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { createStage } from '../stage'
import type { Stage, View } from '../stage/stage'
import { set } from '../state'
import { useApp } from './context'
import { listenForSights } from './gestures'

/** What the stage is to draw at this angle. */
export function viewOf({ store, dark, sight, twist, mounts }: App, theta: number): View {
  const orders = store.orders.value
  return {
    theta,
    camera: sight.value,
    arrows: {
      force: store.force.value,
      couple: store.couple.value,
      roll: store.roll.value,
      axes: store.axes.value,
      each: store.each.value,
      orders,
      scale: store.scale.value,
    },
    whirl: { magnification: store.whirl.value, orders },
    twist: twist.value,
    mounts: mounts.value,
    glass: store.glass.value,
    glow: store.glow.value,
    section: store.section.value,
    dark: dark.value,
  }
}

/** The least stage that has room for four views, pixels. */
const ROOM = { width: 560, height: 380 }
/** What the rows of switches above may take from the stage when the four views become a choice. */
const ROWS = 90

/** Whether four views have room; those that are there stay, although their switches cost height. */
function hasRoom({ clientWidth, clientHeight }: HTMLElement, there: boolean): boolean {
  return clientWidth >= ROOM.width && clientHeight >= ROOM.height - (there ? ROWS : 0)
}

/** One of the engines shown, on a stage of its own. */
export function StageView({
  index,
  made,
}: {
  index: number
  made: (index: number, stage: Stage | null) => void
}) {
  const app = useApp()
  const place = useRef<HTMLDivElement>(null)

  useLayoutEffect(() => {
    const element = place.current
    const first = app.staged.peek()[index]
    if (!element || !first) return undefined
    // before the first frame, so that what is seen first stays
    if (index === 0) set(app.roomy, hasRoom(element, false))
    const stage = createStage(element, first, app.host.exhibition.stroke_colours, app.clock.refresh)
    made(index, stage)
    let current = first
    const compared = computed(() => app.store.tab.value === 'remedies')
    const ends = [
      effect(() => {
        const exhibit = app.staged.value[index] ?? current
        const another = exhibit !== current
        if (another) stage.show(exhibit)
        current = exhibit
        // this engine and the one beside it to one scale; where one switches between them, as it is
        // and with weights too: everywhere else a roll that only shafts leave would make the arrow
        // of the engine as it is too small to be seen
        const cured = compared.value ? app.cured.value : []
        const all = new Set([...app.staged.value, ...app.engines.value, ...cured])
        stage.beside(
          [...all].filter((other): other is Exhibit => other != null && other !== current),
        )
        // at once: where drawing takes long, the wait for the next frame is not to be added to it
        if (another) stage.draw(untracked(() => viewOf(app, (app.clock.degrees() * Math.PI) / 180)))
        app.clock.refresh()
      }),
      app.clock.follow((theta) => stage.draw(viewOf(app, theta))),
      effect(() => {
        viewOf(app, 0)
        app.clock.refresh()
      }),
    ]
    const sized = new ResizeObserver(() => {
      if (index === 0) set(app.roomy, hasRoom(element, app.roomy.peek()))
      stage.resize()
      app.clock.refresh()
    })
    sized.observe(element)
    ends.push(listenForSights(element, app, stage))
    return () => {
      sized.disconnect()
      for (const end of ends) end()
      made(index, null)
      stage.dispose()
    }
  }, [app, index])

  const exhibit = app.shown.value[index]
  const other = app.shown.value[1 - index]
  return (
    <section class="stage" aria-label={exhibit?.name}>
      {other && exhibit && (
        <p class="label">
          {exhibit.scene.length_unit === other.scene.length_unit
            ? exhibit.name
            : t('{engine}, drawn with equal crank radius', { engine: exhibit.name })}
        </p>
      )}
      <div class="canvas" ref={place} />
    </section>
  )
}
