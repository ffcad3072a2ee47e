// The types of the records that Python sends, from their JSON Schema on standard input (make types)
import { readFileSync } from 'node:fs'
import { compile } from 'json-schema-to-typescript'

const banner =
  '// Generated from src/crankstar/page/records.py by `make types`; not edited by hand.'
const style = { semi: false, singleQuote: true, printWidth: 100 }
/** Tuples as the converter understands them: `prefixItems` by its older name `items`. */
function olderTuples(schema) {
  if (Array.isArray(schema)) return schema.map(olderTuples)
  if (schema === null || typeof schema !== 'object') return schema
  const { prefixItems, ...rest } = Object.fromEntries(
    Object.entries(schema).map(([key, value]) => [key, olderTuples(value)]),
  )
  return prefixItems ? { ...rest, items: prefixItems } : rest
}

const made = await compile(olderTuples(JSON.parse(readFileSync(0, 'utf8'))), 'Exchange', {
  bannerComment: banner,
  additionalProperties: false,
  unreachableDefinitions: true,
  maxItems: 2,
  style,
})
// Which schema a type comes from is noise, as there is one; so are the lengths of tuples. What fits
// stands in one line, as in the other sources.
process.stdout.write(
  made
    .replace(/^( \*\n)? \* This interface was referenced by .*\n \* via the .*\n/gm, '')
    .replace(/^( *\*\n)?( *\* @(min|max)Items \d+\n)+/gm, '')
    .replace(/^ *\/\*\*\n *\*\/\n/gm, '')
    .replace(/\{\s*\[k: string\]: unknown\s*\}/g, 'Record<string, unknown>')
    .replace(/^( *\/\*\*)\n *\*( .{1,90})\n *\*\//gm, '$1$2 */'),
)
