import { useSignal } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import { t } from '../language/messages'
import { set } from '../state'
import { useApp } from '../ui/context'
import { filmed, type Kind, kinds, RATES, recordable } from './film'
import { gif } from './gif'
import { type Ground, pictureName } from './picture'
import { recording } from './recording'
import type { Running } from './running'

/** Seconds of a film: least, greatest. */
const [SHORTEST, LONGEST] = [0.2, 60]
/** Pixels of a frame to one of the page. */
const DENSITY: Readonly<Record<Kind, number>> = { webm: 1.5, mp4: 1.5, gif: 1 }

/** A turn of the engine as a film that goes on where it began. */
export function FilmPart({ ground, running }: { ground: Ground; running: Running }) {
  const app = useApp()
  const { clock, store } = app
  const turns = clock.turns.value
  const usual = Math.min(20, Math.max(2, turns / store.pace.peek()))
  const seconds = useSignal(Number(usual.toPrecision(2)))
  const share = useSignal<number | null>(null)
  const filming = useRef<AbortController | null>(null)
  useEffect(() => () => filming.current?.abort(), [])
  const wrong = !(seconds.value >= SHORTEST && seconds.value <= LONGEST)

  function begin(kind: Kind): void {
    const controller = new AbortController()
    filming.current = controller
    const perSecond = RATES[kind]
    const frames = Math.max(2, Math.round(seconds.peek() * perSecond))
    const film = { frames, perSecond, ground, density: DENSITY[kind] }
    const type = recordable(kind)
    const recorder = type === undefined ? gif : recording(type)
    const told = (done: number): void => set(share, done)
    set(share, 0)
    void running
      .keep(pictureName(app, kind, 'turn'), () =>
        filmed(app, film, recorder, told, controller.signal),
      )
      .finally(() => set(share, null))
  }

  return (
    <section>
      <h3>{t('One turn as a film')}</h3>
      <div class="buttons">
        {kinds().map((kind) => (
          <button
            key={kind}
            type="button"
            disabled={running.busy.value || wrong}
            data-file={kind}
            onClick={() => begin(kind)}
          >
            {kind === 'gif' ? 'GIF' : kind === 'mp4' ? 'MP4' : 'WebM'}
          </button>
        ))}
        <label>
          <span>{t('Seconds')}</span>
          <input
            type="number"
            min={SHORTEST}
            max={LONGEST}
            step="any"
            value={seconds.value}
            aria-invalid={wrong}
            onInput={(event) => set(seconds, event.currentTarget.valueAsNumber)}
          />
        </label>
        <span class="soft small">
          {t('{degrees}° of the crankshaft, after which all repeats: the film has no seam.', {
            degrees: 360 * turns,
          })}
        </span>
      </div>
      {share.value !== null && (
        <div class="buttons">
          <progress value={share.value} max={1} aria-label={t('Filming')} />
          <button type="button" onClick={() => filming.current?.abort()}>
            {t('Cancel')}
          </button>
        </div>
      )}
    </section>
  )
}
