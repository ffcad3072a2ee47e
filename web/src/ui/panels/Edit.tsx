export function Edit() {
  return <p>Edit</p>
}
