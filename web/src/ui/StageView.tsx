import { effect, untracked } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import type { App } from '../app'
import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { createStage } from '../stage'
import type { Stage, View } from '../stage/stage'
import { useApp } from './context'

/** What the stage is to draw at this angle. */
function viewOf({ store, dark }: App, theta: number): View {
  const orders = store.orders.value
  return {
    theta,
    camera: store.camera.value,
    arrows: {
      force: store.force.value,
      couple: store.couple.value,
      cylinders: store.cylinders.value,
      orders,
      scale: store.scale.value,
    },
    whirl: { magnification: store.whirl.value, orders },
    glass: store.glass.value,
    glow: store.glow.value,
    dark: dark.value,
  }
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

  useEffect(() => {
    const element = place.current
    const first = app.shown.peek()[index]
    if (!element || !first) return undefined
    const stage = createStage(element, first, app.host.exhibition.stroke_colours, app.clock.refresh)
    made(index, stage)
    let current = first
    const ends = [
      effect(() => {
        const exhibit = app.shown.value[index] ?? current
        const another = exhibit !== current
        if (another) stage.show(exhibit)
        current = exhibit
        // as it is and with weights, this engine and the one beside it: all to one scale
        const all = [...app.engines.value, ...app.cured.value]
        stage.beside(all.filter((other): other is Exhibit => other != null && other !== current))
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
      stage.resize()
      app.clock.refresh()
    })
    sized.observe(element)
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
