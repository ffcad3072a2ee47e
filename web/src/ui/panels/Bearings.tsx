import { useMemo, useRef } from 'preact/hooks'
import { Coded } from '../../coded'
import type { BearingNumbers, Exhibit, LoadShown, Bearings as Loads } from '../../exhibit'
import { message, t } from '../../language/messages'
import { Choice } from '../Choice'
import { useChoice, useExhibit, useExhibits, useFollower } from '../context'
import { DataTable } from '../DataTable'
import { Each } from '../Each'
import { type Frame, labelsOf, loadVector, pathOf, pointText, STEPS } from '../loads'
import type { Panel } from '../panel'

type On = LoadShown['on']

export const bearings: Panel = {
  key: 'bearings',
  label: message('Bearings'),
  Content: Bearings,
}

const useOn = () => useChoice<On>('bearings.on', ['bearing', 'pin'])
const useGas = () => useChoice<'without' | 'with'>('bearings.gas', ['without', 'with'])
const useFrame = () => useChoice<Frame>('bearings.frame', ['block', 'shaft'])

/** Loads on main bearings and crank pins: polar diagrams that follow the angle, and their tables. */
function Bearings() {
  const [on, setOn] = useOn()
  const [frame, setFrame] = useFrame()
  const [gas, setGas] = useGas()
  const isGas = useExhibits().some((exhibit) => exhibit.gas_bearings)
  return (
    <>
      <div class="controls">
        {isGas && (
          <Choice
            label={t('Gas')}
            value={gas}
            choices={[
              { value: 'without', label: t('without gas') },
              { value: 'with', label: t('with gas') },
            ]}
            chosen={setGas}
          />
        )}
        <Choice
          label={t('Load on')}
          value={on}
          choices={[
            { value: 'bearing', label: t('main bearings') },
            { value: 'pin', label: t('crank pins, from the rods') },
          ]}
          chosen={setOn}
        />
        <Choice
          label={t('Frame')}
          value={frame}
          choices={[
            { value: 'block', label: t('block') },
            { value: 'shaft', label: t('turning with the shaft') },
          ]}
          chosen={setFrame}
        />
      </div>
      <Each Part={Diagrams} />
    </>
  )
}

/** The loads of an engine and their numbers: with gas where it is chosen and there is some. */
function loadsOf(exhibit: Exhibit, gas: 'without' | 'with') {
  const { gas_bearings, gas_bearing_numbers } = exhibit
  return gas === 'with' && gas_bearings && gas_bearing_numbers
    ? { bearings: gas_bearings, numbers: gas_bearing_numbers }
    : { bearings: exhibit.bearings, numbers: exhibit.bearing_numbers }
}

/** The greatest load of that kind on any of the engines that are counted in this unit. */
function largestOf(all: readonly ReturnType<typeof loadsOf>[], on: On, unit: string): number {
  const peaks = all.flatMap(({ bearings, numbers }) =>
    unitOf(numbers, on) === unit
      ? bearings.loads.flatMap((load) => (load.on === on ? [load.peak] : []))
      : [],
  )
  return Math.max(...peaks, 0)
}

const unitOf = (numbers: BearingNumbers, on: On): string =>
  on === 'bearing' ? numbers.bearing_unit : numbers.pin_unit

/** Those of one engine, to one scale with those of the other. */
function Diagrams() {
  const exhibit = useExhibit()
  const exhibits = useExhibits()
  const [on] = useOn()
  const [frame] = useFrame()
  const [gas] = useGas()
  const { sense, turns } = exhibit
  const { bearings, numbers } = loadsOf(exhibit, gas)
  const isGas = numbers.about.length > 0
  const shown = bearings.loads.flatMap((load, index) =>
    load.on === on ? [{ load, greatest: numbers.greatest[index] ?? '' }] : [],
  )
  const all = exhibits.map((each) => loadsOf(each, gas))
  const largest = largestOf(all, on, unitOf(numbers, on))
  return (
    <>
      <p>
        {isGas
          ? t('In {unit}; greatest load and its crank angle above each.', {
              unit: unitOf(numbers, on),
            })
          : t(
              'From inertia and weights, in {unit}; greatest load and its crank angle above each.',
              {
                unit: unitOf(numbers, on),
              },
            )}{' '}
        <Coded text={numbers.about.join(' ')} /> {on === 'bearing' && bearings.model}{' '}
        {numbers.estimated && <span class="badge">{t('estimated, with ranges')}</span>}
      </p>
      <div class="polar-loads" data-on={on} data-frame={frame}>
        {shown.map(({ load, greatest }) => (
          <Polar
            key={`${load.name} ${frame}`}
            {...{ load, greatest, bearings, sense, turns, frame, largest }}
          />
        ))}
      </div>
      {largest > 0 && (
        <p class="soft small">
          {t(
            'The outer circle is the greatest of these loads, the inner one half of it. Dots stand every 90° of the crank angle, a ring round the greatest load; the red arm is the load at the present crank angle.',
          )}
        </p>
      )}
      {numbers.tables.map((table) => (
        <DataTable key={table.title} table={table} />
      ))}
    </>
  )
}

interface Props {
  readonly load: LoadShown
  readonly greatest: string
  readonly bearings: Loads
  readonly sense: number
  readonly turns: number
  readonly frame: Frame
  readonly largest: number
}

/** One load over the turn, up upward, with a dot every 90 degrees and the load at the angle. */
function Polar({ load, greatest, bearings, sense, turns, frame, largest }: Props) {
  const now = useRef<SVGGElement>(null)
  const at = useMemo(
    () => loadVector(load, bearings.orders, sense, frame),
    [load, bearings, sense, frame],
  )
  const scale = largest > 0 ? 1 / largest : 0
  const drawn = useMemo(() => pathOf(at, turns, scale), [at, turns, scale])
  useFollower(
    (theta) => {
      const line = now.current?.firstElementChild
      const head = now.current?.lastElementChild
      const place = at(theta)
      const [x, y] = pointText(place, scale)
      line?.setAttribute('x2', x)
      line?.setAttribute('y2', y)
      head?.setAttribute('cx', x)
      head?.setAttribute('cy', y)
    },
    [at, scale],
  )
  const labels = useMemo(() => labelsOf(drawn.dots), [drawn])
  const [peakX, peakY] = pointText(at(load.peak_theta), scale)
  return (
    <figure>
      <figcaption>
        {load.name}
        <br />
        {greatest}
      </figcaption>
      <svg viewBox="-1.45 -1.3 2.9 2.6" role="img" aria-label={`${load.name}: ${greatest}`}>
        <path class="cross" d="M-1.1 0H1.1M0 -1.1V1.1" />
        <circle class="ring" r="0.5" />
        <circle class="ring" r="1" />
        <path class="line" d={drawn.path} />
        {load.peak > 0 &&
          drawn.dots.map(([x, y], index) => (
            <circle key={index} class="dot" cx={x} cy={y} r="0.045" />
          ))}
        {load.peak > 0 && <circle class="peak" cx={peakX} cy={peakY} r="0.075" />}
        <g ref={now} class="now">
          <line x1="0" y1="0" />
          <circle r="0.06" />
        </g>
        {load.peak > 0 &&
          labels.map(
            (place, index) =>
              place && (
                <text key={index} x={place[0]} y={place[1]}>
                  {`${(360 / STEPS) * index}°`}
                </text>
              ),
          )}
      </svg>
    </figure>
  )
}
