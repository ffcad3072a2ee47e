import { Editor } from '../../edit'
import { useApp } from '../context'

/** Live editing, where there is a server that checks and works out what is edited. */
export function Edit() {
  const { host, engines, put } = useApp()
  const exhibit = engines.value[0]
  if (!host.service || !exhibit) return null
  return <Editor service={host.service} tree={exhibit.file} shown={put} />
}
