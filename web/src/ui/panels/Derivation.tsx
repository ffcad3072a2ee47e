import { useSignal } from '@preact/signals'
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks'
import { message, t } from '../../language/messages'
import { reasonOf } from '../../reason'
import { useApp } from '../context'
import type { Panel } from '../panel'
import { useVectors, VectorChoice } from '../Vectors'

export const derivation: Panel = {
  key: 'derivation',
  label: message('Derivation'),
  Content: Derivation,
  when: ({ shown, subject }) => (shown.value[subject.value]?.derivations.length ?? 0) > 0,
}

/** The derivation of the force or couple of one order, typeset. */
function Derivation() {
  const { host } = useApp()
  const vectors = useVectors(({ derivations }, quantity) =>
    derivations.filter((each) => each.quantity === quantity).map(({ order }) => order),
  )
  const { exhibit, quantity, order } = vectors
  const key = exhibit.derivations.find(
    (each) => each.quantity === quantity && each.order === order,
  )?.key
  const html = useSignal('')
  const trouble = useSignal('')
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
        if (!ended) trouble.value = reasonOf(error)
      },
    )
    return () => {
      ended = true
    }
  }, [host, exhibit, key])

  return (
    <>
      <VectorChoice label={t('Derivation of')} vectors={vectors} />
      {trouble.value && <p role="alert">{trouble.value}</p>}
      {!text && !trouble.value && <p class="soft">{t('Deriving …')}</p>}
      {text && <div class="typeset" ref={typeset} dangerouslySetInnerHTML={{ __html: text }} />}
    </>
  )
}
