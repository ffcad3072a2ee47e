import { parsed } from './quantity'
import { type Field, measured } from './schema'

/** A new table: its required keys, with examples or least values, bare beside what is not known. */
export function recordOf(
  fields: readonly Field[],
  relative: readonly string[],
): Record<string, unknown> {
  return Object.fromEntries(
    fields
      .filter((field) => field.required)
      .map((field) => [field.key, beginningOf(field, relative)]),
  )
}

function beginningOf(field: Field, relative: readonly string[]): unknown {
  const { kind } = field
  switch (kind.is) {
    case 'fixed':
      return kind.value
    case 'choice':
      return kind.among[0]
    case 'quantity':
      if (measured(kind, relative))
        return kind.several && field.example.includes(',')
          ? field.example.split(',').map((part) => part.trim())
          : field.example
      return kind.dimension === 'mass'
        ? (parsed(field.example)?.number ?? 1)
        : kind.positive
          ? 1
          : 0
    case 'number':
      return Number.isFinite(kind.low) ? kind.low : 1
    case 'record':
    case 'table':
      return recordOf(kind.fields, relative)
    case 'records':
      return [recordOf(kind.fields, relative)]
    case 'quantities':
      return [kind.item.example]
    case 'numbers':
      return [1]
    case 'marks':
    case 'lists':
      return []
    case 'ratio':
      return 1
    case 'text':
      return field.example
  }
}

const greatest = (numbers: unknown[]) => Math.max(0, ...numbers.map(Number).filter(Number.isFinite))

/** Another table for a list: like the last, with the next cylinder numbers. */
export function another(
  records: readonly unknown[],
  fields: readonly Field[],
  relative: readonly string[],
): Record<string, unknown> {
  const last = records.at(-1)
  const next =
    typeof last === 'object' && last !== null
      ? { ...(last as Record<string, unknown>) }
      : recordOf(fields, relative)
  const all = records as Record<string, unknown>[]
  if (typeof next.number === 'number')
    next.number = greatest(all.map((record) => record.number)) + 1
  if (Array.isArray(next.cylinders)) {
    const most = greatest(
      all.flatMap((record) => (Array.isArray(record.cylinders) ? record.cylinders : [])),
    )
    next.cylinders = next.cylinders.map((_, place) => most + place + 1)
  }
  if (typeof next.name === 'string' && records.length > 0)
    next.name = `${next.name} ${records.length + 1}`
  return next
}
