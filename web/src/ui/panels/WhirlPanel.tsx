import { useMemo } from 'preact/hooks'
import type { Exhibit } from '../../exhibit'
import { message, t } from '../../language/messages'
import { lengthText, lengthUnit, rangedText } from '../../lengths'
import { Switch } from '../../Switch'
import { set } from '../../state'
import { useApp, useExhibit, useExhibits } from '../context'
import { DataTable } from '../DataTable'
import { Each } from '../Each'
import { OrderChoice } from '../OrderChoice'
import type { Panel } from '../panel'
import { reachOf, rollOf, toggledWhirl, usualMagnification } from '../whirl'

/** The slider runs from 1 to a million, in powers of ten. */
const DECADES = 6

export const whirl: Panel = {
  key: 'whirl',
  label: message('Whirl'),
  Content: WhirlPanel,
}

/** The motion of the free engine, magnified. */
function WhirlPanel() {
  const app = useApp()
  const { store } = app
  const most = usualMagnification(useExhibits())
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
      <Each Part={Displacement} />
    </>
  )
}

/** How far one engine moves, and the block of which that is true. */
function Displacement() {
  const { store } = useApp()
  const exhibit = useExhibit()
  const orders = store.orders.value
  const { whirl, whirl_ends: ends, units } = exhibit
  const displacement = useMemo(() => paths(exhibit, orders), [exhibit, orders])
  return (
    <>
      <DataTable table={displacement} />
      {!store.fitted.value && isBare(exhibit) && (
        <p class="estimate">
          {t(
            'The engine file has no counterweights, which such an engine may need: see Balancing for how it moves with them.',
          )}
        </p>
      )}
      <DataTable
        table={{
          title: t('Block'),
          heads: ['', t('vertical'), t('horizontal'), 'z'],
          numeric: [false, true, true, true],
          rows: [
            [t('centre of mass'), ...whirl.centre.map((place) => lengthText(place, units.lengths))],
            [
              t('moment of inertia about the axis'),
              ...whirl.inertia.map((size, axis) =>
                rangedText(
                  size,
                  ends.map(({ inertia }) => inertia[axis] ?? size),
                  units.inertia,
                ),
              ),
            ],
          ],
          notes: [
            t('Mass: {mass}', {
              mass: rangedText(
                whirl.mass,
                ends.map(({ mass }) => mass),
                units.mass,
              ),
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

/** Whether no shaft has a weight. */
function isBare({ scene }: Exhibit): boolean {
  return scene.shafts.every(({ weights }) => weights.length === 0)
}

function magnified(factor: number): string {
  return factor.toLocaleString('en', { maximumSignificantDigits: 2, useGrouping: false })
}

/** An angle in degrees, with its range; rounding errors are 0. */
function degreesText(angle: number, others: readonly number[]): string {
  const unit = { label: '°', factor: 180 / Math.PI }
  return angle < 1e-12 ? '0' : rangedText(angle, others, unit).replace(/ °$/, '°')
}

/** How far the two ends go and the block rolls, over the ranges of an estimated engine. */
function paths(exhibit: Exhibit, orders: readonly number[] | null) {
  const { lengths } = exhibit.units
  const ends = exhibit.whirl_ends.map((whirl) => ({ ...exhibit, whirl }))
  const [front = 0, rear = 0] = reachOf(exhibit, orders)
  const others = ends.map((each) => reachOf(each, orders))
  const rolls = ends.map((each) => rollOf(each, orders))
  const at = (end: number) => others.map((reach) => reach[end] ?? 0)
  const length = (size: number, end: number) => {
    const text = lengthText(size, lengths)
    return text === '0' ? text : rangedText(size, at(end), lengthUnit(size, lengths))
  }
  return {
    title: t('Displacement of the crank axis'),
    heads: [t('end'), ends.length ? t('greatest (estimated)') : t('greatest')],
    numeric: [false, true],
    rows: [
      [t('front end'), length(front, 0)],
      [t('rear end'), length(rear, 1)],
      [t('roll angle'), degreesText(rollOf(exhibit, orders), rolls)],
    ],
    notes: [t('True size, not magnified.')],
  }
}
