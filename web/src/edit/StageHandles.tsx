import { useEffect, useRef, useState } from 'preact/hooks'
import type { Control } from '../exhibit'
import type { Reading } from '../stage/stage'
import { useSession } from './context'
import { type Handle, handleAt } from './stageDrag'

/** Pixels that a press may move and be a click. */
const STILL = 4

interface Held extends HTMLElement {
  crankstar?: { read(): Reading }
}

/** Lets banks be dragged on the front view and weights on the side view while one edits. */
export function StageHandles({ controls }: { controls: readonly Control[] }) {
  const session = useSession()
  const [told, setTold] = useState<{ text: string; x: number; y: number } | null>(null)
  // an answer of the server that brings others while something is held does not end the drag
  const latest = useRef(controls)
  latest.current = controls
  useEffect(() => {
    const holder = document.querySelector<Held>('[data-crankstar]')
    const canvas = holder?.querySelector<HTMLElement>('.stage .canvas')
    if (!holder?.crankstar || !canvas) return undefined
    const page = holder.crankstar
    let handle: Handle | null = null
    let from: { x: number; y: number } | null = null
    const at = (event: PointerEvent): Handle | null => {
      const { scene } = session
      if (!scene || event.pointerType === 'touch') return null
      const box = canvas.getBoundingClientRect()
      const { panes } = page.read()
      const grip = { panes, scene, controls: latest.current, session }
      return handleAt(grip, event.clientX - box.left, event.clientY - box.top)
    }
    const pressed = (event: PointerEvent): void => {
      handle = event.button === 0 ? at(event) : null
      from = { x: event.clientX, y: event.clientY }
      if (handle) canvas.setPointerCapture(event.pointerId)
    }
    const over = (event: PointerEvent): void => {
      if (!handle) {
        canvas.style.cursor = event.buttons === 0 && at(event) ? 'grab' : ''
        return
      }
      // a click that trembles is a click
      if (from && Math.hypot(event.clientX - from.x, event.clientY - from.y) < STILL) return
      from = null
      const box = canvas.getBoundingClientRect()
      const fine = event.shiftKey || event.altKey
      const text = handle.follow(event.clientX - box.left, event.clientY - box.top, fine)
      canvas.style.cursor = 'grabbing'
      setTold({ text, x: event.clientX, y: event.clientY })
    }
    const left = (): void => {
      if (!handle) return
      handle = null
      canvas.style.cursor = ''
      setTold(null)
      session.rest()
    }
    canvas.addEventListener('pointerdown', pressed)
    canvas.addEventListener('pointermove', over)
    canvas.addEventListener('pointerup', left)
    canvas.addEventListener('pointercancel', left)
    return () => {
      left()
      canvas.style.cursor = ''
      canvas.removeEventListener('pointerdown', pressed)
      canvas.removeEventListener('pointermove', over)
      canvas.removeEventListener('pointerup', left)
      canvas.removeEventListener('pointercancel', left)
    }
  }, [session])
  if (!told) return null
  return (
    <output class="stage-readout" style={{ left: `${told.x + 14}px`, top: `${told.y - 30}px` }}>
      {told.text}
    </output>
  )
}
