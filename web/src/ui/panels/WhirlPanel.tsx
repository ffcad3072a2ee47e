import type { Exhibit } from '../../exhibit'
import { useApp, useExhibit } from '../context'
import { DataTable } from '../DataTable'
import { lengthText, quantityText } from '../lengths'
import { OrderChoice } from '../OrderChoice'
import { endsOf, rollOf, suggestedMagnification, toggledWhirl } from '../whirl'

/** The slider runs from 1 to a million, in powers of ten. */
const DECADES = 6

/** How the engine moves if nothing holds it, magnified. */
export function WhirlPanel() {
  const app = useApp()
  const { store } = app
  const exhibit = useExhibit()
  const orders = store.orders.value
  const { whirl, scene } = exhibit
  const most = suggestedMagnification(exhibit)
  return (
    <>
      <p>
        An engine that hangs freely answers its own forces: its block moves against its pistons. How far does not depend
        on the speed.
      </p>
      {most === 0 ? (
        <p>This engine stays where it is: no force, no couple and no roll is left.</p>
      ) : (
        <div class="controls">
          <label class="switch">
            <input type="checkbox" checked={store.whirl.value > 0} onChange={() => toggledWhirl(app)} />
            <span>Show it on the stage</span>
          </label>
          <label class="wide">
            <span>Magnified</span>
            <input
              type="range"
              min="0"
              max={DECADES}
              step="0.02"
              value={Math.log10(Math.max(1, store.whirl.value || most))}
              aria-valuetext={`${magnified(store.whirl.value || most)} times`}
              onInput={(event) => {
                store.whirl.value = Number((10 ** event.currentTarget.valueAsNumber).toPrecision(2))
              }}
            />
            <span class="number">{magnified(store.whirl.value || most)} ×</span>
          </label>
        </div>
      )}
      <OrderChoice />
      <DataTable table={paths(exhibit, orders)} />
      <DataTable
        table={{
          title: 'Block',
          heads: ['', 'up', 'right', 'z'],
          rows: [
            ['centre of mass', ...whirl.centre.map((place) => lengthText(place, scene.length_unit))],
            ['inertia about the axis', ...whirl.inertia.map((inertia) => quantityText(inertia, inertiaUnit(exhibit)))],
          ],
          notes: [`Mass ${quantityText(whirl.mass, massUnit(exhibit))}.`],
        }}
      />
      {whirl.assumed.map((sentence) => (
        <p key={sentence} class="estimate">
          <strong>Estimate.</strong> {sentence}
        </p>
      ))}
    </>
  )
}

function magnified(factor: number): string {
  return factor.toLocaleString('en', { maximumSignificantDigits: 2 })
}

/** An angle to either side, in degrees; what is rounding is nothing. */
function degreesText(angle: number): string {
  return angle < 1e-12 ? '0' : quantityText((angle * 180) / Math.PI, '°').replace(' °', '°')
}

function massUnit(exhibit: Exhibit): string {
  return exhibit.scene.length_unit === 'm' ? 'kg' : 'm'
}

function inertiaUnit(exhibit: Exhibit): string {
  return exhibit.scene.length_unit === 'm' ? 'kg m²' : 'm r²'
}

function paths(exhibit: Exhibit, orders: readonly number[] | null) {
  const { length_unit } = exhibit.scene
  return {
    title: 'Paths of the crank axis',
    heads: ['end', 'farthest from rest'],
    rows: [
      ...endsOf(exhibit, orders).map((end) => [end.name, lengthText(end.greatest, length_unit)]),
      ['roll of the block', degreesText(rollOf(exhibit, orders))],
    ],
    notes: ['In true size; the inset on the stage says how much it magnifies them.'],
  }
}
