import { type Signal, useSignal } from '@preact/signals'
import { t } from '../language/messages'
import { reasonOf } from '../reason'
import { set } from '../state'
import { save } from './saving'

/** What the dialog says of the files it makes. */
export interface Running {
  /** What was saved last, or what went wrong. */
  readonly said: Signal<{ text: string; wrong: boolean }>
  /** Whether a file is being made. */
  readonly busy: Signal<boolean>
  /** Makes a file and gives it to the browser under its name. */
  keep(name: string, made: () => Blob | Promise<Blob>): Promise<void>
}

export function useRunning(): Running {
  const said = useSignal({ text: '', wrong: false })
  const busy = useSignal(false)
  return {
    said,
    busy,
    async keep(name, made) {
      if (busy.peek()) return
      set(busy, true)
      set(said, { text: t('Making {file} …', { file: name }), wrong: false })
      try {
        // the words come first: some pictures take a second without a pause
        await new Promise((done) => setTimeout(done))
        save(await made(), name)
        set(said, { text: t('Saved as {file}.', { file: name }), wrong: false })
      } catch (error) {
        const ended = error instanceof DOMException && error.name === 'AbortError'
        set(said, { text: ended ? t('Cancelled.') : reasonOf(error), wrong: !ended })
      } finally {
        set(busy, false)
      }
    },
  }
}
