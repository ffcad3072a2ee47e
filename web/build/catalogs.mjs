// Translations (gettext PO files) as the page reads them, made when the page is built.
import { po } from 'gettext-parser'

/**
 * The plural categories of a language that whole numbers have, in the order of gettext's `msgstr[n]`:
 * one, few, many in Russian; fractions, which no message counts, take the last.
 */
function categories(language) {
  const rules = new Intl.PluralRules(language)
  const order = ['zero', 'one', 'two', 'few', 'many', 'other']
  const whole = new Set(Array.from({ length: 200 }, (_, number) => rules.select(number)))
  return order.filter((category) => whole.has(category))
}

/** Sentences by their English, plural forms by that of one and the category; none half translated. */
export function resource(text) {
  const { headers, translations } = po.parse(text)
  const names = categories(headers.Language)
  const said = Object.values(translations).flatMap((context) => Object.values(context))
  const entries = said.flatMap(({ msgid, msgid_plural, msgstr }) => {
    if (!msgid || !msgstr.every(Boolean)) return []
    if (msgid_plural === undefined) return [[msgid, msgstr[0]]]
    return msgstr.map((form, index) => [`${msgid}_${names[index]}`, form])
  })
  return Object.fromEntries(entries)
}

/** Lets the page import a `.po` file: a function, so that only a language that is shown is read. */
export const catalogs = () => ({
  name: 'catalogs',
  transform: (text, id) =>
    id.endsWith('.po')
      ? {
          code: `export default () => JSON.parse(${JSON.stringify(JSON.stringify(resource(text)))})`,
          map: null,
        }
      : null,
})
