/** A font for mathematics, woff2 as base64, made by build/mathfont.mjs. */
declare module 'virtual:math-font' {
  const font: string
  export default font
}

/** A catalog as i18next reads it: sentences by their English, plural forms by `_one`, `_few` ... */
declare module '*.po' {
  const catalog: () => Readonly<Record<string, string>>
  export default catalog
}
