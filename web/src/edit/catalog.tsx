import { useId, useRef, useState } from 'preact/hooks'
import type { CatalogEntry } from '../host/host'
import { useSession } from './context'

/** The entries that hold every word that was typed, in name, title, layout, number of cylinders or cycle. */
export function matching(entries: readonly CatalogEntry[], typed: string): CatalogEntry[] {
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean)
  return entries.filter((entry) => {
    const said =
      `${entry.name} ${entry.title} ${entry.layout} ${entry.cylinders} cylinders ${entry.cycle}`.toLowerCase()
    return words.every((word) =>
      /^\d+$/.test(word) ? said.split(/[^a-z0-9]+/).includes(word) || said.includes(word) : said.includes(word),
    )
  })
}

/** The catalog as a box to type in with a list of what fits; arrow keys choose, Enter takes, Escape closes. */
export function CatalogPicker() {
  const session = useSession()
  const [typed, setTyped] = useState('')
  const [open, setOpen] = useState(false)
  const [active, setActive] = useState(0)
  const list = useRef<HTMLDivElement>(null)
  const id = useId()
  const entries = matching(session.catalog.value, typed)
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
    void session.open(session.service.engine(entry.name), entry.title)
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
      <label for={`${id}box`}>Engine of the catalog</label>
      <input
        id={`${id}box`}
        type="text"
        role="combobox"
        aria-expanded={open}
        aria-controls={`${id}list`}
        aria-autocomplete="list"
        aria-activedescendant={open && entries.length ? `${id}option${at}` : undefined}
        placeholder="search: v8, radial, two-stroke, 5 ..."
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
      <div id={`${id}list`} ref={list} role="listbox" aria-label="Engines" class="options" hidden={!open}>
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
            <span class="facts">{`${entry.layout}, ${entry.cylinders} cyl., ${entry.cycle}`}</span>
          </div>
        ))}
        {entries.length === 0 && <div class="none">No engine fits. Type fewer words.</div>}
      </div>
    </div>
  )
}
