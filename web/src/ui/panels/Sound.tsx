import { useEffect, useMemo } from 'preact/hooks'
import type { Exhaust } from '../../exhibit'
import { message, t } from '../../language/messages'
import { reasonOf } from '../../reason'
import { FASTER, heardAt, pulses, silenced } from '../../sound/exhaust'
import { createPlayer } from '../../sound/player'
import { Bars } from '../Bars'
import { Choice } from '../Choice'
import { useApp, useChoice, useExhibit } from '../context'
import { Each } from '../Each'
import { Icon } from '../icons'
import type { Panel } from '../panel'
import { Term } from '../Term'
import { useOff } from '../torques'

export const sound: Panel = {
  key: 'sound',
  label: message('Sound'),
  Content: Sound,
  when: (app) => app.shown.value.some(({ exhaust }) => exhaust),
}

/** The highest order that is drawn: twice that of the firings of a V16. */
const HIGHEST = 8

/** The exhaust of the engines, heard at a click, and its orders. */
function Sound() {
  const { shown, subjects, store, trouble } = useApp()
  const [speed, choose] = useChoice<'page' | 'engine'>('sound.speed', ['page', 'engine'])
  const player = useMemo(createPlayer, [])
  const [off] = useOff()
  const engines = subjects.value.flatMap((place) => {
    const exhibit = shown.value[place]
    return exhibit?.exhaust ? [{ place, exhibit, exhaust: silenced(exhibit.exhaust, off) }] : []
  })
  const slow = heardAt(store.pace.value)
  const own = engines.some(({ exhibit }) => exhibit.speed_rpm)
  const rpmOf = (place: number): number =>
    (speed === 'engine' && shown.value[place]?.speed_rpm) || slow
  const playing = player.playing.value
  const play = (place: number, exhaust: Exhaust): void => {
    player.play(place, exhaust, rpmOf(place)).catch((error: unknown) => {
      player.stop()
      trouble.value = reasonOf(error)
    })
  }
  const rpm = playing === null ? 0 : rpmOf(playing)
  useEffect(() => {
    if (rpm) player.tune(rpm)
  }, [rpm])
  useEffect(() => {
    // another engine has come on the stage
    player.stop()
  }, [...engines.map(({ exhaust }) => JSON.stringify(exhaust))])
  useEffect(() => () => player.dispose(), [])
  return (
    <>
      <p>
        {t(
          'Each cylinder sends one pulse a working cycle into its exhaust pipe, all of them alike. What is heard is the rhythm of the firings: an even one hums, an uneven one burbles.',
        )}
      </p>
      <div class="controls sound-players">
        {engines.map(({ place, exhibit, exhaust }) => {
          const on = playing === place
          return (
            <button
              key={place}
              type="button"
              class={on ? 'primary' : ''}
              onClick={() => (on ? player.stop() : play(place, exhaust))}
            >
              <Icon name={on ? 'stop' : 'play'} />
              <span>
                {on
                  ? t('Stop the sound of {engine}', { engine: exhibit.name })
                  : t('Hear {engine}', { engine: exhibit.name })}
              </span>
            </button>
          )
        })}
      </div>
      <div class="controls">
        <Choice
          label={t('Speed that is heard')}
          value={own ? speed : 'page'}
          choices={[
            {
              value: 'page',
              label: t('{factor} times that on the page: {rpm} rpm', { factor: FASTER, rpm: slow }),
            },
            ...(own
              ? [
                  {
                    value: 'engine' as const,
                    label: t('of the engine file: {rpm} rpm', {
                      rpm: [
                        ...new Set(
                          engines.map(({ place }) => ownOf(shown.value[place]?.speed_rpm)),
                        ),
                      ]
                        .filter(Boolean)
                        .join(', '),
                    }),
                  },
                ]
              : []),
          ]}
          chosen={choose}
        />
      </div>
      {off.length > 0 && (
        <p>
          {t('Without combustion, and silent here: cylinders {numbers}.', {
            numbers: off.join(', '),
          })}
        </p>
      )}
      <Each Part={ExhaustOrders} />
      <p class="soft small">
        {t(
          'Left out: muffler, intake and mechanical noise, the strength of a pulse, and what one cylinder or pipe does to another. The pipes are plain and 1 m long. This is no recording.',
        )}
      </p>
    </>
  )
}

const ownOf = (rpm: number | null | undefined): string =>
  rpm ? String(Number(rpm.toPrecision(6))) : ''

/** The sums of equal pulses by order, of each exhaust pipe of an engine. */
function ExhaustOrders() {
  const exhibit = useExhibit()
  const { exhaust } = exhibit
  const [off] = useOff()
  const key = off.join()
  const shown = useMemo(() => exhaust && ordersOf(silenced(exhaust, off)), [exhaust, key])
  if (!shown) return <p>{t('This engine has no firing order: give firing_order in its file.')}</p>
  return (
    <>
      <p class="soft small">
        <Term word="exhaust pulse, blow-down">{t('Exhaust pulses')}</Term>:{' '}
        {t('orders of each pipe, in pulses')}
      </p>
      <Bars
        label={t('Orders of the exhaust')}
        unit={t('pulses')}
        orders={shown.orders}
        series={shown.series}
      />
    </>
  )
}

function ordersOf(exhaust: Exhaust) {
  const { cycle, pipes } = exhaust
  const step = (2 * Math.PI) / cycle
  const most = Math.max(HIGHEST, Math.max(...pipes.map(({ fires }) => fires.length)) * step)
  const harmonics = Array.from({ length: Math.round(most / step) }, (_, index) => index + 1)
  return {
    orders: harmonics.map((each) => each * step),
    series: pipes.map((pipe, index) => ({
      key: `pipe-${index}`,
      like: `pipe-${index % 4}`,
      label: pipe.name,
      sizes: harmonics.map((each) => Math.hypot(...pulses(pipe, cycle, each))),
    })),
  }
}
