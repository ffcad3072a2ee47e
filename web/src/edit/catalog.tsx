import { useId, useRef, useState } from 'preact/hooks'
import type { CatalogEntry } from '../exhibit'
import { t } from '../language/messages'
import { choiceText } from './choices'

/** The entries with every typed word in name, title, layout, cylinders or cycle. */
export function matching(entries: readonly CatalogEntry[], typed: string): CatalogEntry[] {
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean)
  return entries.filter((entry) => {
    const said =
      `${entry.name} ${entry.title} ${entry.layout} ${entry.cylinders} cylinders ${entry.cycle} ${choiceText(entry.layout)} ${choiceText(entry.cycle)}`.toLowerCase()
    return words.every((word) => said.includes(word))
  })
}

interface Props {
  readonly label: string
  readonly entries: readonly CatalogEntry[]
  readonly take: (entry: CatalogEntry) => void
}

/** A box with a list of matching engines; arrow keys choose, Enter takes, Escape closes. */
export function CatalogPicker({ label, entries: all, take: taken }: Props) {
  const [typed, setTyped] = useState('')
  const [open, setOpen] = useState(false)
  const [active, setActive] = useState(0)
  const list = useRef<HTMLDivElement>(null)
  const id = useId()
  const entries = matching(all, typed)
  const at = Math.min(active, entries.length - 1)

  const go = (to: number) => {
    setOpen(true)
    const next = Math.max(0, Math.min(entries.length - 1, to))
    setActive(next)
    list.current?.children[next]?.scrollIntoView({ block: 'nearest' })
  }
  const take = (entry: CatalogEntry | undefined) => {
    if (!entry) return
    setOpen(false)
    setTyped('')
    setActive(0)
    taken(entry)
  }
  const keys: Record<string, () => void> = {
    ArrowDown: () => go(open ? at + 1 : at),
    ArrowUp: () => go(at - 1),
    PageDown: () => go(at + 8),
    PageUp: () => go(at - 8),
    Enter: () => (open ? take(entries[at]) : setOpen(true)),
    Escape: () => (open ? setOpen(false) : setTyped('')),
  }

  return (
    <div class="catalog">
      <label for={`${id}box`}>{label}</label>
      <input
        id={`${id}box`}
        type="text"
        role="combobox"
        aria-expanded={open}
        aria-controls={`${id}list`}
        aria-autocomplete="list"
        aria-activedescendant={open && entries.length ? `${id}option${at}` : undefined}
        placeholder={t('name, layout, number of cylinders')}
        autocomplete="off"
        spellcheck={false}
        value={typed}
        onFocus={() => setOpen(true)}
        onClick={() => setOpen(true)}
        onBlur={() => setOpen(false)}
        onInput={(event) => {
          setTyped(event.currentTarget.value)
          setActive(0)
          setOpen(true)
        }}
        onKeyDown={(event) => {
          const act = keys[event.key]
          if (!act) return
          event.preventDefault()
          event.stopPropagation()
          act()
        }}
      />
      <div
        id={`${id}list`}
        ref={list}
        role="listbox"
        aria-label={t('Engines')}
        class="options"
        hidden={!open}
      >
        {entries.map((entry, place) => (
          <div
            key={entry.name}
            id={`${id}option${place}`}
            role="option"
            tabIndex={-1}
            aria-selected={place === at}
            // The box would lose the focus, and the list close, before the click is over.
            onPointerDown={(event) => event.preventDefault()}
            onClick={() => take(entry)}
            onKeyDown={() => undefined}
          >
            <span class="title">{entry.title}</span>
            <span class="facts">{`${choiceText(entry.layout)}, ${entry.cylinders}, ${choiceText(entry.cycle)}`}</span>
          </div>
        ))}
        {entries.length === 0 && (
          <div class="none">{t('No engine matches. Type fewer words.')}</div>
        )}
      </div>
    </div>
  )
}
