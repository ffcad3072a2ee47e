import font from 'virtual:math-font'
import { counted } from '../activity'
import { bytesOf } from '../base64'

/** The family of the font in which formulas are set. */
const FAMILY = 'crankstar math'
let wanted: Promise<unknown> | null = null

/** Has formulas set in the font that travels with the page, from the first time that one is shown. */
export function loadMathFont(): Promise<unknown> {
  // from bytes, not from an address: no policy of a page has to allow it
  wanted ??= counted(
    new FontFace(FAMILY, bytesOf(font)).load().then((face) => document.fonts.add(face)),
  )
  return wanted
}
