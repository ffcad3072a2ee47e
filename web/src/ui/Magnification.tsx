import { t } from '../language/messages'
import { sizeText } from './Bars'

/** What a link can hold. */
const MOST = 999_999

interface Properties {
  /** How many times its true size it is drawn. */
  readonly times: number
  /** The slider runs from 1 to so many powers of ten. */
  readonly decades: number
  readonly chosen: (times: string) => void
}

/** How many times its true size a small motion is drawn. */
export function Magnification({ times, decades, chosen }: Properties) {
  const text = t('exaggerated × {times}', { times: sizeText(times) })
  return (
    <label class="wide times">
      <span>{t('Magnification')}</span>
      <input
        type="range"
        min="0"
        max={decades}
        step="0.02"
        value={Math.log10(times)}
        aria-valuetext={text}
        onInput={(event) => {
          const rounded = Number((10 ** event.currentTarget.valueAsNumber).toPrecision(2))
          chosen(String(Math.min(MOST, Math.max(1, Math.round(rounded)))))
        }}
      />
      <span class="number">{text}</span>
    </label>
  )
}
