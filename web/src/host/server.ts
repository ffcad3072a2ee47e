import type { DerivationShown, Exhibit, Exhibition, FittedShown, TreeShown } from '../exhibit'
import { language } from '../language/messages'
import { stateOf } from '../state'
import { addressState } from './address'
import { requested, required } from './api'
import { drawing, ofPage } from './drawing'
import type { Host, Spec } from './host'
import { service } from './service'
import { watched } from './watching'

/** Figures and derivations that are kept; a session of editing asks for many. */
const KEPT = 60

/** Answers that were given, the oldest forgotten first; a failed request is sent again. */
function remembered<T>(): (key: string, ask: () => Promise<T>) => Promise<T> {
  const answers = new Map<string, Promise<T>>()
  return (key, ask) => {
    const known = answers.get(key)
    if (known) return known
    const answer = ask()
    answers.set(key, answer)
    answer.catch(() => answers.delete(key))
    const oldest = answers.keys().next().value
    if (answers.size > KEPT && oldest !== undefined) answers.delete(oldest)
    return answer
  }
}

/** The local server, `crankstar serve`. */
export async function serverHost(): Promise<Host> {
  const address = addressState()
  // the engine that comes first is already told of in the language of the link
  language.value = stateOf(address.readState()).language || address.language
  const exhibition = await required(requested<Exhibition>('opening'))
  const numbers = new WeakMap<Exhibit, number>()
  let count = 0
  // an exhibit never changes, so that one number stands for its whole engine file
  const numberOf = (exhibit: Exhibit): number => {
    const number = numbers.get(exhibit) ?? ++count
    numbers.set(exhibit, number)
    return number
  }
  const fitted = remembered<Exhibit | null>()
  exhibition.engines.forEach((exhibit, index) => {
    const after = exhibition.fitted[index]
    if (after) void fitted(`${numberOf(exhibit)}`, () => Promise.resolve(after))
  })
  const post = <T>(path: string, exhibit: Exhibit, key?: string, beside?: Exhibit) =>
    required(
      requested<T>(path, {
        body: {
          engine: exhibit.file,
          ...(key && { key }),
          ...(beside && { beside: beside.file }),
          units: exhibit.units.chosen,
        },
      }),
    )
  const charts = remembered<Spec>()
  const derivations = remembered<DerivationShown>()
  return {
    kind: 'server',
    exhibition,
    chart: (exhibit, key, beside) =>
      charts(`${numberOf(exhibit)} ${beside ? numberOf(beside) : 0} ${key}`, () =>
        post('chart', exhibit, key, beside),
      ),
    drawing: drawing(() => ofPage(document)),
    anyUnits: true,
    inUnits: (exhibit, units) =>
      required(requested<Exhibit>('exhibit', { body: { engine: exhibit.file, units } })),
    estimate: async (exhibit) =>
      (await required(requested<TreeShown>('estimate', { body: { engine: exhibit.file } }))).tree,
    derivation: async (exhibit, key) => {
      const body = { engine: exhibit.file, key }
      const ask = () => required(requested<DerivationShown>('derivation', { body }))
      return (await derivations(`${numberOf(exhibit)} ${key}`, ask)).html
    },
    fitted: (exhibit) => {
      const ask = async () => (await post<FittedShown>('fitted', exhibit)).exhibit
      return fitted(`${numberOf(exhibit)}`, ask)
    },
    watched: (changed) => watched(exhibition.engines[0].file, changed),
    service,
    ...address,
  }
}
