// A font for mathematics that travels with the page: STIX Two Math with the letters of formulas alone.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, join } from 'node:path'
import subsetFont from 'subset-font'

const PACKAGE = '@fontsource/stix-two-math'
const ID = 'virtual:math-font'
/** Beside the bundle, for reports. */
const FILE = 'math.woff2'
/** First and last code of each run of letters. */
const LETTERS = JSON.parse(readFileSync(new URL('math-letters.json', import.meta.url), 'utf8'))

const home = dirname(createRequire(import.meta.url).resolve(`${PACKAGE}/package.json`))

async function font() {
  const whole = readFileSync(join(home, 'files', 'stix-two-math-latin-400-normal.woff2'))
  const codes = LETTERS.flatMap(([from, to]) =>
    Array.from({ length: Number(`0x${to}`) - Number(`0x${from}`) + 1 }, (_, n) => Number(`0x${from}`) + n),
  )
  return subsetFont(whole, String.fromCodePoint(...codes), { targetFormat: 'woff2' })
}

/** What the licences say of the font, which is no module of the bundle. */
export function fontLicence() {
  const { name, version, license } = JSON.parse(readFileSync(join(home, 'package.json'), 'utf8'))
  return { name, version, identifier: license, text: readFileSync(join(home, 'LICENSE'), 'utf8') }
}

/** Lets the page import the font as base64. */
export const mathFont = () => ({
  name: 'math-font',
  resolveId: (id) => (id === ID ? ID : null),
  async load(id) {
    if (id !== ID) return null
    const made = await font()
    this.emitFile({ type: 'asset', fileName: FILE, source: made })
    return { code: `export default ${JSON.stringify(made.toString('base64'))}`, map: null }
  },
})
