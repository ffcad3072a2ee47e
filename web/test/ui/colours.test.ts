import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { css, DARK, LIGHT } from '../../src/stage/palette'

const style = readFileSync(new URL('../../src/ui/style.css', import.meta.url), 'utf8')

/** The colours that a rule of the style gives to a name, as the stage writes them. */
function coloursOf(name: string): string[] {
  return [...style.matchAll(new RegExp(`--${name}: #([0-9a-f]{6});`, 'g'))].map(([, digits]) =>
    css(Number.parseInt(digits ?? '', 16)),
  )
}

test.each(['force', 'couple', 'roll'] as const)(
  'the mark of the %s beside its numbers has the colour of its arrow on the stage',
  (name) => {
    expect(coloursOf(name)).toEqual([css(LIGHT[name]), css(DARK[name])])
  },
)
