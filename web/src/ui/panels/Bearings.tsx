import { useMemo, useRef, useState } from 'preact/hooks'
import type { LoadShown, Bearings as Loads } from '../../exhibit'
import { t } from '../../language/messages'
import { Choice } from '../Choice'
import { useExhibit, useFollower } from '../context'
import { DataTable } from '../DataTable'
import { type Frame, loadVector, pathOf, pointText, STEPS } from '../loads'

type On = LoadShown['on']

/** Loads on main bearings and crank pins: polar diagrams that follow the angle, and their tables. */
export function Bearings() {
  const exhibit = useExhibit()
  const [on, setOn] = useState<On>('bearing')
  const [frame, setFrame] = useState<Frame>('block')
  const { bearings, sense, turns } = exhibit
  const shown = bearings.loads.filter((load) => load.on === on)
  const largest = Math.max(...shown.map((load) => load.peak), 0)
  return (
    <>
      <div class="controls">
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
      <p>
        {t('From inertia and weights, in {unit}; greatest load and its crank angle above each.', {
          unit: bearings.unit,
        })}{' '}
        {on === 'bearing' && bearings.model}
      </p>
      <div class="polar-loads" data-on={on} data-frame={frame}>
        {shown.map((load) => (
          <Polar
            key={`${load.name} ${frame}`}
            {...{ load, bearings, sense, turns, frame, largest }}
          />
        ))}
      </div>
      {bearings.tables.map((table) => (
        <DataTable key={table.title} table={table} />
      ))}
    </>
  )
}

interface Props {
  readonly load: LoadShown
  readonly bearings: Loads
  readonly sense: number
  readonly turns: number
  readonly frame: Frame
  readonly largest: number
}

/** One load over the turn, up upward, with a dot every 90 degrees and the load at the angle. */
function Polar({ load, bearings, sense, turns, frame, largest }: Props) {
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
  const [peakX, peakY] = pointText(at(load.peak_theta), scale)
  return (
    <figure>
      <figcaption>
        {load.name}
        <br />
        {load.peak > 0 ? load.greatest : t('no load')}
      </figcaption>
      <svg viewBox="-1.3 -1.3 2.6 2.6" role="img" aria-label={`${load.name}: ${load.greatest}`}>
        <path class="cross" d="M-1.1 0H1.1M0 -1.1V1.1" />
        <circle class="ring" r="0.5" />
        <circle class="ring" r="1" />
        <path class="line" d={drawn.path} />
        {load.peak > 0 &&
          drawn.dots.map(([x, y], index) => (
            <g key={index}>
              <circle class="dot" cx={x} cy={y} r="0.045" />
              <text x={labelAt(x)} y={labelAt(y)}>
                {`${(360 / STEPS) * index}°`}
              </text>
            </g>
          ))}
        {load.peak > 0 && <circle class="peak" cx={peakX} cy={peakY} r="0.075" />}
        <g ref={now} class="now">
          <line x1="0" y1="0" />
          <circle r="0.06" />
        </g>
      </svg>
    </figure>
  )
}

/** A little farther out than a dot. */
function labelAt(place: string): string {
  const value = Number(place)
  return (value + 0.17 * Math.sign(value || 1)).toFixed(3)
}
