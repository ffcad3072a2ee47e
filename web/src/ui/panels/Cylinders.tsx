import { useMemo, useRef } from 'preact/hooks'
import type { Exhibit } from '../../exhibit'
import { message, t } from '../../language/messages'
import {
  type Coefficients,
  coefficientsOf,
  greatest,
  type Plane,
  phaseOf,
  summed,
  turn,
  vectorAt,
} from '../../phasor'
import { banksOf } from '../../stage/banks'
import { alike } from '../BothOrders'
import { useApp, useExhibit, useExhibits, useFollower } from '../context'
import { Each } from '../Each'
import { decimalsOf, signedText } from '../figures'
import { OrderChoice } from '../OrderChoice'
import type { Panel } from '../panel'
import { Scroller } from '../Scroller'

export const cylinders: Panel = {
  key: 'cylinders',
  label: message('Cylinders'),
  Content: Cylinders,
}

/** The forces of each cylinder and bank at the present crank angle. */
function Cylinders() {
  return (
    <>
      <OrderChoice />
      <Each Part={Forces} />
      <p class="soft small">
        {t(
          'The force of a cylinder is that of its piston and rod on the block. The bar is its part along the cylinder axis, outward to the right.',
        )}
      </p>
    </>
  )
}

/** A row: what pulls, at which bearing (null: not along an axis), and its force. */
interface Line {
  readonly kind: 'cylinder' | 'bank' | 'rest' | 'engine'
  readonly name: string
  readonly bearing: number | null
  readonly force: Coefficients
}

/** Banks with their cylinders, or the cylinders alone; what the rest adds; the sum. */
export function linesOf(exhibit: Exhibit): readonly Line[] {
  const { cylinders: parts, scene, total } = exhibit
  const forces = parts.map(({ force }) => coefficientsOf(force))
  const one = (place: number): Line => ({
    kind: 'cylinder',
    name: String(parts[place]?.number ?? place + 1),
    bearing: scene.cylinders[place]?.bearing ?? null,
    force: forces[place] ?? new Float64Array(),
  })
  const banks = banksOf(exhibit)
  const rows = banks.length
    ? banks.flatMap(({ name, cylinders: places }): Line[] => [
        {
          kind: 'bank',
          name: bankName(name),
          bearing: bearingOf(places.map((place) => scene.cylinders[place]?.bearing ?? 0)),
          force: summed(places.map((place) => forces[place] ?? new Float64Array())),
        },
        ...places.map(one),
      ])
    : parts.map((_, place) => one(place))
  const whole = coefficientsOf(total.force)
  const all = summed(forces)
  const rest = whole.map((value, index) => value - (all[index] ?? 0))
  const most = Math.max(
    ...whole.map(Math.abs),
    ...forces.flatMap((each) => [...each.map(Math.abs)]),
  )
  const some = rest.some((value) => Math.abs(value) > ROUNDING * most)
  return [
    ...rows,
    ...(some
      ? [{ kind: 'rest' as const, name: t('shafts and weights'), bearing: null, force: rest }]
      : []),
    { kind: 'engine', name: t('engine'), bearing: null, force: whole },
  ]
}

/** A sum below this share of its parts is a rounding error. */
const ROUNDING = 1e-9

/** A bank by the name in its file; those without one are numbered. */
function bankName(name: string): string {
  return t('bank {name}', { name: name.replace(/^bank /, '') })
}

/** The bearing that all have; null where they differ, as in a radial engine. */
function bearingOf(bearings: readonly number[]): number | null {
  const [first = 0] = bearings
  return bearings.every((bearing) => Math.abs(bearing - first) < 1e-9) ? first : null
}

/** Greatest length of any row but the engine's, which its parts bound. */
function reachOf(exhibit: Exhibit): number {
  const { orders, turns } = exhibit
  return Math.max(
    0,
    ...linesOf(exhibit)
      .filter(({ kind }) => kind === 'cylinder' || kind === 'bank')
      .map(({ force }) => greatest(force, orders, null, turns)),
  )
}

function Forces() {
  const { store } = useApp()
  const exhibit = useExhibit()
  const exhibits = useExhibits()
  const body = useRef<HTMLTableElement>(null)
  const chosen = store.orders.value
  const lines = useMemo(() => linesOf(exhibit), [exhibit])
  const reach = useMemo(
    () => Math.max(...exhibits.map((each) => (alike(each, exhibit) ? reachOf(each) : 0))),
    [exhibits, exhibit],
  )
  const now = useMemo(() => textsOf(exhibit, lines, reach), [exhibit, lines, reach])
  useFollower((theta) => now(body.current, theta, chosen), [now, chosen])
  return (
    <Scroller label={t('Forces at this crank angle')}>
      <table class="pulls" ref={body}>
        <thead>
          <tr>
            <th scope="col">{t('cylinder')}</th>
            <th scope="col">
              {t('along its axis')} <span class="unit">{exhibit.units.force}</span>
            </th>
            <th scope="col" class="right">
              {t('vertical')} ↑
            </th>
            <th scope="col" class="right">
              {t('horizontal')} →
            </th>
          </tr>
        </thead>
        <tbody>
          {lines.map(({ kind, name, bearing }) => (
            <tr key={`${kind} ${name}`} class={kind}>
              <th scope="row">{name}</th>
              <td>
                {bearing !== null && (
                  <span class="along">
                    <span class="bar" aria-hidden="true">
                      <span />
                    </span>
                    <output aria-live="off" />
                  </span>
                )}
              </td>
              <td class="right">
                <output aria-live="off" />
              </td>
              <td class="right">
                <output aria-live="off" />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </Scroller>
  )
}

/** What writes the numbers of all rows, and moves their bars, at a crank angle. */
function textsOf({ orders, sense, units }: Exhibit, lines: readonly Line[], reach: number) {
  const phase = phaseOf(orders.length, sense)
  const place: Plane = [0, 0]
  const digits = decimalsOf(reach * units.force_factor)
  const write = (output: Element | undefined, value: number): void => {
    const text = signedText(value * units.force_factor, digits)
    if (output && output.textContent !== text) output.textContent = text
  }
  return (table: HTMLTableElement | null, theta: number, chosen: readonly number[] | null) => {
    if (!table) return
    turn(phase, orders, theta, chosen)
    const rows = table.tBodies[0]?.rows
    lines.forEach(({ force, bearing }, index) => {
      const row = rows?.[index]
      if (!row) return
      const [up, right] = vectorAt(force, phase, place)
      const outputs = [...row.getElementsByTagName('output')]
      if (bearing !== null) {
        const along = up * Math.cos(bearing) + right * Math.sin(bearing)
        write(outputs.shift(), along)
        const bar = row.querySelector<HTMLElement>('.bar > span')
        const share = reach > 0 ? along / reach : 0
        bar?.style.setProperty('transform', `scaleX(${share.toFixed(4)})`)
      }
      write(outputs[0], up)
      write(outputs[1], right)
    })
  }
}
