import type { Problem } from '../exhibit'
import type { SearchOptions } from '../host/host'
import { message } from '../language/messages'
import { read } from './tree'

/** What can be minimised, by the names of `crankstar search --minimise`. */
export const OBJECTIVES = [
  ['M1', message('primary couple')],
  ['M2', message('secondary couple')],
  ['M4', message('fourth-order couple')],
  ['neighbours', message('adjacent cylinders that fire in succession')],
  ['couple', message('couples of all orders together')],
] as const

/** The fields of the dialog, as they stand in it. */
export interface SearchForm {
  readonly of: 'engine' | 'number'
  readonly cylinders: string
  readonly cycle: string
  readonly objectives: readonly string[]
  readonly more: string
  readonly best: string
  readonly zero: string
  readonly limit: string
  readonly fix: string
  readonly symmetric: boolean
  readonly apart: boolean
}

export const EMPTY: SearchForm = {
  of: 'engine',
  cylinders: '7',
  cycle: 'two-stroke',
  objectives: ['M1', 'M2'],
  more: '',
  best: '',
  zero: '',
  limit: '',
  fix: '',
  symmetric: false,
  apart: false,
}

export const SUBJECT = ['cylinders', 'cycle']
export const CONSTRAINTS = ['best', 'zero', 'limit', 'fix', 'symmetric', 'avoid_adjacent']
const FIELDS = [...SUBJECT, ...CONSTRAINTS, 'minimise']

const keyOf = ({ path }: Problem): string => String(read(path)[0] ?? '')

/** The sentences about some options. */
export function sentencesOf(problems: readonly Problem[], keys: readonly string[]): string[] {
  return problems.filter((problem) => keys.includes(keyOf(problem))).map(({ message }) => message)
}

/** Sentences about no field of the dialog. */
export function otherSentences(problems: readonly Problem[]): string[] {
  return problems
    .filter((problem) => !FIELDS.includes(keyOf(problem)))
    .map(({ path, message }) => (path ? `${path}: ${message}` : message))
}

const wholeNumber = (text: string): number | string =>
  Number.isInteger(Number(text)) && text.trim() ? Number(text) : text

/** The options that the server takes, by the names of the command line; only what was given. */
export function optionsOf(form: SearchForm): SearchOptions {
  const list = (text: string) => text.split(',').flatMap((part) => part.trim() || [])
  const objectives = [...form.objectives, ...list(form.more)]
  const limits = list(form.limit)
  return {
    ...(form.of === 'number' && { cylinders: wholeNumber(form.cylinders), cycle: form.cycle }),
    // the server chooses the usual couples, and omits those equal for all stars of the engine
    ...(objectives.length > 0 &&
      objectives.join() !== EMPTY.objectives.join() && { minimise: objectives.join(',') }),
    ...(form.best.trim() && { best: wholeNumber(form.best) }),
    ...(form.zero.trim() && { zero: form.zero.trim() }),
    ...(limits.length > 0 && { limit: limits }),
    ...(form.fix.trim() && { fix: form.fix.trim() }),
    ...(form.symmetric && { symmetric: true }),
    ...(form.apart && { avoid_adjacent: true }),
  }
}
