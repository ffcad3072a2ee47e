import { defineConfig } from 'vite'

/** One ES module with everything in it; `?inline` styles are put into it as text and adopted by the shadow-free root. */
export default defineConfig({
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  build: {
    outDir: '../src/crankstar/bundle',
    emptyOutDir: true,
    target: 'es2022',
    lib: { entry: 'src/index.tsx', formats: ['es'], fileName: () => 'crankstar.js' },
  },
  define: { 'process.env.NODE_ENV': '"production"' },
})
