import { t } from '../language/messages'

/** Bars of one kind: how they are drawn, what they are called, a size for each order. */
export interface BarSeries {
  readonly key: string
  /** Whose colour it has; its own without. */
  readonly like?: string
  readonly label: string
  readonly sizes: readonly number[]
}

interface Props {
  readonly label: string
  readonly unit: string
  readonly orders: readonly number[]
  readonly series: readonly BarSeries[]
  /** The size that fills the height; the greatest of the series without. */
  readonly most?: number
}

/** A size with four figures; what is nought is 0. */
export const sizeText = (size: number): string =>
  size === 0 ? '0' : String(Number(size.toPrecision(4)))

/** Orders that all have their names below them; of more, or on a phone, only the coarse ones. */
const MOST_LABELS = 16
const MOST_COARSE = 12

/** Whole orders at equal steps, few enough for a phone. */
export function coarseOf(orders: readonly number[]): ReadonlySet<number> {
  const whole = orders.filter(Number.isInteger)
  const step = Math.ceil(whole.length / MOST_COARSE)
  return new Set(whole.filter((_, index) => (index + 1) % step === 0))
}

/** Bars over orders to one scale; what is exactly nought is a 0. */
export function Bars({ label, unit, orders, series, most }: Props) {
  const coarse = coarseOf(orders)
  const greatest = most ?? Math.max(...series.flatMap(({ sizes }) => sizes), 0)
  return (
    <figure class="order-bars">
      <figcaption>
        {label}{' '}
        <span class="soft">{t('greatest {size} {unit}', { size: sizeText(greatest), unit })}</span>
      </figcaption>
      <div
        class={orders.length > MOST_LABELS ? 'bars-over bars-many' : 'bars-over'}
        role="img"
        aria-label={label}
      >
        {orders.map((order, index) => (
          <div key={order} class="bars-group" data-order={order}>
            <div class="bars-stack">
              {series.map(({ key, like = key, sizes }, place) => {
                const size = sizes[index] ?? 0
                // where all are nought, one ring says so
                const none = place > 0 && series.every((each) => !each.sizes[index])
                return none ? null : size === 0 || greatest === 0 ? (
                  <i key={key} class="nought-bar" data-series={key} />
                ) : (
                  <i
                    key={key}
                    class={`order-bar of-${like}`}
                    data-series={key}
                    style={{ height: `${(100 * size) / greatest}%` }}
                  />
                )
              })}
            </div>
            <span class={coarse.has(order) ? 'bars-order' : 'bars-order bars-fine'}>{order}</span>
          </div>
        ))}
      </div>
      <ul class="legend">
        {series.map(({ key, like = key, label: name }) => (
          <li key={key}>
            <i class={`swatch of-${like}`} aria-hidden="true" /> {name}
          </li>
        ))}
        {series.some(({ sizes }) => sizes.includes(0)) && (
          <li>
            <i class="nought-bar" aria-hidden="true" /> {t('exactly 0')}
          </li>
        )}
      </ul>
    </figure>
  )
}
