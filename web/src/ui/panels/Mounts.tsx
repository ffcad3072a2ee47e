import { useMemo } from 'preact/hooks'
import { Coded } from '../../coded'
import type { Exhibit, MountNumbers, Mounts, MountVibration, Table } from '../../exhibit'
import { message, t } from '../../language/messages'
import { groundWaves, modeOf, pointWaves, type Show, shakeOf, vibrationOf } from '../../mounts'
import { signalOf } from '../../phasor'
import { sizeText } from '../Bars'
import { Choice } from '../Choice'
import { Curves } from '../Curves'
import { useApp, useExhibit, useExhibits } from '../context'
import { DataTable } from '../DataTable'
import { Each } from '../Each'
import { Magnification } from '../Magnification'
import { MountViews } from '../MountViews'
import { EnergyBars, LoadBars, OverSpeed, useMounts } from '../mounts'
import type { Panel } from '../panel'

export const mounts: Panel = {
  key: 'mounts',
  label: message('Mounts'),
  Content: MountsPanel,
  when: ({ shown }) => shown.value.some((exhibit) => exhibit.mounts),
}

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
  const isDriven = own.vibrations.length > 0
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
              value={own.vibrations[chosen.vibration] ? chosen.vibration : 0}
              onChange={(event) => choose({ at: event.currentTarget.value })}
            >
              {own.vibrations.map((each, place) => (
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
          <Magnification times={seen.times} decades={6} chosen={(times) => choose({ times })} />
          <p class="soft small">{meaning(own, chosen.show, chosen.vibration)}</p>
        </>
      )}
    </>
  )
}

/** A vibration by its speed, and what is special about it. */
function speedText({ point, speed_rpm, peak }: MountVibration): string {
  const rpm = String(Math.round(speed_rpm))
  if (peak) return t('{rpm} rpm: shakes most', { rpm })
  return point ? t('{rpm} rpm: {point}', { rpm, point }) : t('{rpm} rpm', { rpm })
}

/** What the stage shows, and how large that is. */
function meaning(own: Mounts, show: Show, vibration: number): string {
  if (show === 'mode')
    return t(
      'A mode has no size of its own: the corner of the engine that goes farthest goes 1 mm to either side, times the magnification. It swings once a turn; arrows are the forces of the mounts at 1 mm.',
    )
  const all = t(
    'All orders that are chosen move it, magnified; arrows are the force of each mount on what is below it.',
  )
  const alone = t('Without gas: this is what the moving parts do alone.')
  return vibrationOf(own, vibration)?.gas ? all : `${alone} ${all}`
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
  const { vibration } = useApp().mounts.value
  const place = own.vibrations[vibration] ? vibration : 0
  const shown = own.vibrations[place]
  const [orders, forces] = numbers.vibrations[place] ?? []
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
      {own.over && <Over own={own} numbers={numbers} at={shown?.speed_rpm ?? null} />}
      {shown && <Course exhibit={exhibit} own={own} numbers={numbers} shown={shown} />}
      {forces && <DataTable table={forces} />}
      {orders && <Folded table={orders} />}
      {numbers.speeds.rows.length > 0 && <Folded table={numbers.speeds} />}
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

/** Motion, force and transmissibility over the speed. */
function Over({ own, numbers, at }: Omit<Parts, 'exhibit'> & { at: number | null }) {
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
        label={t('Vibration of the point, rms')}
        unit={numbers.velocity_unit}
        speeds={speeds}
        lines={[{ key: 'velocity', label: t('velocity'), values: over.velocity }]}
        at={at}
      />
      <OverSpeed
        label={t('Displacement of the point, rms')}
        unit={numbers.displacement_unit}
        speeds={speeds}
        lines={[{ key: 'displacement', label: t('displacement'), values: over.displacement }]}
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

/** Motion of the point and force on the ground over a cycle, at the speed that is shown. */
function Course({ exhibit, own, numbers, shown }: Parts & { shown: MountVibration }) {
  const courses = useMemo(() => {
    const motion = shown.motion.map(signalOf)
    const forces = shown.forces.map((force) => force.map(signalOf))
    return [pointWaves(own, motion, own.point), groundWaves(own, forces)] as const
  }, [own, shown])
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
        label={t('Displacement of the point at {rpm} rpm', { rpm })}
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

function Folded({ table }: { table: Table }) {
  return (
    <details class="amplitudes">
      <summary>{table.title}</summary>
      <DataTable table={{ ...table, title: '' }} />
    </details>
  )
}
