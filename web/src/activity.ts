/** What the page has begun and not ended, by which scripts and tests know that it has settled. */

let revisions = 0
let pending = 0
const resting = new Map<number, () => void>()

/** How much has been begun since the script came: a number that only grows. */
export const revision = (): number => revisions

/** Counts something as begun until the result is called; calling it again changes nothing. */
export function begin(): () => void {
  revisions += 1
  pending += 1
  let ended = false
  return () => {
    if (!ended) pending -= 1
    ended = true
  }
}

/** The same promise, which counts as begun until it is fulfilled or rejected. */
export function counted<T>(promise: Promise<T>): Promise<T> {
  const end = begin()
  promise.then(end, end)
  return promise
}

/**
 * Runs what waits for a rest, milliseconds, or sooner when somebody waits until all has settled.
 * Returns what calls it off.
 */
export function afterRest(run: () => void, rest: number): () => void {
  const off = (): void => {
    clearTimeout(timer)
    resting.delete(timer)
  }
  const due = (): void => {
    off()
    revisions += 1
    run()
  }
  const timer = Number(setTimeout(due, rest))
  resting.set(timer, due)
  return off
}

/** The next frame is there, and what its effects begin has been begun. */
const frame = (): Promise<void> =>
  new Promise((done) => requestAnimationFrame(() => setTimeout(done)))

/**
 * Resolves with the revision at which nothing is pending, for two frames: what a component begins
 * is begun in the effects that follow its frame. What waits for a rest does not wait any longer,
 * unless something is `moving`, and so has no rest. `busy` tells of what is not counted here.
 */
export async function settled(busy: () => boolean, moving: () => boolean): Promise<number> {
  let seen = -1
  for (let quiet = 0; quiet < 2; quiet++) {
    await frame()
    if (!moving()) for (const due of [...resting.values()]) due()
    if (pending || busy() || revisions !== seen) quiet = -1
    seen = revisions
  }
  return seen
}
