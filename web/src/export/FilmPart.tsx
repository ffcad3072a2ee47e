import { useSignal } from '@preact/signals'
import { useEffect, useRef } from 'preact/hooks'
import { t } from '../language/messages'
import { set } from '../state'
import { useApp } from '../ui/context'
import { encodable, encoding } from './encoding'
import { filmed, KINDS, type Kind, RATES, type RecorderOf } from './film'
import { gif } from './gif'
import { mp4 } from './mp4'
import { type Ground, pictureName } from './picture'
import type { Running } from './running'
import { webm } from './webm'

/** Seconds of a film: least, greatest. */
const [SHORTEST, LONGEST] = [0.2, 60]
/** Pixels of a frame to one of the page. */
const DENSITY: Readonly<Record<Kind, number>> = { webm: 1.5, mp4: 1.5, gif: 1 }

/** A size at which it is asked what can be written at all. */
const USUAL = { width: 1280, height: 720, perSecond: 30 }
const NAMES = { webm: 'WebM', mp4: 'MP4', gif: 'GIF' } as const satisfies Record<Kind, string>

/** The recorder of a kind for frames of a canvas. Rejects where the browser has none of the size. */
async function recorderOf(kind: Kind, { width, height }: HTMLCanvasElement): Promise<RecorderOf> {
  if (kind === 'gif') return gif
  const codec = await encodable(KINDS[kind], { width, height, perSecond: RATES[kind] })
  if (codec !== undefined) return encoding(codec, kind === 'mp4' ? mp4 : webm)
  throw new Error(t('This browser cannot write a video of this size. Make the window smaller.'))
}

/** A turn of the engine as a film that goes on where it began. */
export function FilmPart({ ground, running }: { ground: Ground; running: Running }) {
  const app = useApp()
  const { clock, store } = app
  const turns = clock.turns.value
  const usual = Math.min(20, Math.max(2, turns / store.pace.peek()))
  const seconds = useSignal(Number(usual.toPrecision(2)))
  const share = useSignal<number | null>(null)
  const filming = useRef<AbortController | null>(null)
  const kinds = useSignal<readonly Kind[]>([])
  useEffect(() => () => filming.current?.abort(), [])
  useEffect(() => {
    const all = Object.keys(KINDS) as Kind[]
    const asked = all.map(async (kind) => kind === 'gif' || (await encodable(KINDS[kind], USUAL)))
    void Promise.all(asked).then((can) =>
      set(
        kinds,
        all.filter((_, index) => can[index]),
      ),
    )
  }, [])
  const wrong = !(seconds.value >= SHORTEST && seconds.value <= LONGEST)

  function begin(kind: Kind): void {
    const controller = new AbortController()
    filming.current = controller
    const perSecond = RATES[kind]
    const frames = Math.max(2, Math.round(seconds.peek() * perSecond))
    const film = { frames, perSecond, ground, density: DENSITY[kind] }
    const recorder = (canvas: HTMLCanvasElement) => recorderOf(kind, canvas)
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
      <h3>{t('One turn as a video')}</h3>
      <div class="buttons">
        {kinds.value.map((kind) => (
          <button
            key={kind}
            type="button"
            disabled={running.busy.value || wrong}
            data-file={kind}
            onClick={() => begin(kind)}
          >
            {NAMES[kind]}
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
          {t('{degrees}° of the crankshaft, after which all repeats: the video has no seam.', {
            degrees: 360 * turns,
          })}
        </span>
      </div>
      {share.value !== null && (
        <div class="buttons">
          <progress value={share.value} max={1} aria-label={t('Recording')} />
          <button type="button" onClick={() => filming.current?.abort()}>
            {t('Cancel')}
          </button>
        </div>
      )}
    </section>
  )
}
