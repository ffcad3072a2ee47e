/** A letter with another as its index, as texts write it: M_V. */
const INDEXED = /\b([A-Z])_([A-Z])\b/

/** A heading with its letters set as in formulas: the M of M_V slanted, the V below the line. */
export function Lettered({ text }: { text: string }) {
  const [before, letter, index, after] = text.split(INDEXED)
  if (!letter) return <>{text}</>
  return (
    <>
      {before}
      <i>{letter}</i>
      <sub>{index}</sub>
      {after}
    </>
  )
}
