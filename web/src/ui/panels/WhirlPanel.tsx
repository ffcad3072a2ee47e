import type { Exhibit } from '../../exhibit'
import { t } from '../../language/messages'
import { lengthText, quantityText } from '../../lengths'
import { Switch } from '../../Switch'
import { set } from '../../state'
import { useApp, useExhibit } from '../context'
import { DataTable } from '../DataTable'
import { OrderChoice } from '../OrderChoice'
import { reachOf, rollOf, suggestedMagnification, toggledWhirl } from '../whirl'

/** The slider runs from 1 to a million, in powers of ten. */
const DECADES = 6

/** The motion of the free engine, magnified. */
export function WhirlPanel() {
  const app = useApp()
  const { store } = app
  const exhibit = useExhibit()
  const orders = store.orders.value
  const { whirl, units } = exhibit
  const most = suggestedMagnification(exhibit)
  return (
    <>
      <p>
        {t(
          'The engine block, free in space, moves against its own inertia forces. The displacement does not depend on the speed.',
        )}
      </p>
      {most === 0 ? (
        <p>{t('The block stays at rest: no force, couple or rolling moment remains.')}</p>
      ) : (
        <div class="controls">
          <Switch
            label={t('Show the whirl on the stage')}
            on={store.whirl.value > 0}
            change={() => toggledWhirl(app)}
          />
          <label class="wide">
            <span>{t('Magnification')}</span>
            <input
              type="range"
              min="0"
              max={DECADES}
              step="0.02"
              value={Math.log10(Math.max(1, store.whirl.value || most))}
              aria-valuetext={`× ${magnified(store.whirl.value || most)}`}
              onInput={(event) =>
                set(store.whirl, Number((10 ** event.currentTarget.valueAsNumber).toPrecision(2)))
              }
            />
            <span class="number">{magnified(store.whirl.value || most)} ×</span>
          </label>
        </div>
      )}
      <OrderChoice />
      <DataTable table={paths(exhibit, orders)} />
      <DataTable
        table={{
          title: t('Block'),
          heads: ['', t('vertical'), t('horizontal'), 'z'],
          numeric: [false, true, true, true],
          rows: [
            [t('centre of mass'), ...whirl.centre.map((place) => lengthText(place, units.lengths))],
            [
              t('moment of inertia about the axis'),
              ...whirl.inertia.map((size) =>
                quantityText(size * units.inertia.factor, units.inertia.label),
              ),
            ],
          ],
          notes: [
            t('Mass: {mass}', {
              mass: quantityText(whirl.mass * units.mass.factor, units.mass.label),
            }),
          ],
        }}
      />
      {whirl.assumed.map((sentence) => (
        <p key={sentence} class="estimate">
          <strong>{t('Estimate:')}</strong> {sentence}
        </p>
      ))}
    </>
  )
}

function magnified(factor: number): string {
  return factor.toLocaleString('en', { maximumSignificantDigits: 2, useGrouping: false })
}

/** An angle in degrees; rounding errors are 0. */
function degreesText(angle: number): string {
  return angle < 1e-12 ? '0' : quantityText((angle * 180) / Math.PI, '°').replace(' °', '°')
}

function paths(exhibit: Exhibit, orders: readonly number[] | null) {
  const { lengths } = exhibit.units
  const [front = 0, rear = 0] = reachOf(exhibit, orders)
  return {
    title: t('Displacement of the crank axis'),
    heads: [t('end'), t('greatest')],
    numeric: [false, true],
    rows: [
      [t('front end'), lengthText(front, lengths)],
      [t('rear end'), lengthText(rear, lengths)],
      [t('roll angle'), degreesText(rollOf(exhibit, orders))],
    ],
    notes: [
      t('True size, not magnified.'),
      ...(exhibit.estimated.length ? [t('Estimated, from the typical masses.')] : []),
    ],
  }
}
