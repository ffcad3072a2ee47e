/** Colours as 0xRRGGBB: the crankshaft red, the others after M. Okabe and K. Ito. */
export interface Palette {
  /** A part's body, and its machined surfaces. */
  readonly crankshaft: readonly [number, number]
  readonly balanceShaft: readonly [number, number]
  readonly gear: readonly [number, number]
  readonly piston: readonly [number, number]
  readonly rod: readonly [number, number]
  readonly slave: readonly [number, number]
  /** The rubber of mounts, and their plates. */
  readonly mount: readonly [number, number]
  readonly glass: number
  readonly edge: number
  readonly edgeOpacity: number
  readonly force: number
  readonly part: number
  readonly couple: number
  readonly roll: number
  /** The force of a mount. */
  readonly reaction: number
  readonly text: string
  readonly quiet: string
  readonly paper: string
}

export const LIGHT: Palette = {
  crankshaft: [0xc8352b, 0xe2776a],
  balanceShaft: [0x0c8f6c, 0x67c2a8],
  gear: [0xb9944a, 0xd9bd80],
  piston: [0xc3ccd4, 0x8e99a5],
  rod: [0x8493a3, 0xa9b5c1],
  slave: [0x9aa7b4, 0xb9c3cd],
  mount: [0x4b535c, 0xa8b2bc],
  glass: 0x5f86a8,
  edge: 0x1b2530,
  edgeOpacity: 0.55,
  force: 0x0f6db5,
  part: 0x4fa9dc,
  couple: 0xb04f8c,
  roll: 0x8a6a00,
  reaction: 0xb55a00,
  text: '#28323c',
  quiet: '#66727e',
  paper: '#ffffff',
}

export const DARK: Palette = {
  crankshaft: [0xbf3f35, 0xdc8a7f],
  balanceShaft: [0x1da27e, 0x7bd0b8],
  gear: [0xb8954f, 0xdcc48c],
  piston: [0x98a5b1, 0x6c7986],
  rod: [0x6f7f90, 0x93a1af],
  slave: [0x8391a0, 0xa5b2bf],
  mount: [0x5b6570, 0x93a0ac],
  glass: 0x9cc3e4,
  edge: 0x0a0f14,
  edgeOpacity: 0.75,
  force: 0x56b4e9,
  part: 0x3d87b8,
  couple: 0xe08fbd,
  roll: 0xd8b64a,
  reaction: 0xf39a4b,
  text: '#e4e9ee',
  quiet: '#9aa6b2',
  paper: '#14181d',
}

/** Opacity of a stroke's tint at its beginning and its end. */
export const TINTS = {
  power: { begin: 0.85, end: 0.12 },
  exhaust: { begin: 0.4, end: 0.15 },
  intake: { begin: 0.12, end: 0.28 },
  compression: { begin: 0.2, end: 0.45 },
} as const

/** A colour's red, green and blue from 0 to 1, as it stands on the screen. */
export function channels(colour: number): [number, number, number] {
  return [(colour >> 16) / 255, ((colour >> 8) & 255) / 255, (colour & 255) / 255]
}

/** A colour as CSS writes it. */
export function css(colour: number, opacity = 1): string {
  const [red, green, blue] = channels(colour).map((channel) => Math.round(255 * channel))
  return `rgb(${red} ${green} ${blue} / ${opacity})`
}
