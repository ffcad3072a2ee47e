export function Remedies() {
  return <p>Remedies</p>
}
