import type { Exhibit } from '../exhibit'
/** Layout, firing and units of an engine, and what matters most of what it rests on. */
export function Heading({ exhibit: { heading, rests_on } }: { exhibit: Exhibit }) {
  return (
    <ul class="heading">
      {heading.map((line) => (
        <li key={line}>{line}</li>
      ))}
      {rests_on.slice(0, 1).map((line) => (
        <li key={line} class="doubt">
          {line}
        </li>
      ))}
    </ul>
  )
}
