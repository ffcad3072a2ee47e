/** What is wanted of a gallery; empty text for all. */
export interface Wanted {
  readonly words: string
  readonly layout: string
  readonly cylinders: string
}

/** What a card says of its engine. */
export interface Engine {
  readonly words: string
  readonly layout: string
  readonly cylinders: string
}

/** Whether an engine has every typed word, the layout and the number of cylinders. */
export function matches(engine: Engine, wanted: Wanted): boolean {
  const typed = wanted.words.toLowerCase().split(/\s+/).filter(Boolean)
  return (
    (wanted.layout === '' || wanted.layout === engine.layout) &&
    (wanted.cylinders === '' || wanted.cylinders === engine.cylinders) &&
    typed.every((word) => engine.words.includes(word))
  )
}
