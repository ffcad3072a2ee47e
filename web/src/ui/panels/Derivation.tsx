import { useSignal } from '@preact/signals'
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks'
import { useApp } from '../context'
import { useVectors, VectorChoice } from '../Vectors'

/** How a textbook would derive the force or the couple of one order of this engine, with the formulas typeset. */
export function Derivation() {
  const { host } = useApp()
  const vectors = useVectors(({ derivations }, quantity) =>
    derivations.filter((one) => one.quantity === quantity).map((one) => one.order),
  )
  const { exhibit, quantity, order } = vectors
  const found = exhibit.derivations.find((one) => one.quantity === quantity && one.order === order)
  const html = useSignal('')
  const trouble = useSignal('')
  const key = found?.key
  const typeset = useRef<HTMLDivElement>(null)
  const text = html.value

  // a formula that is longer than the panel is wide is scrolled with the arrow keys
  useLayoutEffect(() => {
    const lines = text ? (typeset.current?.querySelectorAll<HTMLElement>('.line') ?? []) : []
    const reached = (): void => {
      for (const line of lines) {
        if (line.scrollWidth > line.clientWidth) line.tabIndex = 0
        else line.removeAttribute('tabindex')
      }
    }
    reached()
    const sized = new ResizeObserver(reached)
    if (typeset.current) sized.observe(typeset.current)
    return () => sized.disconnect()
  }, [text])

  useEffect(() => {
    let ended = false
    html.value = ''
    trouble.value = ''
    if (key === undefined) return undefined
    host.derivation(exhibit, key).then(
      (made) => {
        if (!ended) html.value = made
      },
      (error: unknown) => {
        if (!ended) trouble.value = error instanceof Error ? error.message : String(error)
      },
    )
    return () => {
      ended = true
    }
  }, [host, exhibit, key])

  return (
    <>
      <VectorChoice label="Derivation of" vectors={vectors} />
      {trouble.value && <p role="alert">{trouble.value}</p>}
      {!text && !trouble.value && <p class="soft">Deriving …</p>}
      {text && <div class="typeset" ref={typeset} dangerouslySetInnerHTML={{ __html: text }} />}
    </>
  )
}
