import { useSignal } from '@preact/signals'
import { useEffect } from 'preact/hooks'
import { Choice } from '../Choice'
import { useApp, useExhibit } from '../context'
import { orderText } from '../OrderChoice'
import { orderShown } from './Stars'

/** How a textbook would derive the force or the couple of one order of this engine, with the formulas typeset. */
export function Derivation() {
  const { host, store, quantity: told } = useApp()
  const exhibit = useExhibit()
  const quantity = told.value === 'couple' ? 'couple' : 'force'
  const orders = exhibit.derivations.filter((one) => one.quantity === quantity).map((one) => one.order)
  const order = orderShown(exhibit, orders, store.orders.value, quantity)
  const found = exhibit.derivations.find((one) => one.quantity === quantity && one.order === order)
  const html = useSignal('')
  const trouble = useSignal('')
  const key = found?.key

  useEffect(() => {
    let ended = false
    html.value = ''
    trouble.value = ''
    if (key === undefined) return undefined
    host.derivation(exhibit, key).then(
      (text) => {
        if (!ended) html.value = text
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
      <div class="controls">
        <Choice
          label="Derivation of"
          value={quantity}
          choices={[
            { value: 'force', label: 'force' },
            { value: 'couple', label: 'couple' },
          ]}
          chosen={(value) => {
            store.quantity.value = value
          }}
        />
        <Choice
          label="Order"
          value={String(order)}
          choices={orders.map((one) => ({ value: String(one), label: orderText(exhibit, one) }))}
          chosen={(value) => {
            store.orders.value = [Number(value)]
          }}
        />
      </div>
      {trouble.value && <p role="alert">{trouble.value}</p>}
      {!html.value && !trouble.value && <p class="soft">Deriving …</p>}
      {html.value && <div class="typeset" dangerouslySetInnerHTML={{ __html: html.value }} />}
    </>
  )
}
