import type { Tree } from '../host/host'
import { t } from '../language/messages'
import { type Dimension, textOf } from './quantity'
import { at } from './tree'

/** What a field of an engine file takes, read from the JSON Schema of the files. */
export type Kind =
  | { readonly is: 'fixed'; readonly value: unknown }
  | { readonly is: 'choice'; readonly among: readonly string[]; readonly logical?: boolean }
  | { readonly is: 'text'; readonly long: boolean }
  | { readonly is: 'number'; readonly whole: boolean; readonly low: number; readonly high: number }
  | { readonly is: 'ratio' }
  | {
      readonly is: 'quantity'
      readonly dimension: Dimension
      readonly relativeTo: readonly string[]
      readonly positive: boolean
      /** Whether it may also be a list. */
      readonly several?: boolean
    }
  | { readonly is: 'numbers' }
  | { readonly is: 'lists' }
  | { readonly is: 'marks'; readonly among: readonly string[] }
  | { readonly is: 'quantities'; readonly item: Field }
  | { readonly is: 'record'; readonly fields: readonly Field[] }
  | { readonly is: 'records'; readonly fields: readonly Field[] }
  | { readonly is: 'table'; readonly fields: readonly Field[] }

export type Of<T extends Kind['is']> = Extract<Kind, { is: T }>

/** Whether a value has a unit in an engine, else it is a bare number beside what is not known. */
export const measured = ({ relativeTo }: Of<'quantity'>, relative: readonly string[]): boolean =>
  !relativeTo.some((unit) => relative.includes(unit))

/** A key of a table: what it is called, what it means, an example, and what it takes. */
export interface Field {
  readonly key: string
  readonly label: string
  readonly help: string
  readonly example: string
  readonly required: boolean
  readonly initial: unknown
  readonly kind: Kind
}

type Node = Record<string, unknown>

/** Dimensions of the schema that the form treats in their own way. */
const DIMENSIONS: Readonly<Record<string, Dimension>> = {
  angle: 'angle',
  length: 'length',
  'length along the crankshaft': 'length',
  mass: 'mass',
  'rotational speed': 'speed',
}

const nodes = (value: unknown): Node[] => (Array.isArray(value) ? (value as Node[]) : [])
const text = (value: unknown): string => (typeof value === 'string' ? value : '')
const strings = (value: unknown): string[] => (Array.isArray(value) ? value.map(String) : [])

/** A definition that is referred to, with what stands beside the reference put over it. */
function followed(schema: Tree, node: Node): Node {
  const reference = text(node.$ref)
  if (!reference) return node
  const { $ref: _, ...beside } = node
  const definition = at(schema, reference.replace(/^#\//, '').split('/')) as Node | undefined
  return { ...followed(schema, definition ?? {}), ...beside }
}

/** The alternatives for a value except null; `required` says whether it may be absent. */
function ways(schema: Tree, node: Node): Node[] {
  const given = node.anyOf
    ? nodes(node.anyOf).map((way) => followed(schema, way))
    : [followed(schema, node)]
  return given
    .flatMap((way) => (way.anyOf ? ways(schema, way) : [way]))
    .filter((way) => way.type !== 'null')
}

function listKind(schema: Tree, way: Node): Kind {
  const item = (way.items ?? {}) as Node
  const inner = fieldOf(schema, '', item, true)
  if (inner.kind.is === 'quantity')
    return { is: 'quantities', item: { ...inner, help: text(way.description) } }
  if (inner.kind.is === 'numbers') return { is: 'lists' }
  if (inner.kind.is === 'choice') return { is: 'marks', among: inner.kind.among }
  if (inner.kind.is === 'record') return { is: 'records', fields: inner.kind.fields }
  return { is: 'numbers' }
}

function kindOf(schema: Tree, node: Node): Kind {
  const given = ways(schema, node)
  const first = given[0] ?? {}
  if ('const' in first) return { is: 'fixed', value: first.const }
  if (first.enum) return { is: 'choice', among: strings(first.enum) }
  if (first.type === 'boolean') return { is: 'choice', among: ['false', 'true'], logical: true }
  const measured = given.find((way) => 'x-dimension' in way)
  if (measured && first.type !== 'array') {
    const dimension = DIMENSIONS[text(measured['x-dimension'])] ?? 'other'
    const relativeTo = strings(measured['x-relative-to'])
    const positive = given.some((way) => 'exclusiveMinimum' in way || way.minimum === 0)
    const several = given.some((way) => way.type === 'array')
    return { is: 'quantity', dimension, relativeTo, positive, ...(several && { several }) }
  }
  if (first.type === 'array') return listKind(schema, first)
  if (first.properties) return { is: 'record', fields: fieldsOf(schema, first) }
  if (first.type === 'object') {
    const inner = followed(schema, (first.additionalProperties ?? {}) as Node)
    return { is: 'table', fields: fieldsOf(schema, inner) }
  }
  if (given.length > 1) return { is: 'ratio' }
  if (first.type === 'number' || first.type === 'integer') {
    const low = Number(first.minimum ?? first.exclusiveMinimum ?? Number.NEGATIVE_INFINITY)
    const high = Number(first.maximum ?? Number.POSITIVE_INFINITY)
    return { is: 'number', whole: first.type === 'integer', low, high }
  }
  return { is: 'text', long: Number(first.maxLength) >= 10000 }
}

/** A key as words: `bore_pitch` is `Bore pitch`. */
export function worded(key: string): string {
  const words = key.replaceAll('_', ' ')
  return words.charAt(0).toUpperCase() + words.slice(1)
}

function exampleOf(schema: Tree, node: Node): string {
  const given =
    nodes(node.examples)[0] ?? ways(schema, node).flatMap((way) => nodes(way.examples))[0]
  return given === undefined ? '' : textOf(given)
}

function fieldOf(schema: Tree, key: string, node: Node, required: boolean): Field {
  const whole = followed(schema, node)
  return {
    key,
    label: text(whole['x-label']) || worded(key),
    help: text(whole.description),
    example: exampleOf(schema, whole),
    required,
    initial: whole.default,
    kind: kindOf(schema, whole),
  }
}

/** The fields of a table that the schema defines. */
function fieldsOf(schema: Tree, node: Node): Field[] {
  const required = strings(node.required)
  return Object.entries((node.properties ?? {}) as Record<string, Node>).map(([key, inner]) =>
    fieldOf(schema, key, inner, required.includes(key)),
  )
}

/** A form of engine files: the explicit one, or a short one for a type of layout. */
export interface Form {
  /** Type of the layout, or `explicit`. */
  readonly type: string
  readonly help: string
  readonly fields: readonly Field[]
}

export const EXPLICIT = 'explicit'

/** All the forms of the schema. */
export function forms(schema: Tree): Form[] {
  return nodes(schema.anyOf).map((way) => {
    const node = followed(schema, way)
    const fields = fieldsOf(schema, node)
    const layout = fields.find((field) => field.key === 'layout')?.kind
    const fixed =
      layout?.is === 'record'
        ? layout.fields.find((field) => field.key === 'type')?.kind
        : undefined
    const type = fixed?.is === 'fixed' ? String(fixed.value) : EXPLICIT
    return {
      type,
      help:
        type === EXPLICIT
          ? t('every shaft, throw, weight and cylinder by itself')
          : text(node.description),
      fields,
    }
  })
}

/** The form of an engine file, by the type of its layout; without one, the explicit form. */
export function formOf(all: readonly Form[], tree: Tree): Form | undefined {
  const type = at(tree, ['layout', 'type'])
  return (
    all.find((form) => form.type === (tree.layout === undefined ? EXPLICIT : type)) ??
    all.find((form) => form.type === EXPLICIT)
  )
}
