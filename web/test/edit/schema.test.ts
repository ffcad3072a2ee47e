import { expect, test } from 'vitest'
import { another, recordOf } from '../../src/edit/newRecords'
import { EXPLICIT, type Field, formOf, forms, worded } from '../../src/edit/schema'

const quantity = (words: string, example: string, more: object = {}) => ({
  anyOf: [
    {
      type: 'string',
      'x-dimension': words,
      'x-relative-to': words === 'angle' ? [] : ['pitch'],
      examples: [example],
    },
    { type: 'number', ...more },
  ],
})
const orNull = (node: { anyOf: object[] }) => ({
  anyOf: [...node.anyOf, { type: 'null' }],
  default: null,
})

/** What the schema of engine files is made of, once each. */
const schema = {
  $defs: {
    Bank: {
      properties: {
        bearing: {
          ...quantity('angle', '90 deg'),
          default: 0,
          description: 'where the cylinders point',
        },
        cylinders: { type: 'array', items: { type: 'integer' } },
        name: { anyOf: [{ type: 'string', maxLength: 200 }, { type: 'null' }] },
      },
      required: ['cylinders'],
    },
    Vee: {
      description: 'V',
      properties: {
        type: { const: 'vee' },
        banks: { type: 'array', items: { $ref: '#/$defs/Bank' } },
        throws: { type: 'array', items: quantity('angle', '90 deg') },
        bore_pitch: orNull(
          quantity('length along the crankshaft', '105.5 mm', { exclusiveMinimum: 0 }),
        ),
        speed_ratio: {
          anyOf: [{ type: 'number' }, { type: 'string', pattern: '^' }],
          default: '1',
        },
      },
      required: ['type', 'banks', 'throws'],
    },
    ShortVee: {
      description: 'Any number of banks',
      properties: {
        name: { type: 'string', maxLength: 200 },
        notes: { type: 'string', maxLength: 10000 },
        cycle: { enum: ['two-stroke', 'four-stroke'], default: 'four-stroke' },
        manifolds: {
          type: 'array',
          items: { type: 'array', items: { type: 'integer' } },
          examples: [
            [
              [1, 4],
              [2, 3],
            ],
          ],
        },
        relative: { type: 'array', items: { enum: ['mass', 'radius'] } },
        balance_factor: { anyOf: [{ type: 'number', minimum: 0, maximum: 2 }, { type: 'null' }] },
        provenance: {
          type: 'object',
          additionalProperties: { properties: { status: { enum: ['published'] } } },
        },
        layout: { $ref: '#/$defs/Vee', description: 'how the cylinders are arranged' },
      },
      required: ['name', 'layout'],
    },
    Engine: {
      properties: {
        shaft: {
          type: 'array',
          items: { properties: { name: { type: 'string' } }, required: ['name'] },
        },
      },
    },
  },
  anyOf: [{ $ref: '#/$defs/Engine' }, { $ref: '#/$defs/ShortVee' }],
}

const all = forms(schema)
const short = all.find((form) => form.type === 'vee')
const field = (fields: readonly Field[] | undefined, key: string): Field => {
  const found = fields?.find((one) => one.key === key)
  if (!found) throw new Error(`no field ${key}`)
  return found
}
const layout = field(short?.fields, 'layout')
const inner = (one: Field): readonly Field[] => ('fields' in one.kind ? one.kind.fields : [])

test('an engine file is in the form that its layout says, else in the explicit one', () => {
  expect(all.map((form) => form.type)).toEqual([EXPLICIT, 'vee'])
  expect(formOf(all, { layout: { type: 'vee' } })?.type).toBe('vee')
  expect(formOf(all, { shaft: [] })?.type).toBe(EXPLICIT)
})

test.each([
  ['name', { is: 'text', long: false }],
  ['notes', { is: 'text', long: true }],
  ['cycle', { is: 'choice', among: ['two-stroke', 'four-stroke'] }],
  ['manifolds', { is: 'lists' }],
  ['relative', { is: 'marks', among: ['mass', 'radius'] }],
  ['balance_factor', { is: 'number', whole: false, low: 0, high: 2 }],
])('%s takes what the schema says', (key, kind) => {
  expect(field(short?.fields, key).kind).toEqual(kind)
})

test.each([
  ['type', 'fixed'],
  ['banks', 'records'],
  ['throws', 'quantities'],
  ['bore_pitch', 'quantity'],
  ['speed_ratio', 'ratio'],
])('%s of the layout is a %s', (key, is) => {
  expect(field(inner(layout), key).kind.is).toBe(is)
})

test('a length has its dimension, and whether it may be negative', () => {
  expect(field(inner(layout), 'bore_pitch').kind).toEqual({
    is: 'quantity',
    dimension: 'length',
    relativeTo: ['pitch'],
    positive: true,
  })
  expect(field(inner(layout), 'bore_pitch').example).toBe('105.5 mm')
  const bearing = field(inner(field(inner(layout), 'banks')), 'bearing')
  expect(bearing).toMatchObject({ help: 'where the cylinders point', initial: 0, required: false })
  expect(bearing.kind).toEqual({
    is: 'quantity',
    dimension: 'angle',
    relativeTo: [],
    positive: false,
  })
})

test('words beside a reference stand over those of what it refers to', () => {
  expect(layout.help).toBe('how the cylinders are arranged')
  expect(field(short?.fields, 'provenance').kind.is).toBe('table')
  expect(worded('bore_pitch')).toBe('Bore pitch')
})

test('a new record has what it must have', () => {
  expect(recordOf(inner(layout), [])).toEqual({
    type: 'vee',
    banks: [{ cylinders: [1] }],
    throws: ['90 deg'],
  })
  const mass = { ...field(inner(layout), 'bore_pitch'), required: true, example: '165 kg' } as const
  const kind = { is: 'quantity', dimension: 'mass', relativeTo: ['mass'], positive: true } as const
  const heavy = { ...mass, kind }
  expect(recordOf([heavy], ['mass'])).toEqual({ bore_pitch: 165 })
  expect(recordOf([heavy], ['pitch'])).toEqual({ bore_pitch: '165 kg' })
})

test('another record is like the last, with the numbers that come next', () => {
  const banks = [
    { cylinders: [1, 3], bearing: '45 deg' },
    { cylinders: [2, 4], bearing: '-45 deg', name: 'left' },
  ]
  const fields = inner(field(inner(layout), 'banks'))
  expect(another(banks, fields, [])).toEqual({
    cylinders: [5, 6],
    bearing: '-45 deg',
    name: 'left 3',
  })
  expect(another([{ number: 7 }, { number: 3 }], fields, [])).toEqual({ number: 8 })
  expect(another([], fields, [])).toEqual({ cylinders: [1] })
})

test('one value or several of them is a quantity that takes a list', () => {
  const one = quantity('stiffness', '200 N/mm', { minimum: 0 })
  const listed = { anyOf: [one, { type: 'array', items: one }] }
  const examples = [['200 N/mm', '80 N/mm']]
  const schema = {
    anyOf: [{ properties: { stiffness: { ...listed, examples } }, required: ['stiffness'] }],
  }
  const [form] = forms(schema)
  const stiffness = field(form?.fields, 'stiffness')
  expect(stiffness.kind).toMatchObject({ is: 'quantity', dimension: 'other', several: true })
  expect(recordOf([stiffness], [])).toEqual({ stiffness: ['200 N/mm', '80 N/mm'] })
})
