import { useId } from 'preact/hooks'

interface Props<T extends string> {
  readonly label: string
  readonly choices: readonly {
    readonly value: T
    readonly label: string
    readonly disabled?: boolean
  }[]
  readonly value: T
  readonly chosen: (value: T) => void
}

/** One of a few, all of them seen. */
export function Choice<T extends string>({ label, choices, value, chosen }: Props<T>) {
  const id = useId()
  return (
    <fieldset class="choice">
      <legend>{label}</legend>
      <div class="choices">
        {choices.map((choice) => (
          <label key={choice.value} class={choice.value === value ? 'chosen' : ''}>
            <input
              type="radio"
              name={id}
              value={choice.value}
              checked={choice.value === value}
              disabled={choice.disabled ?? false}
              onChange={() => chosen(choice.value)}
            />
            <span>{choice.label}</span>
          </label>
        ))}
      </div>
    </fieldset>
  )
}
