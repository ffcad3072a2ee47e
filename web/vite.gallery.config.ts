import { defineConfig } from 'vite'

/** The script of the gallery: a plain one, which also runs where a page is opened from disk. */
export default defineConfig({
  build: {
    emptyOutDir: false,
    target: 'es2022',
    lib: {
      entry: 'src/gallery/index.ts',
      formats: ['iife'],
      name: 'gallery',
      fileName: () => 'gallery.js',
    },
    rolldownOptions: { output: { minify: true } },
  },
})
