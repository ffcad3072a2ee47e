export function WhirlPanel() {
  return <p>WhirlPanel</p>
}
