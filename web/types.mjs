// The types of what Python sends, made from its JSON Schema on standard input: python -m crankstar.exhibit | node types.mjs > src/exhibit.ts
import { readFileSync } from 'node:fs'
import { compile } from 'json-schema-to-typescript'

const banner = '// Generated from src/crankstar/exhibit/records.py by `make types`; not edited by hand.'
const style = { semi: false, singleQuote: true, printWidth: 120 }
/** Tuples as the converter understands them: `prefixItems` by its older name `items`. */
function olderTuples(schema) {
  if (Array.isArray(schema)) return schema.map(olderTuples)
  if (schema === null || typeof schema !== 'object') return schema
  const { prefixItems, ...rest } = Object.fromEntries(
    Object.entries(schema).map(([key, value]) => [key, olderTuples(value)]),
  )
  return prefixItems ? { ...rest, items: prefixItems } : rest
}

const made = await compile(olderTuples(JSON.parse(readFileSync(0, 'utf8'))), 'Exhibition', {
  bannerComment: banner,
  additionalProperties: false,
  unreachableDefinitions: true,
  style,
})
// The lines that say which schema a type comes from are noise: there is one.
process.stdout.write(
  made
    .replace(/^( \*\n)? \* This interface was referenced by .*\n \* via the .*\n/gm, '')
    .replace(/\/\*\*\n \*\/\n/g, ''),
)
