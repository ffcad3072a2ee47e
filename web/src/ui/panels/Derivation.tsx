import { useSignal } from '@preact/signals'
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks'
import { counted } from '../../activity'
import { message, t } from '../../language/messages'
import { reasonOf } from '../../reason'
import { useApp, useExhibit } from '../context'
import { Each } from '../Each'
import { loadMathFont } from '../mathFont'
import type { Panel } from '../panel'
import { useVectors, VectorChoice } from '../Vectors'

export const derivation: Panel = {
  key: 'derivation',
  label: message('Derivation'),
  Content: Derivation,
  when: ({ shown, subjects }) =>
    subjects.value.some((place) => (shown.value[place]?.derivations.length ?? 0) > 0),
}

/** The derivation of the force or couple of one order. */
function Derivation() {
  return (
    <>
      <VectorChoice label={t('Derivation of')} vectors={useDerived()} />
      <Each Part={Typeset} />
    </>
  )
}

function useDerived() {
  return useVectors(({ derivations }, quantity) =>
    derivations.filter((each) => each.quantity === quantity).map(({ order }) => order),
  )
}

/** That of one engine, typeset. */
function Typeset() {
  const { host } = useApp()
  const { quantity, order } = useDerived()
  const exhibit = useExhibit()
  const key = exhibit.derivations.find(
    (each) => each.quantity === quantity && each.order === order,
  )?.key
  const html = useSignal('')
  const trouble = useSignal('')
  const typeset = useRef<HTMLDivElement>(null)
  const text = html.value

  useEffect(() => void loadMathFont(), [])

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
    counted(host.derivation(exhibit, key)).then(
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
      {key === undefined && (
        <p class="soft">{t('There is no derivation of this order for this engine.')}</p>
      )}
      {trouble.value && <p role="alert">{trouble.value}</p>}
      {key !== undefined && !text && !trouble.value && <p class="soft">{t('Deriving …')}</p>}
      {text && <div class="typeset" ref={typeset} dangerouslySetInnerHTML={{ __html: text }} />}
    </>
  )
}
