import { defineConfig } from 'vite'
import { catalogs } from './build/catalogs.mjs'
import { figures, vega } from './build/figures.mjs'
import { licences } from './build/licences.mjs'
import { mathFont } from './build/mathfont.mjs'

const PACKAGES = 'packages.json'
const FIGURES = 'packages-of-figures.json'

/**
 * One ES module with everything in it but what draws figures, which is a plain script beside it;
 * `?inline` styles are put into it as text and adopted by the shadow-free root.
 */
export default defineConfig({
  resolve: { alias: [vega] },
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  build: {
    outDir: '../src/crankstar/bundle',
    emptyOutDir: true,
    target: 'es2022',
    lib: { entry: 'src/index.tsx', formats: ['es'], fileName: () => 'crankstar.js' },
    license: { fileName: PACKAGES },
    rolldownOptions: { output: { minify: true } }, // of a library vite leaves the white space
  },
  define: { 'process.env.NODE_ENV': '"production"' },
  plugins: [catalogs(), mathFont(), figures(FIGURES), licences([PACKAGES, FIGURES])],
})
