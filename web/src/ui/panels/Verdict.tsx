import { message, t } from '../../language/messages'
import { typeset } from '../../language/typeset'
import { useExhibit } from '../context'
import { judged } from '../names'
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
  const { rests_on } = exhibit
  return (
    <>
      <dl class="facts">
        {judged(exhibit).map(([about, facts]) => (
          <div key={about}>
            <dt>{about}</dt>
            <dd>
              {facts.map(({ sentence }) => (
                <p key={sentence}>{typeset(sentence)}</p>
              ))}
            </dd>
          </div>
        ))}
      </dl>
      {rests_on.length > 0 && (
        <>
          <p class="doubt">{t('This rests on:')}</p>
          {rests_on.map((line) => (
            <p key={line} class="doubt">
              {line}
            </p>
          ))}
        </>
      )}
      <Words />
    </>
  )
}
