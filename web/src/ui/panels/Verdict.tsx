export function Verdict() {
  return <p>Verdict</p>
}
