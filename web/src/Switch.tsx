import type { ComponentChildren } from 'preact'

interface Props {
  readonly label: ComponentChildren
  readonly on: boolean
  readonly change: (on: boolean) => void
  readonly class?: string
}

/** A box to tick, and what for. */
export function Switch({ label, on, change, class: kind = 'switch' }: Props) {
  return (
    <label class={kind}>
      <input
        type="checkbox"
        checked={on}
        onChange={(event) => change(event.currentTarget.checked)}
      />
      <span>{label}</span>
    </label>
  )
}
