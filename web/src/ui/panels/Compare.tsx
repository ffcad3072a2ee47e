import { useSignal } from '@preact/signals'
import { useEffect } from 'preact/hooks'
import { CatalogPicker } from '../../edit/catalog'
import type { CatalogEntry } from '../../exhibit'
import { message, t } from '../../language/messages'
import { reasonOf } from '../../reason'
import { Switch } from '../../Switch'
import { set } from '../../state'
import { BothOrders } from '../BothOrders'
import { useApp } from '../context'
import type { Panel } from '../panel'

export const compare: Panel = {
  key: 'compare',
  label: message('Compare'),
  Content: Compare,
  of: 'all',
  when: ({ host }) => !!host.service || host.exhibition.engines.length > 1,
}

/** A second engine at the same crank angle, and the orders of both. */
function Compare() {
  const { host, shown, store } = useApp()
  const [one, other] = shown.value
  const second = other !== undefined || host.exhibition.engines.length > 1
  return (
    <>
      {second && (
        <Switch
          label={t('Show both engines')}
          on={store.beside.value !== '0'}
          change={(on) => set(store.beside, on ? '' : '0')}
        />
      )}
      {host.service && <Picker />}
      {one && other ? (
        <BothOrders one={one} other={other} />
      ) : (
        <p class="soft">{t('Choose a second engine.')}</p>
      )}
    </>
  )
}

/** A second engine from the catalog. */
function Picker() {
  const { host, store, trouble } = useApp()
  const entries = useSignal<readonly CatalogEntry[]>([])
  useEffect(() => {
    host.service?.catalog().then(
      (catalog) => set(entries, catalog),
      (error: unknown) => set(trouble, reasonOf(error)),
    )
  }, [host])
  return (
    <CatalogPicker
      label={t('Compare with')}
      entries={entries.value}
      take={({ name }) => set(store.beside, name)}
    />
  )
}
