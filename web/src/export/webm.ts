import { type Bytes, bytes, float64, uint } from './bytes'
import type { Track } from './container'

/** Elements of EBML and Matroska, RFC 8794 and RFC 9559, by their identifiers. */
const ID = {
  ebml: 0x1a45dfa3,
  readVersion: 0x42f7,
  longestId: 0x42f2,
  longestSize: 0x42f3,
  docType: 0x4282,
  docVersion: 0x4287,
  docReadVersion: 0x4285,
  segment: 0x18538067,
  info: 0x1549a966,
  scale: 0x2ad7b1,
  duration: 0x4489,
  muxer: 0x4d80,
  writer: 0x5741,
  tracks: 0x1654ae6b,
  track: 0xae,
  number: 0xd7,
  uid: 0x73c5,
  lacing: 0x9c,
  codec: 0x86,
  type: 0x83,
  lasts: 0x23e383,
  video: 0xe0,
  width: 0xb0,
  height: 0xba,
  cues: 0x1c53bb6b,
  cue: 0xbb,
  cueTime: 0xb3,
  cuePlace: 0xb7,
  cueTrack: 0xf7,
  cueCluster: 0xf1,
  cluster: 0x1f43b675,
  time: 0xe7,
  block: 0xa3,
} as const
type Id = keyof typeof ID

const NANOSECONDS = 1e9
const MILLISECONDS = 1000
const VIDEO = 1
const KEY = 0x80

/** An element: identifier, size in eight bytes, contents; a whole number takes eight as well. */
function element(id: Id, ...contents: readonly (Bytes | string | number)[]): Bytes {
  const code = ID[id]
  const length = code > 0xffffff ? 4 : code > 0xffff ? 3 : code > 0xff ? 2 : 1
  const inside = bytes(...contents.map((part) => (typeof part === 'number' ? uint(part, 8) : part)))
  return bytes(uint(code, length), 0x01, uint(inside.length, 7), inside)
}

/** A film as WebM: VP8 or VP9, found at every key frame. */
export function webm({ codec, width, height, perSecond, chunks }: Track): Blob {
  const at = (frame: number): number => Math.round((MILLISECONDS * frame) / perSecond)
  const keys = chunks.flatMap(({ key }, frame) => (key ? [frame] : []))
  const clusters = keys.map((first, place) => {
    const blocks = chunks.slice(first, keys[place + 1]).map(({ data, key }, after) => {
      const since = uint(at(first + after) - at(first), 2)
      return element('block', bytes(0x81, since, key ? KEY : 0, data))
    })
    return element('cluster', element('time', at(first)), ...blocks)
  })
  const info = element(
    'info',
    element('scale', NANOSECONDS / MILLISECONDS),
    element('duration', float64((MILLISECONDS * chunks.length) / perSecond)),
    element('muxer', 'crankstar'),
    element('writer', 'crankstar'),
  )
  const tracks = element(
    'tracks',
    element(
      'track',
      ...[element('number', 1), element('uid', 1), element('lacing', 0)],
      element('codec', codec.startsWith('vp8') ? 'V_VP8' : 'V_VP9'),
      element('type', VIDEO),
      element('lasts', Math.round(NANOSECONDS / perSecond)),
      element('video', element('width', width), element('height', height)),
    ),
  )
  // as long whatever the places are
  const cues = (places: readonly number[]): Bytes =>
    element(
      'cues',
      ...keys.map((frame, index) => {
        const place = [element('cueTrack', 1), element('cueCluster', places[index] ?? 0)]
        return element('cue', element('cueTime', at(frame)), element('cuePlace', ...place))
      }),
    )
  let place = info.length + tracks.length + cues([]).length
  const places = clusters.map(({ length }) => {
    place += length
    return place - length
  })
  const head = element(
    'ebml',
    ...[element('readVersion', 1), element('longestId', 4), element('longestSize', 8)],
    ...[element('docType', 'webm'), element('docVersion', 4), element('docReadVersion', 2)],
  )
  const film = element('segment', info, tracks, cues(places), ...clusters)
  return new Blob([head, film], { type: 'video/webm' })
}
