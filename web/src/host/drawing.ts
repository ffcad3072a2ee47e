import { bytesOf } from '../base64'
import { inflated } from '../deflated'
import type { drawn } from '../drawing/drawing'
import { t } from '../language/messages'

/** What draws figures: a script of its own, a third of all, which the first frame does not need. */
export type Draw = typeof drawn

/** The script that draws figures: its text, or its address. */
export type DrawingScript = { readonly text: string } | { readonly address: string }

/** What draws figures, kept once it is there; where it cannot be had, it is asked for again. */
export function drawing(script: () => Promise<DrawingScript>): () => Promise<Draw> {
  let kept: Promise<Draw> | null = null
  return () => {
    if (kept) return kept
    const asked = script()
      .then(handedOver)
      .catch(() => {
        kept = null
        throw new Error(t('The script that draws figures cannot be read.'))
      })
    kept = asked
    return asked
  }
}

/** Runs the script, which hands over what draws figures in an event on its own element. */
function handedOver(script: DrawingScript): Promise<Draw> {
  const element = document.createElement('script')
  const draw = new Promise<Draw>((resolve, reject) => {
    element.addEventListener('crankstar', (event) => resolve((event as CustomEvent<Draw>).detail))
    element.addEventListener('error', reject)
    element.addEventListener('load', reject) // it ran, and handed nothing over
    if ('address' in script) element.src = script.address
    else element.textContent = script.text
    document.body.append(element)
    if ('text' in script) reject(new Error('It ran as it was put in, or was not allowed to.'))
  })
  return draw.finally(() => element.remove())
}

/** The script as a page names or holds it. */
export async function ofPage(holder: Document): Promise<DrawingScript> {
  const address = holder.querySelector<HTMLElement>('[data-crankstar]')?.dataset.figures
  if (address) return { address }
  const packed = holder.getElementById('crankstar-figures')?.textContent ?? ''
  return { text: await inflated(bytesOf(packed)) }
}
