import { batch } from '@preact/signals'
import type { MountNumbers, Mounts, Unit } from '../exhibit'
import { message, t } from '../language/messages'
import { set } from '../state'
import { sizeText } from './Bars'
import { pathOf, ticksOf, tickText } from './Curves'
import { useApp } from './context'

/** What is chosen of the mounts, as links have it; an empty text for how it opens. */
interface Chosen {
  readonly show?: string
  readonly mode?: string
  readonly at?: string
  readonly rpm?: string
  readonly point?: string
  readonly times?: string
}

const OPENING: Readonly<Record<string, string>> = { show: 'still', mode: '1', at: '0', point: '0' }

/** What changes the choice. */
export function useMounts(): (change: Chosen) => void {
  const { store } = useApp()
  return (change) => {
    const next = { ...store.choices.value }
    for (const [name, value] of Object.entries(change)) {
      if (value === '' || value === OPENING[name]) delete next[`mounts.${name}`]
      else next[`mounts.${name}`] = value
    }
    batch(() => {
      // what moves on its mounts does not whirl freely
      if (change.show && change.show !== OPENING.show) set(store.whirl, 0)
      set(store.choices, next)
    })
  }
}

/** The freedoms in the order in which they are sent. */
export const FREEDOMS = [
  ['up', message('up')],
  ['right', message('right')],
  ['along', message('along')],
  ['yaw', message('yawing')],
  ['pitch', message('pitching')],
  ['roll', message('rolling')],
] as const

/** Energy below this share has no bar. */
const LEAST = 0.001

/** The share of each freedom in the energy of each mode, as bars of one length. */
export function EnergyBars({ mounts }: { mounts: Mounts }) {
  const { mode: number } = useApp().mounts.value
  const choose = useMounts()
  const based = mounts.centres.length > 1
  return (
    <figure class="energy-bars">
      <figcaption>{t('Energy of the modes by freedom')}</figcaption>
      <ol>
        {mounts.modes.map((mode) => {
          const label = t('Mode {number}, {frequency} Hz: {shares}', {
            number: mode.number,
            frequency: sizeText(mode.frequency_hz),
            shares: sharesText(mode.energy),
          })
          return (
            <li key={mode.number}>
              <button
                type="button"
                aria-pressed={mode.number === number}
                aria-label={label}
                title={label}
                onClick={() => choose({ show: 'mode', mode: String(mode.number) })}
              >
                <span class="mode-name" aria-hidden="true">
                  {t('{number}: {frequency} Hz', {
                    number: mode.number,
                    frequency: sizeText(mode.frequency_hz),
                  })}
                </span>
                <span class="energy-bar" aria-hidden="true">
                  {mode.energy.map((share, place) =>
                    share > LEAST ? (
                      <i
                        key={place}
                        class={`free-${FREEDOMS[place % FREEDOMS.length]?.[0]} ${place < FREEDOMS.length ? '' : 'of-base'}`}
                        style={{ width: `${100 * share}%` }}
                      />
                    ) : null,
                  )}
                </span>
              </button>
            </li>
          )
        })}
      </ol>
      <ul class="legend">
        {FREEDOMS.map(([key, name]) => (
          <li key={key}>
            <i class={`swatch free-${key}`} aria-hidden="true" /> {t(name)}
          </li>
        ))}
        {based && (
          <li>
            <i class="swatch of-base" aria-hidden="true" /> {t('hatched: the foundation')}
          </li>
        )}
      </ul>
    </figure>
  )
}

/** The shares that count, the greatest first. */
function sharesText(energy: readonly number[]): string {
  return energy
    .map((share, place) => ({ share, place }))
    .filter(({ share }) => share >= 0.01)
    .sort((one, other) => other.share - one.share)
    .map(({ share, place }) => {
      const [, word] = FREEDOMS[place % FREEDOMS.length] ?? FREEDOMS[0]
      const name = t(word)
      const of =
        place < FREEDOMS.length ? name : t('{freedom} of the foundation', { freedom: name })
      return `${of} ${(100 * share).toFixed(0)} %`
    })
    .join(', ')
}

/** What each mount bears at rest, as bars. */
export function LoadBars({ mounts, numbers }: { mounts: Mounts; numbers: MountNumbers }) {
  const loads = mounts.mounts.map(({ load }) => Math.hypot(...load))
  const most = Math.max(...loads, 0)
  const { label, factor } = numbers.load_unit
  return (
    <figure class="load-bars">
      <figcaption>
        {t('Load of each mount at rest')} <span class="soft">{label}</span>
      </figcaption>
      <ol>
        {mounts.mounts.map(({ name, load }, place) => (
          <li key={name + place}>
            <span class="load-name">{name}</span>
            <span class="load-bar" aria-hidden="true">
              <i
                class={load[0] > 0 ? 'lifting' : ''}
                style={{ width: `${most > 0 ? (100 * (loads[place] ?? 0)) / most : 0}%` }}
              />
            </span>
            <span class="number">
              {sizeText(factor * (loads[place] ?? 0))}
              {load[0] > 1e-9 * most && <span class="soft"> {t('pulled up')}</span>}
            </span>
          </li>
        ))}
      </ol>
    </figure>
  )
}

interface Line {
  readonly key: string
  readonly label: string
  readonly values: readonly (number | null)[]
}

interface OverProps {
  readonly label: string
  readonly unit: Unit
  readonly speeds: readonly number[]
  readonly lines: readonly Line[]
  /** The speed at which the block is shown, rpm, and its values there if it is between others. */
  readonly at: number | null
}

/** Curves over the speed, with a dot on each at the speed that is shown. */
export function OverSpeed({ label, unit, speeds, lines, at }: OverProps) {
  const [from = 0, to = 1] = [speeds[0], speeds.at(-1)]
  const known = lines.map((line) => ({ ...line, curve: curveOf(line.values) }))
  const top = 1.06 * Math.max(...known.flatMap(({ curve }) => Array.from(curve)), 1e-300)
  const up = ticksOf(0, top * unit.factor, 4)
  const along = ticksOf(from, to, 5)
  const share = (speed: number) => (100 * (speed - from)) / (to - from || 1)
  const height = (value: number) => 100 * (1 - value / top)
  const within = at !== null && at >= from - 1e-6 && at <= to + 1e-6
  return (
    <figure class="cycle-curves over-speed">
      <figcaption>
        {label} <span class="soft">{unit.label}</span>
      </figcaption>
      <div class="cycle-plot">
        <div class="plot-up" aria-hidden="true">
          {up.map((value) => (
            <span key={value} style={{ top: `${height(value / unit.factor)}%` }}>
              {tickText(value)}
            </span>
          ))}
        </div>
        <svg
          viewBox="0 0 1000 1000"
          preserveAspectRatio="none"
          role="img"
          aria-label={t('{label} over the speed, {from} to {to} rpm', {
            label,
            from: Math.round(from),
            to: Math.round(to),
          })}
        >
          {up.map((value) => (
            <path
              key={value}
              class={value === 0 ? 'plot-axis' : 'plot-grid'}
              d={`M0 ${10 * height(value / unit.factor)}H1000`}
            />
          ))}
          {along.map((speed) => (
            <path key={speed} class="plot-grid" d={`M${10 * share(speed)} 0V1000`} />
          ))}
          {known.map(({ key, curve }, place) => (
            <path
              key={key}
              class={`plot-curve line-${place % 6}`}
              data-series={key}
              d={pathOf(curve, 0, top)}
            />
          ))}
        </svg>
        <div class="plot-dots" aria-hidden="true">
          {within &&
            known.map(({ key, curve }, place) => (
              <i
                key={key}
                class={`plot-dot line-${place % 6}`}
                data-series={key}
                style={{ left: `${share(at)}%`, top: `${height(valueAt(speeds, curve, at))}%` }}
              />
            ))}
        </div>
        <div class="plot-along" aria-hidden="true">
          {along.map((speed) => (
            <span key={speed} style={{ left: `${share(speed)}%` }}>
              {tickText(speed)}
            </span>
          ))}
        </div>
      </div>
      <ul class="legend">
        {known.map(({ key, label: name, curve }, place) => (
          <li key={key}>
            <i class={`swatch line-${place % 6}`} aria-hidden="true" /> {name}{' '}
            {within && (
              <output aria-label={name}>
                {sizeText(unit.factor * valueAt(speeds, curve, at))}
              </output>
            )}
          </li>
        ))}
      </ul>
    </figure>
  )
}

const curveOf = (values: readonly (number | null)[]): Float64Array =>
  Float64Array.from(values, (value) => value ?? 0)

/** The value at a speed, straight between those that are known. */
export function valueAt(speeds: readonly number[], values: ArrayLike<number>, at: number): number {
  const after = speeds.findIndex((speed) => speed >= at - 1e-9)
  const last = speeds.length - 1
  if (after <= 0) return values[after < 0 ? last : 0] ?? 0
  const [low, high] = [speeds[after - 1] as number, speeds[after] as number]
  const share = Math.min(1, (at - low) / (high - low || 1))
  return (1 - share) * (values[after - 1] as number) + share * (values[after] as number)
}
