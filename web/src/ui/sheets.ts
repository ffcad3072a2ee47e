import exporting from '../export/export.css?inline'
import derivation from './derivation.css?inline'
import guide from './guide.css?inline'
import mounts from './mounts.css?inline'
import narrow from './narrow.css?inline'
import panels from './panels.css?inline'
import present from './present.css?inline'
import print from './print.css?inline'
import style from './style.css?inline'
import torque from './torque.css?inline'
import twist from './twist.css?inline'

const sheets = new Map<string, CSSStyleSheet>()

/** A style sheet that no Content-Security-Policy minds: constructed, not written into the page. */
function sheetOf(css: string): CSSStyleSheet {
  const known = sheets.get(css)
  if (known) return known
  const made = new CSSStyleSheet()
  made.replaceSync(css)
  sheets.set(css, made)
  return made
}

const users = new Map<CSSStyleSheet, number>()

/** Adopts our styles in an element's document or shadow until the returned function is called. */
export function adopt(
  element: Element,
  css: readonly string[] = [
    style,
    panels,
    torque,
    twist,
    mounts,
    derivation,
    guide,
    exporting,
    narrow,
    present,
    print,
  ],
): () => void {
  const node = element.getRootNode()
  const root = node instanceof ShadowRoot ? node : element.ownerDocument
  const own = css.map(sheetOf)
  for (const sheet of own) {
    users.set(sheet, (users.get(sheet) ?? 0) + 1)
    if (!root.adoptedStyleSheets.includes(sheet))
      root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet]
  }
  return () => {
    for (const sheet of own) {
      const left = (users.get(sheet) ?? 1) - 1
      users.set(sheet, left)
      if (!left)
        root.adoptedStyleSheets = root.adoptedStyleSheets.filter((other) => other !== sheet)
    }
  }
}
