import derivation from './derivation.css?inline'
import narrow from './narrow.css?inline'
import panels from './panels.css?inline'
import style from './style.css?inline'

const sheets = new Map<string, CSSStyleSheet>()

/** A style sheet that no Content-Security-Policy minds: constructed, not written into the page. */
function sheetOf(css: string): CSSStyleSheet {
  const found = sheets.get(css)
  if (found) return found
  const made = new CSSStyleSheet()
  made.replaceSync(css)
  sheets.set(css, made)
  return made
}

const users = new Map<CSSStyleSheet, number>()

/** Our styles for the document (or shadow) that an element is in, until the returned function is called. */
export function adopt(element: Element, css: readonly string[] = [style, panels, derivation, narrow]): () => void {
  const found = element.getRootNode()
  const root = found instanceof ShadowRoot ? found : element.ownerDocument
  const own = css.map(sheetOf)
  for (const sheet of own) {
    users.set(sheet, (users.get(sheet) ?? 0) + 1)
    if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet]
  }
  return () => {
    for (const sheet of own) {
      const left = (users.get(sheet) ?? 1) - 1
      users.set(sheet, left)
      if (!left) root.adoptedStyleSheets = root.adoptedStyleSheets.filter((one) => one !== sheet)
    }
  }
}
