/** A sentence in which what stands between backticks is what one types. */
export function Coded({ text }: { text: string }) {
  const parts = text.split('`')
  return <>{parts.map((part, place) => (place % 2 ? <code key={place}>{part}</code> : part))}</>
}
