import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'
import { catalogs } from './build/catalogs.mjs'
import { licences } from './build/licences.mjs'
import { mathFont } from './build/mathfont.mjs'

const PACKAGES = 'packages.json'
const PARTS = fileURLToPath(new URL('build/vega.mjs', import.meta.url))

/**
 * One ES module with everything in it; `?inline` styles are put into it as text and adopted by the
 * shadow-free root.
 */
export default defineConfig({
  resolve: { alias: [{ find: /^vega$/, replacement: PARTS }] },
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
  plugins: [catalogs(), mathFont(), licences(PACKAGES)],
})
