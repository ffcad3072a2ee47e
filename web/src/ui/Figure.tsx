import { useSignal } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import { counted } from '../activity'
import type { Drawing } from '../drawing/drawing'
import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { reasonOf } from '../reason'
import { useApp } from './context'
import { Scroller } from './Scroller'

/** A figure of an engine by its key, turning with it; the old one stays until the next. */
export function Figure({
  exhibit,
  chart,
  label,
}: {
  exhibit: Exhibit
  chart: string
  label: string
}) {
  const { host, clock, shown: onStage } = useApp()
  const both = onStage.value
  // figures of two engines on the stage have one scale
  const beside = both.includes(exhibit) ? both.find((other) => other !== exhibit) : undefined
  const figure = useRef<HTMLElement>(null)
  const place = useRef<HTMLDivElement>(null)
  const shown = useRef<Drawing | null>(null)
  const last = useRef<Promise<unknown>>(Promise.resolve())
  const trouble = useSignal('')
  const inView = useRef(true)
  const there = useSignal(false)
  const busy = useSignal(true)
  const attempt = useSignal(0)
  const again = attempt.value

  useEffect(() => {
    let ended = false
    busy.value = true
    async function draw(): Promise<void> {
      if (ended) return
      try {
        const asked = [host.chart(exhibit, chart, beside), host.drawing()] as const
        const [spec, drawn] = await Promise.all(asked)
        if (ended) return
        const made = await drawn(spec, 360 * exhibit.turns)
        if (ended) return made.dispose()
        if (made.turns) await made.turnTo(clock.degrees() % (360 * exhibit.turns))
        shown.current?.dispose()
        place.current?.replaceChildren(made.element)
        // figures that stand beside each other are drawn to one scale, near their own
        figure.current?.style.setProperty('--natural', String(made.width))
        shown.current = made
        there.value = true
        trouble.value = ''
      } catch (error) {
        if (ended) return
        shown.current?.dispose()
        shown.current = null
        there.value = false
        trouble.value = reasonOf(error)
      } finally {
        if (!ended) busy.value = false
      }
    }
    // one after the other: during a drag only the newest is requested
    last.current = counted(last.current.then(draw))
    const turn = () => {
      const drawing = shown.current
      return drawing?.turns ? drawing.turnTo(clock.degrees() % (360 * exhibit.turns)) : undefined
    }
    // what is scrolled away need not turn with the engine, but is right when it stops, and on paper
    const unfollow = clock.followInTurn(() =>
      inView.current || !clock.playing.peek() ? turn() : undefined,
    )
    addEventListener('beforeprint', turn)
    return () => {
      ended = true
      unfollow()
      removeEventListener('beforeprint', turn)
    }
  }, [host, clock, exhibit, beside, chart, again])

  useEffect(() => {
    const watch = new IntersectionObserver((changes) => {
      inView.current = changes.at(-1)?.isIntersecting ?? true
    })
    if (figure.current) watch.observe(figure.current)
    return () => {
      watch.disconnect()
      shown.current?.dispose()
    }
  }, [])

  return (
    <figure
      ref={figure}
      class={`figure${there.value ? '' : ' empty'}`}
      data-chart={chart}
      aria-busy={busy.value}
    >
      <Scroller label={`${label}. ${exhibit.name}.`} hint={t('The figure scrolls sideways')}>
        <div class="drawing" ref={place} role="img" aria-label={`${label}. ${exhibit.name}.`} />
      </Scroller>
      {!there.value && !trouble.value && (
        <p class="wait">{t('Drawing {figure} …', { figure: label })}</p>
      )}
      {trouble.value && (
        <p class="wait">
          {trouble.value}{' '}
          <button
            type="button"
            onClick={() => {
              attempt.value += 1
            }}
          >
            {t('Try again')}
          </button>
        </p>
      )}
    </figure>
  )
}
