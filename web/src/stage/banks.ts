import type { Exhibit } from '../exhibit'

/** The cylinders of a bank: its name, their places in the exhibit. */
export interface Bank {
  readonly name: string
  readonly cylinders: readonly number[]
}

/** The banks of an engine; none where it has one, or none with more than one cylinder. */
export function banksOf({ cylinders }: Pick<Exhibit, 'cylinders'>): readonly Bank[] {
  const banks = new Map<string, number[]>()
  cylinders.forEach(({ bank }, place) => {
    banks.set(bank, [...(banks.get(bank) ?? []), place])
  })
  const all = [...banks].map(([name, places]) => ({ name, cylinders: places }))
  return all.length > 1 && all.some((bank) => bank.cylinders.length > 1) ? all : []
}
