import { useCallback, useEffect, useRef } from 'preact/hooks'
import { EditAnywhere, editStyle } from '../edit'
import { set } from '../state'
import { useApp } from './context'
import { adopt } from './sheets'

/** What editing needs whichever tab is open, where there is a server that edits. */
export function Editing() {
  const { host, engines, put, store, slips } = useApp()
  const place = useRef<HTMLDivElement>(null)
  useEffect(() => (place.current ? adopt(place.current, [editStyle]) : undefined), [])
  const opens = useCallback(() => set(store.tab, 'edit'), [store])
  const told = useCallback((count: number) => set(slips, count), [slips])
  const exhibit = engines.value[0]
  if (!host.service || !exhibit) return null
  return (
    <div ref={place}>
      <EditAnywhere
        service={host.service}
        engine={exhibit}
        shown={put}
        opens={opens}
        slips={told}
      />
    </div>
  )
}
