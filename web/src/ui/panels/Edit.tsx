import { Editor } from '../../edit'
import type { Tree } from '../../host/host'
import { message, t } from '../../language/messages'
import { packedTree } from '../../packing'
import { set } from '../../state'
import { useApp } from '../context'
import type { Panel } from '../panel'

export const edit: Panel = {
  key: 'edit',
  label: message('Edit'),
  Content: Edit,
  of: 'all',
  when: ({ host }) => !!host.service,
}

/** Live editing, where a server checks the engine. */
function Edit() {
  const { host, engines, units, store, put } = useApp()
  const exhibit = engines.value[0]
  if (!host.service || !exhibit) return null
  const beside = (tree: Tree): void =>
    void packedTree(tree).then((packed) => set(store.beside, `~${packed}`))
  return (
    <>
      {engines.value.length > 1 && (
        <p class="soft">{t('This form edits {engine}.', { engine: exhibit.name })}</p>
      )}
      <Editor
        beside={beside}
        service={host.service}
        engine={exhibit}
        units={units.value}
        shown={put}
      />
    </>
  )
}
