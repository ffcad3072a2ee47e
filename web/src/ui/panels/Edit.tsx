import { useEffect, useRef } from 'preact/hooks'
import { Editor, editStyle } from '../../edit'
import { useApp } from '../context'
import { adopt } from '../sheets'

/** Live editing, where there is a server that checks and works out what is edited. */
export function Edit() {
  const { host, engines, put } = useApp()
  const place = useRef<HTMLDivElement>(null)
  useEffect(() => (place.current ? adopt(place.current, [editStyle]) : undefined), [])
  const exhibit = engines.value[0]
  if (!host.service || !exhibit) return null
  return (
    <div ref={place}>
      <Editor service={host.service} tree={exhibit.file} shown={put} />
    </div>
  )
}
