import { useExhibit } from '../context'

/** The facts that the numbers show, as sentences, by what they are about. */
export function Verdict() {
  const exhibit = useExhibit()
  const subjects = [...new Set(exhibit.verdict.map((fact) => fact.about))]
  return (
    <>
      <ul class="heading">
        {exhibit.heading.map((line) => (
          <li key={line} class={line.startsWith('unverified') ? 'doubt' : ''}>
            {line}
          </li>
        ))}
      </ul>
      <dl class="facts">
        {subjects.map((about) => (
          <div key={about}>
            <dt>{about}</dt>
            <dd>
              {exhibit.verdict
                .filter((fact) => fact.about === about)
                .map((fact) => (
                  <p key={fact.sentence}>{fact.sentence}</p>
                ))}
            </dd>
          </div>
        ))}
      </dl>
    </>
  )
}
