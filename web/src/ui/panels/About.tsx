import { useApp } from '../context'

const KEYS: readonly (readonly [string, string])[] = [
  ['space', 'play or stop'],
  [', and .', 'back or on by 1°; with shift 10°'],
  ['arrows', 'the same, where nothing else uses them'],
  ['page up, page down', 'on or back by 90°'],
]

/** Where the numbers come from, what was assumed, and how to get the same page again. */
export function About() {
  const { host, shown, engines } = useApp()
  const { command, version, sources = [] } = host.exhibition
  const asOpened = (index: number): boolean => same(engines.value[index]?.file, host.exhibition.engines[index]?.file)
  return (
    <>
      {shown.value.map((exhibit, index) => (
        <section key={index}>
          <h2>{exhibit.name}</h2>
          <ul class="heading">
            {exhibit.heading.map((line) => (
              <li key={line} class={line.startsWith('unverified') ? 'doubt' : ''}>
                {line}
              </li>
            ))}
          </ul>
          {sourceOf(exhibit.file).map((line) => (
            <p key={line}>
              <span class="soft">Source:</span> {line}
            </p>
          ))}
          {sources[index] && asOpened(index) && (
            <p>
              <span class="soft">Named as</span> <code>{sources[index]}</code>
            </p>
          )}
          {[...exhibit.scene.assumed, ...exhibit.whirl.assumed].length > 0 && (
            <h3>Assumed for the drawing and the whirl</h3>
          )}
          <ul class="heading">
            {[...exhibit.scene.assumed, ...exhibit.whirl.assumed].map((line) => (
              <li key={line}>{line}</li>
            ))}
          </ul>
        </section>
      ))}
      <section>
        <h2>How to read it</h2>
        <p>
          Everything is seen from the front, the end opposite the flywheel: up, and right as the viewer has it. The
          crank angle θ is counted from top dead centre of cylinder 1, in the direction of rotation. A couple is drawn
          in the plane in which it acts.
        </p>
        <h3>Keys</h3>
        <dl class="keys">
          {KEYS.map(([key, words]) => (
            <div key={key}>
              <dt>
                <kbd>{key}</kbd>
              </dt>
              <dd>{words}</dd>
            </div>
          ))}
        </dl>
      </section>
      <section>
        <h2>This page</h2>
        <p>Made by crankstar {version}.</p>
        {!asOpened(0) && <p>The engine is not the one that was opened: save it as TOML (Edit) to have it again.</p>}
        {command && asOpened(0) && (
          <p>
            Make it again: <code>{command}</code>
          </p>
        )}
      </section>
    </>
  )
}

const same = (one: unknown, other: unknown): boolean => JSON.stringify(one) === JSON.stringify(other)

/** What the engine file says of its source, if it is text. */
function sourceOf(file: Readonly<Record<string, unknown>>): string[] {
  const { source } = file
  if (typeof source === 'string') return [source]
  return Array.isArray(source) ? source.filter((line): line is string => typeof line === 'string') : []
}
