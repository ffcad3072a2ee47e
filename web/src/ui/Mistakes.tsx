import { plural, t } from '../language/messages'
import { useApp } from './context'

/** What is wrong with the file that the server watches; the last engine without a mistake stays. */
export function Mistakes() {
  const { mistakes } = useApp()
  const wrong = mistakes.value
  if (!wrong) return null
  const count = wrong.problems.length
  return (
    <div class="trouble mistaken" role="alert">
      <p>
        <strong>
          {plural('{file}: {count} mistake', '{file}: {count} mistakes', count, {
            file: wrong.file,
            count,
          })}
        </strong>{' '}
        {t('The engine is that of the last time it had none.')}
      </p>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls is reached by keyboard */}
      <ul tabIndex={0}>
        {wrong.problems.map(({ path, message }) => (
          <li key={`${path} ${message}`}>{message}</li>
        ))}
      </ul>
    </div>
  )
}
