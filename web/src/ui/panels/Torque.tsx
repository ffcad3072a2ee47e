import { useMemo } from 'preact/hooks'
import { Coded } from '../../coded'
import type { Exhibit, Table } from '../../exhibit'
import { message, t } from '../../language/messages'
import { curvesOf, type Torques, torquesOf, unevenness } from '../../torque'
import { sizeText } from '../Bars'
import { Choice } from '../Choice'
import { Curves, extentOf, type Series } from '../Curves'
import { useExhibit, useExhibits } from '../context'
import { DataTable } from '../DataTable'
import { Each } from '../Each'
import type { Panel } from '../panel'
import { Term } from '../Term'
import { TorqueByOrder } from '../TorqueByOrder'
import {
  commonExtent,
  cylindersOf,
  seriesOf,
  useDrawn,
  useGas,
  useLoad,
  useOff,
  useSetting,
} from '../torques'

export const torque: Panel = {
  key: 'torque',
  label: message('Torque'),
  Content: TorquePanel,
}

/** Gas and inertia torque over a working cycle and by order, and what the block feels of it. */
function TorquePanel() {
  const exhibits = useExhibits()
  return (
    <>
      <Choices exhibits={exhibits} />
      <Each Part={OfEngine} />
    </>
  )
}

function Choices({ exhibits }: { exhibits: readonly Exhibit[] }) {
  const [gas, chooseGas] = useGas()
  const [drawn, chooseDrawn] = useDrawn()
  const isThere = exhibits.some((exhibit) => exhibit.torque)
  return (
    <>
      <div class="controls">
        {isThere && (
          <Choice
            label={t('Gas')}
            value={gas}
            choices={[
              { value: 'burning', label: t('burning') },
              { value: 'still', label: t('motored: no combustion') },
              { value: 'none', label: t('without gas') },
            ]}
            chosen={chooseGas}
          />
        )}
        {isThere && gas !== 'none' && (
          <Choice
            label={t('Curve of each cylinder')}
            value={drawn}
            choices={[
              { value: 'faint', label: t('faint') },
              { value: 'apart', label: t('one below the other') },
              { value: 'none', label: t('none') },
            ]}
            chosen={chooseDrawn}
          />
        )}
      </div>
      {isThere && gas === 'burning' && <CylindersOff exhibits={exhibits} />}
    </>
  )
}

/** A button for each cylinder, which turns its combustion off. */
function CylindersOff({ exhibits }: { exhibits: readonly Exhibit[] }) {
  const [off, toggle] = useOff()
  const numbers = new Set(
    exhibits.flatMap((exhibit) => exhibit.torque?.chambers.map(({ number }) => number) ?? []),
  )
  return (
    <fieldset class="choice off">
      <legend>{t('Cylinders without combustion')}</legend>
      <div class="choices">
        {[...numbers]
          .sort((one, other) => one - other)
          .map((number) => (
            <label key={number} class={off.includes(number) ? 'chosen' : ''}>
              <input
                type="checkbox"
                checked={off.includes(number)}
                onChange={() => toggle(number)}
              />
              <span>{number}</span>
            </label>
          ))}
      </div>
    </fieldset>
  )
}

/** The torque of one engine, to one scale with that of the other. */
function OfEngine() {
  const exhibit = useExhibit()
  const exhibits = useExhibits()
  const setting = useSetting()
  const [drawn] = useDrawn()
  const key = JSON.stringify(setting)
  const torques = useMemo(() => torquesOf(exhibit, setting), [exhibit, key])
  const shown = useMemo(() => {
    const series = (each: Torques) => [
      ...(drawn === 'faint' ? cylindersOf(each) : []),
      ...seriesOf(each),
    ]
    const rolls = (each: Torques): Series[] => [rollOf(each)]
    return {
      series: series(torques),
      extent: commonExtent(exhibits, setting, torques, series),
      rolls: rolls(torques),
      rolled: commonExtent(exhibits, setting, torques, rolls),
    }
  }, [torques, exhibits, drawn])
  const common = {
    unit: torques.unit,
    factor: torques.factor,
    turns: torques.turns,
    orders: torques.orders,
  }
  return (
    <div class="torque-of">
      <Basis exhibit={exhibit} torques={torques} />
      <Numbers exhibit={exhibit} torques={torques} />
      {shown.series.length > 0 && (
        <Curves
          label={t('Torque on the crankshaft')}
          series={shown.series}
          extent={shown.extent}
          {...common}
        />
      )}
      {drawn === 'apart' && <Apart torques={torques} />}
      <TorqueByOrder torques={torques} />
      <Curves
        label={t('Rolling moment on the block, clockwise, without its mean')}
        series={shown.rolls}
        extent={shown.rolled}
        {...common}
      />
      {setting.gas === 'burning' && !setting.off.length && torques.load?.tables.map(Beside)}
    </div>
  )
}

/** A table that goes with an operating point, folded up. */
const Beside = (table: Table) => (
  <details key={table.title} class="amplitudes">
    <summary>{t('{title}, every cylinder burning', { title: table.title })}</summary>
    <DataTable table={{ ...table, title: '' }} />
  </details>
)

const rollOf = ({ roll }: Torques): Series => ({
  key: 'roll',
  label: t('rolling moment'),
  wave: roll,
  mean: 0,
})

/** The load, and what the numbers rest on. */
function Basis({ exhibit, torques }: { exhibit: Exhibit; torques: Torques }) {
  const choose = useLoad()
  const loads = exhibit.torque?.loads ?? []
  const { load, inertia } = torques
  if (!load)
    return (
      <p class="needs">
        {exhibit.gas_needs} {t('Until then this is the inertia torque alone.')}
      </p>
    )
  return (
    <>
      {loads.length > 1 && (
        <Choice
          label={t('Operating point')}
          value={load.name}
          choices={loads.map(({ name }) => ({
            value: name,
            label: name || t('of the table [gas]'),
          }))}
          chosen={choose}
        />
      )}
      {!inertia && (
        <p>
          {load.speed === null
            ? t('Without a speed there is no inertia torque: this is gas alone.')
            : t('Without masses there is no inertia torque: this is gas alone.')}
        </p>
      )}
      {load.doubts.map((doubt) => (
        <p key={doubt} class="doubt">
          {doubt}
        </p>
      ))}
      <details class="torque-basis" hidden={!torques.gas}>
        <summary>
          {t('What the gas torque rests on')}
          {load.assumed && <span class="badge">{t('the load is assumed')}</span>}
        </summary>
        <ul>
          {load.notes.map((note) => (
            <li key={note}>
              <Coded text={note} />
            </li>
          ))}
        </ul>
      </details>
      {inertia && exhibit.ends.length > 0 && (
        <p class="estimate">
          {t('The inertia torque rests on estimated masses; its range is under Orders.')}
        </p>
      )}
    </>
  )
}

/** Four figures without closing zeros. */
const figured = (value: number): string => `${value < 0 ? '−' : ''}${sizeText(Math.abs(value))}`

/** Mean torque, mean effective pressure, power and how evenly it runs. */
function Numbers({ exhibit, torques }: { exhibit: Exhibit; torques: Torques }) {
  const { load, gas, mean, unit, factor, chambers } = torques
  if (!load || !gas || !exhibit.torque) return null
  const { cycle, displacement } = exhibit.torque
  const { units } = exhibit
  const brake = mean - load.friction
  const whole = chambers.every(({ burns }) => burns)
  const exact = whole && load.irregularity !== null
  const uneven = exact ? load.irregularity : unevenness(torques)
  return (
    <>
      <dl class="torque-facts">
        <Fact term="gas torque" name={t('mean gas torque')} value={figured(factor * mean)}>
          {unit}
        </Fact>
        <Fact
          term="imep"
          name={t('indicated mean effective pressure')}
          value={figured((units.pressure.factor * mean * cycle) / displacement)}
        >
          {units.pressure.label}
        </Fact>
        {load.speed !== null && (
          <>
            <Fact name={t('brake torque')} value={figured(factor * brake)}>
              {unit}
            </Fact>
            <Fact
              name={t('brake power at {rpm} rpm', { rpm: sizeText((load.speed * 30) / Math.PI) })}
              value={figured(units.power.factor * brake * load.speed)}
            >
              {units.power.label}
            </Fact>
          </>
        )}
        {uneven !== null && (
          <Fact
            term="degree of irregularity"
            name={
              exact ? t('degree of irregularity') : t('degree of irregularity, linear estimate')
            }
            value={figured(uneven)}
          />
        )}
      </dl>
      {torques.inertia && load.inertia === null && (
        <p class="soft small">
          {t(
            'The degree of irregularity needs the flywheel: give drive.inertia in the engine file.',
          )}
        </p>
      )}
    </>
  )
}

interface FactProps {
  readonly term?: string
  readonly name: string
  readonly value: string
  readonly children?: string
}

function Fact({ term, name, value, children = '' }: FactProps) {
  return (
    <div>
      <dt>{term ? <Term word={term}>{name}</Term> : name}</dt>
      <dd>
        <strong class="number">{value}</strong> {children}
      </dd>
    </div>
  )
}

/** The gas torque of each cylinder in a drawing of its own, as they fire, to one scale. */
function Apart({ torques }: { torques: Torques }) {
  const { chambers, orders, turns, unit, factor } = torques
  const shown = useMemo(() => {
    const inTurn = chambers.toSorted((one, other) => one.fires - other.fires)
    return cylindersOf({ ...torques, chambers: inTurn }).map((series) => [
      { ...series, key: 'gas', faint: false },
    ])
  }, [torques])
  const extent = useMemo(
    () => extentOf(curvesOf(shown.flat(), orders, turns)),
    [shown, orders, turns],
  )
  return (
    <div class="cylinders-apart">
      {shown.map((series) => (
        <Curves
          key={series[0]?.label}
          label={series[0]?.label ?? ''}
          {...{ series, extent, unit, factor, turns, orders }}
        />
      ))}
    </div>
  )
}
