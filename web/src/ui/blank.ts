import type { CreateStage } from '../stage/stage'

/** An empty stage, until there is one. */
export const createStage: CreateStage = (element) => {
  element.textContent = 'stage'
  return {
    means: 'flat',
    show: () => undefined,
    draw: (view) => {
      element.textContent = `${view.camera} ${view.theta.toFixed(3)}`
    },
    read: () => ({ pistons: {}, pins: [], paths: { front: [], rear: [] } }),
    resize: () => undefined,
    home: () => undefined,
    dispose: () => element.replaceChildren(),
  }
}
