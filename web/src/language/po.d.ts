/** A catalog as i18next reads it: sentences by their English, plural forms by `_one`, `_few` ... */
declare module '*.po' {
  const catalog: Readonly<Record<string, string>>
  export default catalog
}
