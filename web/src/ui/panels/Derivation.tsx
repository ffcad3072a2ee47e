export function Derivation() {
  return <p>Derivation</p>
}
