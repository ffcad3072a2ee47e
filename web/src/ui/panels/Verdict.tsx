import { message, t } from '../../language/messages'
import { typeset } from '../../language/typeset'
import { useExhibit } from '../context'
import { SHAKES } from '../names'
import type { Panel } from '../panel'
import { Words } from '../Term'

export const verdict: Panel = {
  key: 'verdict',
  label: message('Verdict'),
  Content: Verdict,
  of: 'each',
}

/** The sentences of the verdict, by subject: first what remains and what would cure it. */
function Verdict() {
  const exhibit = useExhibit()
  const { unverified } = exhibit
  const isFirst = ({ subject }: { subject: string }): boolean => SHAKES.includes(subject)
  const facts = [
    ...exhibit.verdict.filter(isFirst),
    ...exhibit.verdict.filter((fact) => !isFirst(fact)),
  ]
  const subjects = [...new Set(facts.map((fact) => fact.about))]
  return (
    <>
      <dl class="facts">
        {subjects.map((about) => (
          <div key={about}>
            <dt>{about}</dt>
            <dd>
              {facts
                .filter((fact) => fact.about === about)
                .map((fact) => (
                  <p key={fact.sentence}>{typeset(fact.sentence)}</p>
                ))}
            </dd>
          </div>
        ))}
      </dl>
      {unverified.length > 0 && (
        <p class="doubt">{t('Unverified values: {paths}.', { paths: unverified.join(', ') })}</p>
      )}
      <Words />
    </>
  )
}
