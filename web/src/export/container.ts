import type { Bytes } from './bytes'

/** A frame as an encoder gives it. */
export interface Chunk {
  readonly data: Bytes
  /** Whether it needs no frame before it. */
  readonly key: boolean
}

/** A film of frames that all last equally long, the first of them a key frame. */
export interface Track {
  /** How the encoder calls its code, such as `vp09.00.40.08`. */
  readonly codec: string
  /** What a decoder has to know before the first frame; empty where it needs nothing. */
  readonly description: Bytes
  readonly width: number
  readonly height: number
  readonly perSecond: number
  readonly chunks: readonly Chunk[]
}
