import { Error as ERRORS, type Loader, loader, logger, parse, View, type ViewOptions } from 'vega'
import { expressionInterpreter } from 'vega-interpreter'
import { compile, type TopLevelSpec } from 'vega-lite'
import type { Spec } from '../host/host'
import { framed } from './framing'

/** A figure that has been drawn in an element of its own, and can be turned. */
export interface Drawing {
  readonly element: HTMLElement
  /** How wide it is where a letter has its own size, px. */
  readonly width: number
  /** Whether it depends on the crank angle. */
  readonly turns: boolean
  /** Resolves when it has been drawn at that angle, degrees. */
  turnTo(degrees: number): Promise<unknown>
  dispose(): void
}

const THETA = 'theta'

/** Figures hold their data: nothing is fetched, and nothing in them is a link. */
const nothing = (): Promise<never> =>
  Promise.reject(new Error('A figure asked for something outside of it.'))
const closed: Loader = {
  ...loader(),
  load: nothing,
  sanitize: nothing,
  http: nothing,
  file: nothing,
}

/** Vega of Vega-Lite. */
const compiled = (figure: Spec): Spec =>
  compile(figure as unknown as TopLevelSpec, { logger: logger(ERRORS) }).spec as unknown as Spec

/** A view of a specification, without making code from text. */
function viewOf(spec: Spec, options: ViewOptions): View {
  const common = { expr: expressionInterpreter, hover: false, loader: closed, logLevel: ERRORS }
  return new View(parse(spec, undefined, { ast: true }), { ...common, ...options })
}

const turning = ({ signals }: Spec): boolean =>
  Array.isArray(signals) && signals.some(({ name }: { name?: unknown }) => name === THETA)

/** The specification with panels that do not change their size as it turns. */
async function steady(spec: Spec, cycleDegrees: number): Promise<Spec> {
  const look = viewOf(spec, { renderer: 'none' })
  try {
    return await framed(spec, look, THETA, cycleDegrees)
  } finally {
    look.finalize()
  }
}

/** Draws a figure; `cycleDegrees` is after how much everything is back at the start. */
export async function drawn(figure: Spec, cycleDegrees: number): Promise<Drawing> {
  const element = document.createElement('div')
  const spec = compiled(figure)
  const turns = turning(spec)
  const view = viewOf(turns ? await steady(spec, cycleDegrees) : spec, {
    renderer: 'svg',
    container: element,
  })
  try {
    await view.runAsync()
  } catch (error) {
    view.finalize()
    throw error
  }
  return {
    element,
    width: element.querySelector('svg')?.viewBox.baseVal.width ?? 0,
    turns,
    turnTo: (degrees) =>
      view.signal(THETA) === degrees ? Promise.resolve() : view.signal(THETA, degrees).runAsync(),
    dispose() {
      view.finalize()
      element.remove()
    },
  }
}
