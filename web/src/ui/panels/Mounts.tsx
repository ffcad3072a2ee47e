import { useMemo } from 'preact/hooks'
import { Coded } from '../../coded'
import type {
  Exhibit,
  MountedPoint,
  MountNumbers,
  Mounts,
  MountVibration,
  Table,
} from '../../exhibit'
import { message, t } from '../../language/messages'
import type { Answer } from '../../mountResponse'
import {
  answerOf,
  groundWaves,
  type MountChoice,
  modeOf,
  pointOf,
  pointWaves,
  type Show,
  shakeOf,
  vibrationOf,
} from '../../mounts'
import { sizeText } from '../Bars'
import { Choice } from '../Choice'
import { Curves } from '../Curves'
import { useApp, useExhibit, useExhibits } from '../context'
import { DataTable } from '../DataTable'
import { Each } from '../Each'
import { Magnification } from '../Magnification'
import { MountViews } from '../MountViews'
import { EnergyBars, LoadBars, OverSpeed, useMounts } from '../mounts'
import { ForceTable, orderTable, PointTable } from '../mountTables'
import type { Panel } from '../panel'

export const mounts: Panel = {
  key: 'mounts',
  label: message('Mounts'),
  Content: MountsPanel,
  when: ({ shown }) => shown.value.some((exhibit) => exhibit.mounts),
}

/** Ranges of fewer turns per minute are gone through in tenths. */
const FINE = 300

const SHOW = {
  still: message('as it stands'),
  mode: message('moving in a mode'),
  forced: message('moving as it is driven'),
} as const satisfies Record<Show, string>

/** The block on its mounts: what moves it on the stage, its modes, its motion, what goes below. */
function MountsPanel() {
  const known = useExhibits().find((exhibit) => exhibit.mounts)
  return (
    <>
      {known?.mounts && <Choices exhibit={known} mounts={known.mounts} />}
      <Each Part={OfEngine} />
    </>
  )
}

/** What is shown, by the first engine that stands on mounts. */
function Choices({ exhibit, mounts: own }: { exhibit: Exhibit; mounts: Mounts }) {
  const chosen = useApp().mounts.value
  const choose = useMounts()
  const mode = modeOf(own, chosen.mode)
  const driven = vibrationOf(own, chosen)
  const isDriven = driven !== undefined
  const shows: Show[] = ['still', 'mode', ...(isDriven ? (['forced'] as const) : [])]
  const seen = useMemo(() => shakeOf(exhibit, chosen), [exhibit, chosen])
  return (
    <>
      <div class="controls">
        <Choice
          label={t('The block on the stage')}
          value={chosen.show}
          choices={shows.map((value) => ({ value, label: t(SHOW[value]) }))}
          chosen={(value) => choose({ show: value })}
        />
        <label class="slider">
          <span>{t('Mode')}</span>
          <select
            value={mode?.number}
            onChange={(event) => choose({ mode: event.currentTarget.value })}
          >
            {own.modes.map((each) => (
              <option key={each.number} value={each.number}>
                {t('{number}: {frequency} Hz', {
                  number: each.number,
                  frequency: sizeText(each.frequency_hz),
                })}
              </option>
            ))}
          </select>
        </label>
        {isDriven && (
          <label class="slider at-speed">
            <span>{t('Driven at')}</span>
            <select
              value={
                chosen.rpm !== null ? '' : own.vibrations[chosen.vibration] ? chosen.vibration : 0
              }
              onChange={(event) => choose({ at: event.currentTarget.value, rpm: '' })}
            >
              {chosen.rpm !== null && driven && <option value="">{speedText(driven)}</option>}
              {own.vibrations.map((each, place) => (
                <option key={place} value={place}>
                  {speedText(each)}
                </option>
              ))}
            </select>
          </label>
        )}
        {isDriven && (
          <label class="slider at-speed">
            <span>{t('Point')}</span>
            <select
              value={own.points[chosen.point] ? chosen.point : 0}
              onChange={(event) => choose({ point: event.currentTarget.value })}
            >
              {own.points.map(({ name }, place) => (
                <option key={place} value={place}>
                  {name}
                </option>
              ))}
            </select>
          </label>
        )}
        {driven && <Speed own={own} at={driven.speed_rpm} />}
      </div>
      {seen && (
        <>
          <Magnification times={seen.times} decades={6} chosen={(times) => choose({ times })} />
          <p class="soft small">{meaning(own, chosen)}</p>
        </>
      )}
    </>
  )
}

/** Any speed of the range, by a slider or as a number. */
function Speed({ own, at }: { own: Mounts; at: number }) {
  const choose = useMounts()
  const [slowest = 0, fastest = 0] = [own.over?.speeds_rpm[0], own.over?.speeds_rpm.at(-1)]
  const step = fastest - slowest < FINE ? 0.1 : 1
  const [min, max] = [Math.ceil(slowest / step) * step, Math.floor(fastest / step) * step]
  if (!(max > min)) return null
  const text = (speed: number) => String(Number(speed.toFixed(1)))
  const range = {
    min: text(min),
    max: text(max),
    step,
    value: text(Math.min(max, Math.max(min, at))),
  }
  const chosen = (speed: number) => {
    if (Number.isFinite(speed)) choose({ rpm: text(Math.min(max, Math.max(min, speed))) })
  }
  return (
    <div class="wide any-speed">
      <span aria-hidden="true">{t('Speed')}</span>
      <input
        type="range"
        {...range}
        aria-label={t('Speed of the engine')}
        aria-valuetext={t('{rpm} rpm', { rpm: text(at) })}
        onInput={(event) => chosen(event.currentTarget.valueAsNumber)}
      />
      <input
        type="number"
        {...range}
        aria-label={t('Speed of the engine, rpm')}
        onChange={(event) => chosen(event.currentTarget.valueAsNumber)}
      />
      <span>{t('rpm')}</span>
    </div>
  )
}

/** A vibration by its speed, and what is special about it. */
function speedText({ point, speed_rpm, peak }: MountVibration): string {
  const rpm = String(Math.round(speed_rpm))
  if (peak) return t('{rpm} rpm: resonance', { rpm })
  return point ? t('{rpm} rpm: {point}', { rpm, point }) : t('{rpm} rpm', { rpm })
}

/** What the stage shows, and how large that is. */
function meaning(own: Mounts, { show, rpm }: MountChoice): string {
  if (show === 'mode')
    return t(
      'A mode has no size of its own: the corner of the engine that goes farthest goes 1 mm to either side, times the magnification. It swings once a turn; arrows are the forces of the mounts at 1 mm.',
    )
  const all = t(
    'All orders that are chosen move it, magnified; arrows are the force of each mount on what is below it.',
  )
  const alone = t('Without gas: this is what the moving parts do alone.')
  const mixed = t('Between the speeds at which it is known the gas is interpolated.')
  const known = own.driving?.gas_speeds.length ?? 0
  if (!known) return `${alone} ${all}`
  return rpm !== null && known > 1 ? `${all} ${mixed}` : all
}

/** One engine on its mounts, or what it needs. */
function OfEngine() {
  const exhibit = useExhibit()
  const { mounts: own, mount_numbers: numbers } = exhibit
  if (!own || !numbers)
    return (
      <p class="needs">
        {t(
          'This engine has no mounts. Place them in the tab Edit, under Block and mounts, or give [[mounts]] in the engine file.',
        )}
      </p>
    )
  return <Known exhibit={exhibit} own={own} numbers={numbers} />
}

interface Parts {
  readonly exhibit: Exhibit
  readonly own: Mounts
  readonly numbers: MountNumbers
}

function Known({ exhibit, own, numbers }: Parts) {
  const chosen = useApp().mounts.value
  const { vibration, rpm } = chosen
  const shown = useMemo(() => vibrationOf(own, { vibration, rpm }), [own, vibration, rpm])
  const answer = useMemo(() => (shown ? answerOf(own, shown) : null), [own, shown])
  const point = pointOf(own, chosen)
  const driven = shown && answer && { own, numbers, shown, answer }
  return (
    <div class="mounts-of">
      {numbers.doubts.length > 0 && (
        <p class="doubt">
          <Coded text={numbers.doubts.join(' ')} />
        </p>
      )}
      <EnergyBars mounts={own} />
      <DataTable table={numbers.modes} />
      <MountViews exhibit={exhibit} mounts={own} />
      <DataTable table={numbers.axes} />
      <LoadBars mounts={own} numbers={numbers} />
      <DataTable table={numbers.mounts} />
      {own.over && <Over own={own} numbers={numbers} point={point} at={shown?.speed_rpm ?? null} />}
      {driven && (
        <>
          <Course exhibit={exhibit} {...driven} point={point} />
          <PointTable exhibit={exhibit} {...driven} />
          <ForceTable exhibit={exhibit} {...driven} />
          <Folded table={orderTable(driven, point)} />
        </>
      )}
      {numbers.speeds.rows.length > 0 && <Folded table={numbers.speeds} of={own.points[0]?.name} />}
      <details class="torque-basis">
        <summary>{t('What this rests on')}</summary>
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

interface OverParts extends Omit<Parts, 'exhibit'> {
  readonly point: MountedPoint
  readonly at: number | null
}

/** Motion, force and transmissibility over the speed. */
function Over({ own, numbers, point, at }: OverParts) {
  const { over } = own
  if (!over) return null
  const speeds = over.speeds_rpm
  const through = own.mounts
    .filter(({ below }) => !below || own.centres.length === 1)
    .slice(0, over.transmissibility.length)
  return (
    <>
      <h3>{t('Over the speed, rpm')}</h3>
      <OverSpeed
        label={t('Vibration of the point {point}, rms', { point: point.name })}
        unit={numbers.velocity_unit}
        speeds={speeds}
        lines={[{ key: 'velocity', label: t('velocity'), values: point.velocity }]}
        at={at}
      />
      <OverSpeed
        label={t('Displacement of the point {point}, rms', { point: point.name })}
        unit={numbers.displacement_unit}
        speeds={speeds}
        lines={[{ key: 'displacement', label: t('displacement'), values: point.displacement }]}
        at={at}
      />
      <OverSpeed
        label={t('Force on the foundation, rms')}
        unit={numbers.force_unit}
        speeds={speeds}
        lines={[{ key: 'force', label: t('force'), values: over.force }]}
        at={at}
      />
      <OverSpeed
        label={t('Transmissibility')}
        unit={{ label: '', factor: 1 }}
        speeds={speeds}
        lines={through.map(({ name }, place) => ({
          key: `mount-${place}`,
          label: name,
          values: over.transmissibility[place] ?? [],
        }))}
        at={at}
      />
    </>
  )
}

interface CourseParts extends Parts {
  readonly shown: MountVibration
  readonly answer: Answer
  readonly point: MountedPoint
}

/** Motion of the point and force on the ground over a cycle, at the speed that is shown. */
function Course({ exhibit, own, numbers, shown, answer, point }: CourseParts) {
  const courses = useMemo(
    () => [pointWaves(own, answer.motion, point), groundWaves(own, answer.forces)] as const,
    [own, answer, point],
  )
  const names = [t('up'), t('right'), t('along')]
  const keys = ['axis-0', 'axis-1', 'axis-2']
  const series = courses.map((waves) =>
    waves.map((wave, axis) => ({
      key: keys[axis] ?? '',
      label: names[axis] ?? '',
      wave,
      mean: 0,
    })),
  )
  const at = { turns: exhibit.turns, orders: own.orders }
  const rpm = Math.round(shown.speed_rpm)
  return (
    <>
      <Curves
        label={t('Displacement of the point {point} at {rpm} rpm', { point: point.name, rpm })}
        unit={numbers.displacement_unit.label}
        factor={numbers.displacement_unit.factor}
        series={series[0] ?? []}
        {...at}
      />
      <Curves
        label={t('Force on the foundation at {rpm} rpm', { rpm })}
        unit={numbers.force_unit.label}
        factor={numbers.force_unit.factor}
        series={series[1] ?? []}
        {...at}
      />
    </>
  )
}

function Folded({ table, of }: { table: Table; of?: string | undefined }) {
  const notes = [...(of ? [t('Of the point {point}.', { point: of })] : []), ...(table.notes ?? [])]
  return (
    <details class="amplitudes">
      <summary>{table.title}</summary>
      <DataTable table={{ ...table, title: '', notes }} />
    </details>
  )
}
