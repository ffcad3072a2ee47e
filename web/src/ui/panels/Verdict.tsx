import { message } from '../../language/messages'
import { typeset } from '../../language/typeset'
import { useExhibit } from '../context'
import { Heading } from '../Heading'
import type { Panel } from '../panel'
import { Words } from '../Term'

export const verdict: Panel = {
  key: 'verdict',
  label: message('Verdict'),
  Content: Verdict,
  of: 'each',
}

/** The sentences of the verdict, by subject. */
function Verdict() {
  const exhibit = useExhibit()
  const subjects = [...new Set(exhibit.verdict.map((fact) => fact.about))]
  return (
    <>
      <Heading exhibit={exhibit} />
      <dl class="facts">
        {subjects.map((about) => (
          <div key={about}>
            <dt>{about}</dt>
            <dd>
              {exhibit.verdict
                .filter((fact) => fact.about === about)
                .map((fact) => (
                  <p key={fact.sentence}>{typeset(fact.sentence)}</p>
                ))}
            </dd>
          </div>
        ))}
      </dl>
      <Words />
    </>
  )
}
