export function Forces() {
  return <p>Forces</p>
}
