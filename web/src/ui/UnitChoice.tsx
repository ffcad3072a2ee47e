import { useSignal } from '@preact/signals'
import { t } from '../language/messages'
import { set } from '../state'
import { useApp } from './context'

/** The value of the choice that opens a field for others. */
const OTHERS = '...'

/** The units of every number on the page; where any can be had, also those that are typed. */
export function UnitChoice() {
  const { host, store, units } = useApp()
  const typing = useSignal(false)
  const offered = host.exhibition.units ?? []
  const own = offered.some(({ name }) => name === units.value)
  const choices = own ? offered : [...offered, { name: units.value, label: units.value }]
  if (choices.length < 2 && !host.anyUnits) return null
  return (
    <div class="units">
      <select
        aria-label={t('Units')}
        title={t('Units')}
        value={units.value}
        onChange={(event) => {
          const { value } = event.currentTarget
          typing.value = value === OTHERS
          if (value === OTHERS) event.currentTarget.value = units.value
          else set(store.units, value)
        }}
      >
        {choices.map(({ name, label }) => (
          <option key={name} value={name}>
            {label}
          </option>
        ))}
        {host.anyUnits && <option value={OTHERS}>{t('Others …')}</option>}
      </select>
      {typing.value && (
        <form
          onSubmit={(event) => {
            event.preventDefault()
            const text = new FormData(event.currentTarget).get('units')
            typing.value = false
            if (typeof text === 'string' && text.trim()) set(store.units, text.trim())
          }}
        >
          <input
            name="units"
            maxLength={200}
            placeholder="kN, kN m"
            aria-label={t('Units, as in “kN, kN m” or “us, N m”')}
            // biome-ignore lint/a11y/noAutofocus: it was asked for
            autoFocus
          />
        </form>
      )}
    </div>
  )
}
