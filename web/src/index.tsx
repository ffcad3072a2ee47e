import { render as draw } from 'preact'
import { revision, settled } from './activity'
import { type App, createApp } from './app'
import type { Exhibit } from './exhibit'
import type { Host } from './host/host'
import { pageHost } from './host/page'
import { serverHost } from './host/server'
import { linked, type Model, widgetHost } from './host/widget'
import { reasonOf } from './reason'
import type { Reading, Stage } from './stage/stage'
import { type State, snapshot } from './state'
import { Shared } from './ui/context'
import { Page } from './ui/Page'
import { adopt } from './ui/sheets'

/** What scripts and tests may ask of the element that holds the page, as `element.crankstar`. */
export interface Handle {
  /** Resolves when the first frame has been drawn; rejects with what went wrong. */
  readonly ready: Promise<void>
  /** The state as in a link, without the angle while the engine turns. */
  readonly state: State
  /** Crank angle in degrees within the cycle; setting it stops the engine there. */
  theta: number
  readonly playing: boolean
  play(): void
  stop(): void
  /** The engines on the stage. */
  readonly exhibits: readonly Exhibit[]
  /** Where the parts of an engine stand, after everything has been drawn at the present angle. */
  read(index?: number): Reading
  /**
   * How much the pages of this document have begun: requests, figures, formulas and frames at rest,
   * and what waits for a rest, as the address does. What never ends does not count: polls of the
   * server, and frames of an engine that turns.
   */
  readonly revision: number
  /**
   * Resolves with the revision at which nothing is pending: all that was begun is drawn, fonts are
   * there and transitions over. What waits for a rest is done at once, unless an engine turns.
   */
  settled(): Promise<number>
  /** Milliseconds of script that each of the last frames took, figures included; at most 600. */
  frameTimes(): number[]
  /** How the stage draws. */
  readonly means: Stage['means'] | null
}

export interface Holder extends HTMLElement {
  crankstar?: Handle
}

/** Whether the browser still loads fonts, or moves something that comes to an end. */
const changing = (): boolean =>
  document.fonts.status === 'loading' ||
  document
    .getAnimations()
    .some(
      ({ playState, effect }) =>
        playState === 'running' && effect?.getComputedTiming().endTime !== Number.POSITIVE_INFINITY,
    )

function handleOf(
  ready: Promise<void>,
  app: () => App | null,
  stages: ReadonlyMap<number, Stage>,
): Handle {
  const there = (): App => {
    const its = app()
    if (!its) throw new Error('The page is not ready: await element.crankstar.ready')
    return its
  }
  return {
    ready,
    get state() {
      return snapshot(there().store)
    },
    get theta() {
      return there().clock.degrees()
    },
    set theta(degrees) {
      there().clock.stop()
      there().clock.turnTo(degrees)
    },
    get playing() {
      return there().clock.playing.peek()
    },
    play: () => there().clock.play(),
    stop: () => there().clock.stop(),
    get exhibits() {
      return there().shown.peek()
    },
    read(index = 0) {
      void there().clock.flush()
      const stage = stages.get(index)
      if (!stage) throw new RangeError(`There is no engine ${index} on the stage.`)
      return stage.read()
    },
    get revision() {
      return revision()
    },
    async settled() {
      await ready
      const { clock } = there()
      const turning = (): boolean => clock.playing.peek()
      return settled(() => (clock.waiting() && !turning()) || changing(), turning)
    },
    frameTimes: () => there().clock.frameTimes(),
    get means() {
      return stages.get(0)?.means ?? null
    },
  }
}

/** Shows a host's engines in an element until the returned function is called. */
export function show(
  host: Promise<Host>,
  el: Holder,
  bound?: (app: App) => () => void,
): () => void {
  const stages = new Map<number, Stage>()
  let app: App | null = null
  let ended = false
  let unbind: (() => void) | undefined
  el.replaceChildren() // a file says in it what to do if no script comes
  const release = adopt(el)
  // the stage comes with the first effects, and so do the keys
  let begun = (): void => {}
  const staged = new Promise<void>((done) => {
    begun = done
  })
  const ready = host.then(async (data) => {
    if (ended) return
    app = createApp(data)
    unbind = bound?.(app)
    const { stages: own } = app
    const made = (index: number, stage: Stage | null): void => {
      for (const all of [stages, own]) {
        if (stage) all.set(index, stage)
        else all.delete(index)
      }
      begun()
    }
    draw(
      <Shared.Provider value={app}>
        <Page made={made} />
      </Shared.Provider>,
      el,
    )
    await staged
    await app.clock.flush()
    performance.mark('crankstar ready')
  })
  ready.catch((error: unknown) => {
    draw(<p class="crankstar failed">{reasonOf(error)}</p>, el)
  })
  const handle = handleOf(ready, () => app, stages)
  // who asked before this script had come holds an object in its place, which it takes over
  const held = el.crankstar ?? {}
  el.crankstar = Object.defineProperties(held, Object.getOwnPropertyDescriptors(handle)) as Handle
  el.dispatchEvent(new Event('crankstar'))
  return () => {
    ended = true
    begun()
    unbind?.()
    draw(null, el)
    app?.dispose()
    release()
    delete el.crankstar
  }
}

/** The entry of anywidget: shows a model's engines until the returned function is called. */
function render({ model, el }: { model: Model; el: HTMLElement }): () => void {
  // else JupyterLab takes our keys for its own
  el.dataset.lmSuppressShortcuts = 'true'
  const begin = (): (() => void) => show(widgetHost(model), el, (app) => linked(model, app))
  let end = begin()
  const again = (): void => {
    end()
    end = begin()
  }
  model.on('change:data', again)
  return () => {
    model.off('change:data', again)
    end()
  }
}

// A file and a server's page have one element that says so; a notebook has none, and calls
// `render`.
const own =
  typeof document === 'undefined' ? null : document.querySelector<Holder>('[data-crankstar]')
if (own) show(own.dataset.crankstar === 'server' ? serverHost() : pageHost(document), own)

export default { render }
