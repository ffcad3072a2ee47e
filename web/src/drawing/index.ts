import { drawn } from './drawing'

/** A script of its own, read when the first figure is wanted; `host/drawing.ts` takes it over. */
document.currentScript?.dispatchEvent(new CustomEvent('crankstar', { detail: drawn }))
