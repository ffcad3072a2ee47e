export function Strokes() {
  return <p>Strokes</p>
}
