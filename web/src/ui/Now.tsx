import { useRef } from 'preact/hooks'
import type { Exhibit } from '../exhibit'
import { useApp, useFollower } from './context'
import { bound, signalAt, vectorAt, weightsOf } from './vectors'

/** Force, couple and roll at this very angle, of the chosen orders. */
export function Now() {
  const { shown } = useApp()
  return (
    <section class="now" aria-label="At this angle">
      {shown.value.map((exhibit, index) => (
        <Numbers key={index} exhibit={exhibit} />
      ))}
    </section>
  )
}

function Numbers({ exhibit }: { exhibit: Exhibit }) {
  const { store } = useApp()
  const cells = useRef<HTMLDListElement>(null)
  const orders = store.orders.value
  useFollower(
    (theta) => {
      const fields = cells.current?.querySelectorAll('output')
      if (!fields) return
      const { force, couple, roll } = exhibit.total
      const weights = weightsOf(exhibit, orders)
      const [up, right] = vectorAt(exhibit, force, weights, theta)
      const [pitch, yaw] = vectorAt(exhibit, couple, weights, theta)
      const turn = signalAt(exhibit, roll, weights, theta)
      const [f, c, r] = [decimals(bound(force)), decimals(bound(couple)), decimals(reach(roll))]
      const texts = [signed(up, f), signed(right, f), signed(pitch, c), signed(yaw, c), signed(turn, r)]
      texts.forEach((text, index) => {
        const field = fields[index]
        if (field && field.textContent !== text) field.textContent = text
      })
    },
    [exhibit, orders],
  )
  const { units } = exhibit
  return (
    <dl ref={cells}>
      <Vector label="Force" unit={units.force} />
      <Vector label="Couple" unit={units.couple} />
      <div>
        <dt>Roll</dt>
        <dd>
          <output aria-live="off" aria-label="roll" /> <span class="unit">{units.roll}</span>
        </dd>
      </div>
    </dl>
  )
}

function Vector({ label, unit }: { label: string; unit: string }) {
  return (
    <div>
      <dt>{label}</dt>
      <dd>
        <span class="way" title="up">
          ↑
        </span>
        <output aria-live="off" aria-label={`${label} up`} />{' '}
        <span class="way" title="right">
          →
        </span>
        <output aria-live="off" aria-label={`${label} right`} /> <span class="unit">{unit}</span>
      </dd>
    </div>
  )
}

function reach(pairs: readonly (readonly [number, number])[]): number {
  return pairs.reduce((sum, [real, imaginary]) => sum + Math.hypot(real, imaginary), 0)
}

/** So many decimals that the greatest value has four figures; the same all the time, so that nothing jumps. */
function decimals(greatest: number): number {
  if (!(greatest > 1e-12)) return 0
  return Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(greatest))))
}

function signed(value: number, digits: number): string {
  const text = Math.abs(value).toFixed(digits)
  const zero = Number(text) === 0
  return `${zero ? '\u2007' : value < 0 ? '−' : '+'}${text}`
}
