import type { Exhibit } from '../exhibit'
import type { Chain } from '../motion'
import type { Instant, Picture } from './picture'
import type { Reading } from './stage'

/** A picture without WebGL. */
export function flatPicture(): Picture {
  return new FlatPicture()
}

class FlatPicture implements Picture {
  readonly means = 'flat'
  readonly canvas = document.createElement('canvas')

  show(_exhibit: Exhibit, _chain: Chain): void {}
  draw(_instant: Instant): void {}
  pistons(): Reading['pistons'] {
    return {}
  }
  pins(): Reading['pins'] {
    return []
  }
  size(width: number, height: number, density: number): void {
    this.canvas.width = Math.round(width * density)
    this.canvas.height = Math.round(height * density)
  }
  dispose(): void {}
}
