// The script that draws figures, a plain one of its own: Vega, which the first frame does not need.
import { fileURLToPath } from 'node:url'
import { build } from 'vite'

const path = (name) => fileURLToPath(new URL(name, import.meta.url))
const SCRIPT = 'figures.js'
/** In place of the package: what the figures need of it. */
export const vega = { find: /^vega$/, replacement: path('vega.mjs') }

/** Builds it beside the script of the page; `list` is the file of the packages in it. */
export const figures = (list) => ({
  name: 'figures',
  async generateBundle() {
    const [{ output }] = await build({
      configFile: false,
      root: path('..'),
      logLevel: 'warn',
      resolve: { alias: [vega] },
      build: {
        write: false,
        target: 'es2022',
        lib: {
          entry: path('../src/drawing/index.ts'),
          formats: ['iife'],
          name: 'figures',
          fileName: () => SCRIPT,
        },
        license: { fileName: list },
        rolldownOptions: { output: { minify: true } },
      },
    })
    for (const { fileName, code, source } of output)
      this.emitFile({ type: 'asset', fileName, source: code ?? source })
  },
})
