import { packedTree } from '../deflated'
import { matches, type Wanted } from './filter'

/** Bytes of a file that is read at all; the server takes no more. */
const LARGEST = 1_000_000
const FILTERS = ['words', 'layout', 'cylinders'] as const

/** Hides the engines that are not wanted; what is wanted stands in the address. */
function filtered(form: HTMLFormElement): void {
  const cards = [...document.querySelectorAll<HTMLElement>('.cards > li')]
  const none = document.querySelector<HTMLElement>('.none')
  const count = form.querySelector('output')
  const field = (name: string) =>
    form.elements.namedItem(name) as HTMLInputElement | HTMLSelectElement
  const given = new URLSearchParams(location.hash.slice(1))
  for (const name of FILTERS) field(name).value = given.get(name) ?? ''
  const show = () => {
    const wanted = Object.fromEntries(FILTERS.map((name) => [name, field(name).value]))
    let left = 0
    for (const card of cards) {
      const { words = '', layout = '', cylinders = '' } = card.dataset
      card.hidden = !matches({ words, layout, cylinders }, wanted as unknown as Wanted)
      if (!card.hidden) left += 1
    }
    if (none) none.hidden = left > 0
    if (count) count.textContent = left < cards.length ? `${left} / ${cards.length}` : `${left}`
    const asked = new URLSearchParams(FILTERS.flatMap((n) => (wanted[n] ? [[n, wanted[n]]] : [])))
    const hash = `${asked}`
    history.replaceState(null, '', `${location.pathname}${location.search}${hash && `#${hash}`}`)
  }
  form.addEventListener('input', show)
  form.addEventListener('submit', (event) => event.preventDefault())
  form.hidden = false
  show()
}

/** Lets pictures turn once they are seen, unless the system asks for less motion. */
function turning(): void {
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) return
  const dark = matchMedia('(prefers-color-scheme: dark)')
  const waiting: HTMLElement[] = []
  let busy = 0
  // few at a time, so that an engine that is chosen meanwhile need not wait
  const next = () => {
    while (busy < 2) {
      const picture = waiting.shift()
      if (!picture) return
      const image = picture.querySelector('img')
      const source = picture.querySelector('source')
      const from = dark.matches ? source : image
      const address = from?.dataset.turning
      if (!image || !source || !address) continue
      const film = new Image()
      busy += 1
      film.onload = film.onerror = (event) => {
        busy -= 1
        if ((event as Event).type === 'load') {
          source.srcset = source.dataset.turning ?? ''
          image.src = image.dataset.turning ?? ''
        }
        next()
      }
      film.src = address
    }
  }
  const seen = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue
      seen.unobserve(target)
      waiting.push(target as HTMLElement)
    }
    next()
  })
  for (const card of document.querySelectorAll('.cards > li')) seen.observe(card)
}

/** Pictures change with the colours of the system also where they were loaded in others. */
function recoloured(): void {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    for (const image of document.querySelectorAll<HTMLImageElement>('.cards img'))
      image.src = image.getAttribute('src') ?? ''
  })
}

interface Problem {
  readonly path: string
  readonly message: string
}

/** Opens an engine file on the page of the server, or says what is wrong with it. */
async function opened(file: File): Promise<void> {
  const problems = await read(file).catch((error: unknown) => [
    { path: '', message: error instanceof Error ? error.message : String(error) },
  ])
  const box = document.querySelector<HTMLElement>('.mistakes')
  if (!box || !problems.length) return
  const head = document.createElement('h2')
  head.textContent = file.name.slice(0, 80)
  const list = document.createElement('ul')
  for (const { message } of problems) {
    const item = document.createElement('li')
    item.textContent = message
    list.append(item)
  }
  box.replaceChildren(head, list)
  box.hidden = false
  box.scrollIntoView({ block: 'center' })
}

/** The faults of a file; none, and on to its page, where it is an engine. */
async function read(file: File): Promise<readonly Problem[]> {
  if (file.size > LARGEST) return [{ path: '', message: '> 1 MB' }]
  const response = await fetch('/api/read', {
    method: 'POST',
    headers: { 'Content-Type': 'application/json' },
    body: JSON.stringify({ text: await file.text() }),
  })
  const answer = (await response.json()) as {
    tree?: Record<string, unknown>
    problems?: readonly Problem[]
  }
  if (!answer.tree) return answer.problems ?? [{ path: '', message: `HTTP ${response.status}` }]
  location.href = `/#engine=~${await packedTree(answer.tree)}`
  return []
}

/** Files are chosen with a button, or dropped anywhere. */
function openable(form: HTMLFormElement): void {
  const chooser = form.querySelector<HTMLInputElement>('input[type=file]')
  form.querySelector('button')?.addEventListener('click', () => chooser?.click())
  chooser?.addEventListener('change', () => {
    const file = chooser.files?.[0]
    if (file) void opened(file)
    chooser.value = ''
  })
  const holds = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false
  const mark = (on: boolean) => document.body.classList.toggle('dropping', on)
  document.addEventListener('dragover', (event) => {
    if (!holds(event)) return
    event.preventDefault()
    mark(true)
  })
  document.addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) mark(false)
  })
  document.addEventListener('drop', (event) => {
    if (!holds(event)) return
    event.preventDefault()
    mark(false)
    const file = event.dataTransfer?.files[0]
    if (file) void opened(file)
  })
}

const form = document.querySelector<HTMLFormElement>('form.filters')
if (form) {
  filtered(form)
  recoloured()
  if ('live' in document.body.dataset) {
    openable(form)
    turning()
  }
}
