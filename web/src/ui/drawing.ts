import { Error as ERRORS, type Loader, loader, parse, type Spec as VegaSpec, View } from 'vega'
import { expressionInterpreter } from 'vega-interpreter'
import type { Spec } from '../host/host'

/** A figure that has been drawn in an element of its own, and can be turned. */
export interface Drawing {
  readonly element: HTMLElement
  /** Whether it depends on the crank angle. */
  readonly turns: boolean
  /** Resolves when it has been drawn at that angle, degrees. */
  turnTo(degrees: number): Promise<unknown>
  dispose(): void
}

const THETA = 'theta'

/** Figures bring their data along: nothing is ever fetched for them, and nothing in them is a link. */
const nothing = (): Promise<never> => Promise.reject(new Error('A figure asked for something outside of it.'))
const closed: Loader = { ...loader(), load: nothing, sanitize: nothing, http: nothing, file: nothing }

/** Draws a compiled Vega specification, without making code from text. */
export async function drawn(spec: Spec): Promise<Drawing> {
  const element = document.createElement('div')
  const view = new View(parse(spec as unknown as VegaSpec, undefined, { ast: true }), {
    expr: expressionInterpreter,
    renderer: 'svg',
    container: element,
    hover: false,
    loader: closed,
    logLevel: ERRORS,
  })
  try {
    await view.runAsync()
  } catch (error) {
    view.finalize()
    throw error
  }
  const turns = Object.hasOwn(view.getState().signals ?? {}, THETA)
  return {
    element,
    turns,
    turnTo: (degrees) => (view.signal(THETA) === degrees ? Promise.resolve() : view.signal(THETA, degrees).runAsync()),
    dispose() {
      view.finalize()
      element.remove()
    },
  }
}
