// The licences of the packages in the bundle, in a file beside it and, for the page, in it.
import { fontLicence } from './mathfont.mjs'

const FILE = 'third-party-licences.txt'
/** The text in ui/notices.ts that the licences take the place of. */
const PLACE = /(["'`])THIRD_PARTY_NOTICES\1/g

/** Each licence once, below the names of its packages. */
function notices(packages) {
  const users = Map.groupBy(packages, ({ name, text }) => {
    if (!text) throw new Error(`The package ${name} has no licence file.`)
    return text.replaceAll('\r', '')
  })
  return [...users]
    .map(([text, by]) => {
      const names = by.map(({ name, version, identifier }) => `${name} ${version} (${identifier})`)
      return `${names.join('\n')}\n\n${text}\n`
    })
    .join(`\n${'-'.repeat(72)}\n\n`)
}

/** Follows `build.license` of vite, which lists the packages that are in a script. */
export const licences = (lists) => ({
  name: 'licences',
  generateBundle: {
    order: 'post',
    handler(_, bundle) {
      const packages = new Map([['the font', fontLicence()]])
      for (const list of lists) {
        for (const each of JSON.parse(bundle[list].source))
          packages.set(`${each.name} ${each.version}`, each)
        delete bundle[list]
      }
      const text = notices([...packages.values()])
      this.emitFile({ type: 'asset', fileName: FILE, source: text })
      const [page, ...others] = Object.values(bundle).filter(({ code }) => code?.match(PLACE))
      if (page?.code.match(PLACE)?.length !== 1 || others.length)
        throw new Error('no one place for the licences')
      page.code = page.code.replace(PLACE, () => `String.raw\`${text.replaceAll('`', "'")}\``)
    },
  },
})
