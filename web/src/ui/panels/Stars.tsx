export function Stars() {
  return <p>Stars</p>
}
