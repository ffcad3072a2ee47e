import { useEffect, useRef, useState } from 'preact/hooks'
import { t } from '../language/messages'
import { useSession } from './context'
import { answered, type Session } from './session'

/** Bytes of a file that is read at all; the server takes no more. */
const LARGEST = 1_000_000

/** A name for the file of an engine: letters, digits and dashes of its name. */
export function fileName(name: unknown): string {
  const plain = String(name ?? '')
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 60)
  return `${plain || 'engine'}.toml`
}

/** Opens an engine file that was chosen or dropped. */
export async function openFile(session: Session, file: File): Promise<void> {
  const name = file.name.slice(0, 80)
  if (file.size > LARGEST) {
    session.note.value = t('{file} is too large. An engine file has at most 1 MB.', { file: name })
    return
  }
  await session.open(
    file.text().then((text) => session.service.read(text)),
    name,
  )
}

async function save(session: Session): Promise<void> {
  const tree = session.tree.value
  const answer = await answered(session.service.toml(tree))
  if (!answer.ok) {
    session.note.value = t('The engine was not saved. Correct the marked mistakes first.')
    return
  }
  const address = URL.createObjectURL(new Blob([answer.value], { type: 'application/toml' }))
  const link = document.createElement('a')
  link.href = address
  link.download = fileName(tree.name)
  link.click()
  // The download reads the address after this call has returned.
  setTimeout(() => URL.revokeObjectURL(address), 10_000)
  session.note.value = t('Saved as {file}.', { file: link.download })
}

/** Open and save. */
export function FileButtons() {
  const session = useSession()
  const chooser = useRef<HTMLInputElement>(null)
  return (
    <>
      <button type="button" onClick={() => chooser.current?.click()}>
        {t('Open …')}
      </button>
      <input
        ref={chooser}
        type="file"
        class="unseen"
        accept=".toml,.json,application/toml,application/json"
        aria-label={t('Engine file to open')}
        tabIndex={-1}
        onChange={(event) => {
          const file = event.currentTarget.files?.[0]
          if (file) void openFile(session, file)
          event.currentTarget.value = ''
        }}
      />
      <button type="button" onClick={() => void save(session)}>
        {t('Save as TOML')}
      </button>
    </>
  )
}

/** Opens an engine file that is dropped anywhere on the page. */
export function DropZone({ opens }: { opens: () => void }) {
  const session = useSession()
  const [over, setOver] = useState(false)
  useEffect(() => {
    let depth = 0
    const files = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false
    const enter = (event: DragEvent) => {
      if (!files(event)) return
      event.preventDefault()
      depth += 1
      setOver(true)
    }
    const leave = () => {
      depth = Math.max(0, depth - 1)
      if (!depth) setOver(false)
    }
    const stay = (event: DragEvent) => files(event) && event.preventDefault()
    const drop = (event: DragEvent) => {
      if (!files(event)) return
      event.preventDefault()
      depth = 0
      setOver(false)
      const file = event.dataTransfer?.files[0]
      if (!file) return
      opens()
      void openFile(session, file)
    }
    const ends = new AbortController()
    const { signal } = ends
    document.addEventListener('dragenter', enter, { signal })
    document.addEventListener('dragleave', leave, { signal })
    document.addEventListener('dragover', stay, { signal })
    document.addEventListener('drop', drop, { signal })
    return () => ends.abort()
  }, [session, opens])
  return over ? (
    <div class="edit-dropzone">{t('Drop an engine file (TOML or JSON) to open it')}</div>
  ) : null
}
