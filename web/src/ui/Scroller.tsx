import { useSignal } from '@preact/signals'
import type { ComponentChildren } from 'preact'
import { useEffect, useRef } from 'preact/hooks'
import { t } from '../language/messages'

/** What may be too wide: then it scrolls sideways by itself, says so, and fades where more is. */
export function Scroller({
  label,
  hint = t('The table scrolls sideways'),
  children,
}: {
  label: string
  hint?: string
  children: ComponentChildren
}) {
  const inside = useRef<HTMLDivElement>(null)
  const [before, after] = [useSignal(false), useSignal(false)]
  useEffect(() => {
    const box = inside.current
    if (!box) return undefined
    const looked = (): void => {
      before.value = box.scrollLeft > 1
      after.value = box.scrollLeft + box.clientWidth < box.scrollWidth - 1
    }
    const sized = new ResizeObserver(looked)
    sized.observe(box)
    for (const child of box.children) sized.observe(child)
    box.addEventListener('scroll', looked, { passive: true })
    return () => {
      sized.disconnect()
      box.removeEventListener('scroll', looked)
    }
  }, [])
  const wide = before.value || after.value
  return (
    <div class={`scroller${before.value ? ' before' : ''}${after.value ? ' after' : ''}`}>
      {wide && <p class="sideways">{hint} ↔</p>}
      {/* biome-ignore lint/a11y/useSemanticElements: a fieldset is for what is filled in */}
      <div
        role="group"
        class="scroll"
        ref={inside}
        aria-label={label}
        // what scrolls is reached by keys
        {...(wide && { tabIndex: 0 })}
      >
        {children}
      </div>
    </div>
  )
}
