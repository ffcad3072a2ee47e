import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import {
  curvesOf,
  type Gas,
  offOf,
  offText,
  type Setting,
  settingOf,
  type Torques,
  torquesOf,
} from '../torque'
import { extentOf, type Series } from './Curves'
import { useApp, useChoice } from './context'

export const useGas = () => useChoice<Gas>('torque.gas', ['burning', 'still', 'none'])
export const useDrawn = () =>
  useChoice<'faint' | 'apart' | 'none'>('torque.cylinders', ['faint', 'apart', 'none'])

/** The cylinders that are off, by their numbers, and what turns one off or on. */
export function useOff(): readonly [readonly number[], (number: number) => void] {
  const { store } = useApp()
  const { 'torque.off': text = '', ...others } = store.choices.value
  const off = offOf(text)
  const toggle = (number: number): void => {
    const next = off.includes(number) ? off.filter((each) => each !== number) : [...off, number]
    store.choices.value = next.length ? { ...others, 'torque.off': offText(next) } : others
  }
  return [off, toggle]
}

/** What chooses a load by its name, of every engine that has one of that name. */
export function useLoad(): (load: string) => void {
  const { store } = useApp()
  return (load) => {
    const { 'torque.load': _, ...others } = store.choices.value
    store.choices.value = load ? { ...others, 'torque.load': load } : others
  }
}

/** All that is chosen. */
export function useSetting(): Setting {
  const { store } = useApp()
  return settingOf(store.choices.value)
}

/** Gas, inertia and both, as far as they are known. */
export function seriesOf(torques: Torques): Series[] {
  const { gas, inertia, together, mean } = torques
  const own: Series[] = []
  if (gas) own.push({ key: 'gas', label: t('gas torque'), wave: gas, mean })
  if (inertia) own.push({ key: 'inertia', label: t('inertia torque'), wave: inertia, mean: 0 })
  if (gas && inertia) own.push({ key: 'both', label: t('together'), wave: together, mean })
  return own
}

/** The gas torque of each cylinder. */
export const cylindersOf = ({ chambers }: Torques): Series[] =>
  chambers.map(({ number, wave, mean }) => ({
    key: `cylinder-${number}`,
    label: t('cylinder {number}', { number }),
    wave,
    mean,
    faint: true,
  }))

/** Least and greatest value of some series of all engines that are counted in one unit. */
export function commonExtent(
  exhibits: readonly Exhibit[],
  setting: Setting,
  own: Torques,
  series: (torques: Torques) => readonly Series[],
): readonly [number, number] {
  const alike = exhibits
    .map((exhibit) => torquesOf(exhibit, setting))
    .filter(({ unit }) => unit === own.unit)
  return extentOf(
    alike.flatMap((each) =>
      curvesOf(series(each), each.orders, each.turns).map((curve) =>
        // factors to one unit are alike, those of relative engines are 1
        curve.map((value) => (value * each.factor) / own.factor),
      ),
    ),
  )
}
