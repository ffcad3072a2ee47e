"""Texts on a page that are cut off, run out of their boxes, or lie on each other."""

from __future__ import annotations

from playwright.sync_api import Page

FOUND = r"""() => {
    const style = element => getComputedStyle(element)
    const name = element => [element.tagName.toLowerCase(), ...element.classList].join('.')
    const lineage = element => element ? [element, ...lineage(element.parentElement)] : []
    const scrolls = way => ['auto', 'scroll'].includes(way)
    // spaces at the ends of lines hang out of a `pre`
    const APART = 'svg, canvas, math, pre, .unseen, option, script, style, dialog:not([open])'
    const modal = document.querySelector('dialog:modal') ?? document.body
    // boxes of a text, each line of it one, and what of them the scrollers around it show
    const lines = node => {
        const range = document.createRange()
        range.selectNodeContents(node)
        return [...range.getClientRects()].filter(({ width, height }) => width > 1 && height > 1)
    }
    const shown = (box, above) => {
        let { left, right, top, bottom } = box
        for (const element of above) {
            const { overflowX, overflowY } = style(element)
            if (overflowX === 'visible' && overflowY === 'visible') continue
            const room = element.getBoundingClientRect()
            if (overflowX !== 'visible')
                [left, right] = [Math.max(left, room.left), Math.min(right, room.right)]
            if (overflowY !== 'visible')
                [top, bottom] = [Math.max(top, room.top), Math.min(bottom, room.bottom)]
        }
        return { left, right, top, bottom }
    }
    const texts = []
    const walker = document.createTreeWalker(modal, NodeFilter.SHOW_TEXT)
    while (walker.nextNode()) {
        const node = walker.currentNode
        const element = node.parentElement
        if (!node.data.trim() || element.closest(APART)) continue
        // said to those who listen, not shown
        if (lineage(element).some(one => style(one).clipPath === 'inset(50%)')) continue
        if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue
        texts.push({ node, element, above: lineage(element), words: node.data.trim() })
    }
    const found = []
    const tell = (element, what, words) =>
        found.push(`${name(element)} ${what}: ${words.slice(0, 60)}`)
    // cut off: by a box above it that hides what is outside, unless it can be scrolled there
    const hider = (above, way, size, beyond) => {
        for (const one of above) {
            const its = style(one)[`overflow${way}`]
            if (its === 'visible') continue
            if (scrolls(its) && one[`scroll${size}`] > one[`client${size}`]) return null
            if (!scrolls(its) && beyond(one.getBoundingClientRect())) return one
        }
        return null
    }
    for (const { node, element, above, words } of texts)
        for (const box of lines(node)) {
            const by = hider(above, 'X', 'Width',
                ({ left, right }) => box.right > right + 1 || box.left < left - 1)
                ?? hider(above, 'Y', 'Height',
                    ({ top, bottom }) => box.bottom > bottom + 3 || box.top < top - 3)
            if (by) tell(element, `is cut off by ${name(by)}`, words)
            const ways = above.map(one => [one, style(one), one.getBoundingClientRect()])
            const own = ways.find(([one, { display }]) =>
                !display.startsWith('inline') || display.includes('-'))
            if (!own || own[0].clientWidth === 0) continue
            const reached = ways.some(([one, { overflowX }]) =>
                scrolls(overflowX) && one.scrollWidth > one.clientWidth)
            if (!reached && (box.right > own[2].right + 1 || box.left < own[2].left - 1))
                tell(element, `runs out of ${name(own[0])}`, words)
            if (['BUTTON', 'SUMMARY', 'LABEL', 'TH', 'TD'].includes(own[0].tagName)
                && (box.bottom > own[2].bottom + 3 || box.top < own[2].top - 3))
                tell(element, `is taller than ${name(own[0])}`, words)
        }
    // a chosen option, or what stands in an empty field, longer than its box
    const pen = document.createElement('canvas').getContext('2d')
    for (const box of modal.querySelectorAll('select, input[placeholder]')) {
        if (!box.checkVisibility() || box.closest('.unseen')) continue
        const its = style(box)
        const words = box.tagName === 'SELECT'
            ? box.selectedOptions[0]?.text : box.value ? '' : box.placeholder
        if (!words) continue
        pen.font = `${its.fontWeight} ${its.fontSize} ${its.fontFamily}`
        const room = box.clientWidth - parseFloat(its.paddingLeft) - parseFloat(its.paddingRight)
        const wide = pen.measureText(words).width
        if (wide > room + 1)
            tell(box, `has ${Math.round(room)} px for ${Math.round(wide)}`, words)
    }
    // texts on each other, each with the overlay that it is in
    const layer = above => above.find(one => ['fixed', 'sticky'].includes(style(one).position))
    const boxes = texts.flatMap(({ node, element, above, words }) =>
        lines(node).map(box => ({ ...shown(box, above), element, words, layer: layer(above) })))
        .filter(box => box.right - box.left > 2 && box.bottom - box.top > 2)
    boxes.sort((one, other) => one.top - other.top)
    for (const [place, one] of boxes.entries())
        for (const other of boxes.slice(place + 1)) {
            if (other.top > one.bottom - 4) break
            const across = Math.min(one.right, other.right) - Math.max(one.left, other.left)
            const down = Math.min(one.bottom, other.bottom) - other.top
            if (across <= 2 || down <= 4 || one.layer !== other.layer) continue
            if (one.element === other.element) continue
            tell(one.element, `lies on ${name(other.element)} "${other.words.slice(0, 30)}"`,
                one.words)
        }
    const { scrollWidth, clientWidth } = document.documentElement
    if (scrollWidth > clientWidth)
        found.push(`the page is ${scrollWidth} wide, the window ${clientWidth}`)
    return [...new Set(found)]
}"""


def overflows(page: Page) -> list[str]:
    """Each text that is cut off, runs out of its box or lies on another, and where it is."""
    return page.evaluate(FOUND)
