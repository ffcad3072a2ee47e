import { useMemo } from 'preact/hooks'
import { Coded } from '../../coded'
import type { Exhibit, Table, Torsion, TorsionNumbers, Vibration } from '../../exhibit'
import { message, t } from '../../language/messages'
import { modeOf, orderOf, ordersOfMode, type Show, twistOf, vibrationOf } from '../../torsion'
import { sizeText } from '../Bars'
import { Choice } from '../Choice'
import { useApp, useExhibit, useExhibits } from '../context'
import { DataTable } from '../DataTable'
import { Each } from '../Each'
import { Figure } from '../Figure'
import { Magnification } from '../Magnification'
import type { Panel } from '../panel'
import { HeatLegend, useTwist } from '../twists'

export const twist: Panel = {
  key: 'twist',
  label: message('Twist'),
  Content: TwistPanel,
}

const SHOW = {
  still: message('as it is'),
  mode: message('twisting in a mode'),
  forced: message('twisting as it is driven'),
} as const satisfies Record<Show, string>

/** Torsional vibration: what twists the crank on the stage, its modes, critical speeds, stresses. */
function TwistPanel() {
  const known = useExhibits().filter(({ torsion }) => torsion)
  return (
    <>
      {known[0]?.torsion && <Choices exhibit={known[0]} torsion={known[0].torsion} />}
      <Each Part={OfEngine} />
    </>
  )
}

/** What is shown, by the first engine whose torsion is known. */
function Choices({ exhibit, torsion }: { exhibit: Exhibit; torsion: Torsion }) {
  const { twist: chosen } = useApp()
  const choose = useTwist()
  const { show, ...choice } = chosen.value
  const mode = modeOf(torsion, choice.mode)
  if (!mode) return null
  const orders = ordersOfMode(torsion, mode.number)
  const isDriven = torsion.vibrations.length > 0
  const isSeen = torsion.throws.length > 0
  const shows: Show[] = ['still', 'mode', ...(isDriven ? (['forced'] as const) : [])]
  const seen = twistOf(exhibit, chosen.value)
  return (
    <>
      <div class="controls">
        {isSeen && (
          <Choice
            label={t('The crank on the stage')}
            value={show}
            choices={shows.map((value) => ({ value, label: t(SHOW[value]) }))}
            chosen={(value) => choose({ show: value })}
          />
        )}
        <label class="slider">
          <span>{t('Mode')}</span>
          <select
            value={mode.number}
            onChange={(event) => choose({ mode: event.currentTarget.value, order: '' })}
          >
            {torsion.modes.map((each) => (
              <option key={each.number} value={each.number}>
                {t('{number}: {frequency} Hz', {
                  number: each.number,
                  frequency: sizeText(each.frequency_hz),
                })}
              </option>
            ))}
          </select>
        </label>
        {orders.length > 0 && (
          <label class="slider">
            <span>{t('Order')}</span>
            <select
              value={orderOf(torsion, mode.number, choice.order)}
              onChange={(event) => choose({ order: event.currentTarget.value })}
            >
              {orders.map((order) => (
                <option key={order} value={order}>
                  {order}
                </option>
              ))}
            </select>
          </label>
        )}
        {isDriven && (
          <label class="slider at-speed">
            <span>{t('Driven at')}</span>
            <select
              value={choice.vibration < torsion.vibrations.length ? choice.vibration : 0}
              onChange={(event) => choose({ at: event.currentTarget.value })}
            >
              {torsion.vibrations.map((each, place) => (
                <option key={place} value={place}>
                  {speedText(each)}
                </option>
              ))}
            </select>
          </label>
        )}
      </div>
      {seen && (
        <>
          <Magnification times={seen.times} decades={4} chosen={(times) => choose({ times })} />
          <p class="soft small">{meaning(torsion, show, choice)}</p>
        </>
      )}
    </>
  )
}

/** A vibration by its speed, and what is special about it. */
function speedText({ point, speed_rpm, critical }: Vibration): string {
  const rpm = String(Math.round(speed_rpm))
  if (critical) {
    const [mode, order] = critical
    return t('{rpm} rpm: order {order} meets mode {mode}', { rpm, order, mode })
  }
  return point ? t('{rpm} rpm: {point}', { rpm, point }) : t('{rpm} rpm', { rpm })
}

/** What the stage shows, and how large that is. */
function meaning(
  torsion: Torsion,
  show: Show,
  { mode, order, vibration }: { mode: number; order: number | null; vibration: number },
): string {
  const own = modeOf(torsion, mode)
  if (show === 'mode' && own) {
    const swings = orderOf(torsion, own.number, order)
    const met = torsion.criticals.find((each) => each.mode === own.number && each.order === swings)
    const size = t(
      'A mode has no size of its own: the mass that turns most turns by 1° to either side, times the magnification.',
    )
    const often = met
      ? t('It swings {order} times a turn, as at {rpm} rpm.', {
          order: swings,
          rpm: Math.round(met.speed_rpm),
        })
      : t('It swings once a turn: no critical speed of it is known.')
    return `${size} ${often}`
  }
  const all = t(
    'Pistons and rods follow their pins; gears and balance shafts turn evenly. Uneven running of the whole is in it.',
  )
  const alone = t('Without gas: this is what the moving parts do alone.')
  return vibrationOf(torsion, vibration)?.gas ? all : `${alone} ${all}`
}

/** The torsion of one engine, or what it needs. */
function OfEngine() {
  const exhibit = useExhibit()
  const { torsion, torsion_numbers: numbers } = exhibit
  if (!torsion || !numbers)
    return (
      <p class="needs">
        {exhibit.torsion_needs}{' '}
        {t(
          'Inertias and stiffnesses, or the sizes of journals, pins and webs, from which stiffness is estimated.',
        )}
      </p>
    )
  return <Known exhibit={exhibit} torsion={torsion} numbers={numbers} />
}

interface Parts {
  readonly exhibit: Exhibit
  readonly torsion: Torsion
  readonly numbers: TorsionNumbers
}

function Known({ exhibit, torsion, numbers }: Parts) {
  const { twist: chosen } = useApp()
  const { mode, order, vibration } = chosen.value
  const own = modeOf(torsion, mode)
  const seen = useMemo(() => twistOf(exhibit, chosen.value), [exhibit, chosen.value])
  const shown = own ? orderOf(torsion, own.number, order) : 0
  const place = torsion.vibrations[vibration] ? vibration : 0
  const [sections, orders] = numbers.vibrations[place] ?? []
  return (
    <div class="torsion-of">
      {seen && <HeatLegend exhibit={exhibit} twist={seen} />}
      {numbers.doubts.length > 0 && (
        <p class="doubt">
          {torsion.estimated && <span class="badge">{t('stiffness estimated')}</span>}{' '}
          <Coded text={numbers.doubts.join(' ')} />
        </p>
      )}
      {torsion.modes.length === 0 && <p>{numbers.notes[0]}</p>}
      <DataTable table={numbers.frequencies} />
      <Drawn exhibit={exhibit} figures={['torsion-modes']} />
      <DataTable table={numbers.criticals} />
      <Folded
        title={t('Every critical speed')}
        tables={[{ ...numbers.every_critical, title: '' }]}
      />
      <Drawn exhibit={exhibit} figures={['campbell']} />
      <Star exhibit={exhibit} mode={own?.number ?? 0} order={shown} />
      <Drawn exhibit={exhibit} figures={['torsion-response']} />
      {sections && <DataTable table={sections} />}
      {orders && <Folded title={orders.title} tables={[{ ...orders, title: '' }]} />}
      {numbers.over_speeds.map((table) => (
        <DataTable key={table.title} table={table} />
      ))}
      <Folded title={t('Masses, shafts and shapes')} tables={numbers.chain} />
      <details class="torque-basis">
        <summary>{t('What the torsion rests on')}</summary>
        <ul>
          {numbers.notes.map((note) => (
            <li key={note}>
              <Coded text={note} />
            </li>
          ))}
        </ul>
      </details>
    </div>
  )
}

/** The figures of these names. */
function Drawn({ exhibit, figures }: { exhibit: Exhibit; figures: readonly string[] }) {
  const charts = exhibit.charts.filter(({ figure }) => figures.includes(figure))
  return (
    <div class="figures">
      {charts.map(({ key, label }) => (
        <Figure key={key} exhibit={exhibit} chart={key} label={label} />
      ))}
    </div>
  )
}

/** The vectors of the cylinders in a mode, of an order or, where none meets it, of several. */
function Star({ exhibit, mode, order }: { exhibit: Exhibit; mode: number; order: number }) {
  const stars = exhibit.charts.filter(
    ({ figure, quantity }) => figure === 'torsion-star' && quantity === `mode-${mode}`,
  )
  const chart = stars.find((star) => star.order == null || star.order === order)
  if (!chart) return null
  return (
    <div class="figures">
      <Figure key={chart.key} exhibit={exhibit} chart={chart.key} label={chart.label} />
    </div>
  )
}

function Folded({ title, tables }: { title: string; tables: readonly Table[] }) {
  const filled = tables.filter(({ rows }) => rows.length > 0)
  if (!filled.length) return null
  return (
    <details class="amplitudes">
      <summary>{title}</summary>
      {filled.map((table) => (
        <DataTable key={table.title} table={table} />
      ))}
    </details>
  )
}
