import { useSignal } from '@preact/signals'
import { t } from '../language/messages'
import { set } from '../state'

/** Milliseconds for which it says that it has copied. */
const SAID = 3000

/** Copies a text; where the browser forbids that, the text can be marked where it stands. */
export function CopyButton({ text, label }: { text: string; label?: string }) {
  const done = useSignal('')
  async function copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(text)
      done.value = t('Copied')
    } catch {
      done.value = t('Mark and copy it')
    }
    setTimeout(() => set(done, ''), SAID)
  }
  return (
    <button type="button" aria-label={label} onClick={() => void copy()}>
      {done.value || t('Copy')}
    </button>
  )
}
