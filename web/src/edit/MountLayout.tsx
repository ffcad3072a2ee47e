import { useSignal } from '@preact/signals'
import { useRef, useState } from 'preact/hooks'
import { t } from '../language/messages'
import {
  type Frame,
  frameOf,
  type Place,
  placeAt,
  type Side,
  type Spot,
  seen,
} from '../ui/layoutView'
import { Centre, Ground, NAMES, NameBelow, scaleOf } from '../ui/MountViews'
import { idOf, useSession } from './context'
import { fourMounts, mountsIn, oneMore, placedAt, placeIn, withEstimate } from './mounts'
import { at, type Path } from './tree'

/** Steps of a drag and of the arrow keys, metres: as they are, and with shift or alt. */
const [DRAG, FINE_DRAG, KEY, FINE_KEY] = [0.005, 0.001, 0.005, 0.001]
const WAYS: Readonly<Record<string, Spot>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
}

/** The layout of the mounts of the engine that is edited: what it needs, and where they are. */
export function MountLayout() {
  const session = useSession()
  const tree = session.tree.value
  // what is known of the engine on the stage is another whenever that is
  void session.valid.value
  const { whirl, scene, relative } = session
  if (!whirl || !scene) return null
  if (relative.length > 0)
    return (
      <p class="help">
        {t('Mounts need masses and lengths in units; this engine counts some of them in its own.')}
      </p>
    )
  const heavy = at(tree, ['block', 'mass']) !== undefined
  const list = at(tree, ['mounts'])
  const mounts: unknown[] = Array.isArray(list) ? list : []
  return (
    <section class="mount-layout" aria-label={t('Layout of the mounts')}>
      {!heavy && <Mass />}
      {mounts.length > 0 ? (
        <Views mounts={mounts} />
      ) : (
        <>
          <p class="help">
            {t('The engine stands on no mounts yet: forces and couples go into the air.')}
          </p>
          <button
            type="button"
            class="add"
            onClick={() => session.set(['mounts'], fourMounts(scene, whirl))}
          >
            {t('Put it on four mounts')}
          </button>
        </>
      )}
    </section>
  )
}

/** Asks for the mass of the block, and offers the estimate. */
function Mass() {
  const session = useSession()
  const [typed, setTyped] = useState('')
  const mass = session.whirl?.mass ?? 0
  const shown = Number(mass.toPrecision(3))
  const id = 'mount-layout-mass'
  const give = (): void => {
    const text = typed.trim().replace(',', '.')
    if (!text) return
    const value = /^[-+\d.e]+$/i.test(text) ? `${text} kg` : text
    session.set(['block', 'mass'], value)
  }
  return (
    <div class="block-mass">
      <p>
        {t(
          'How heavy is the engine? Modes and motion on its mounts depend on it; the file does not say.',
        )}
      </p>
      <div class="taking">
        <label for={id}>{t('Mass of the engine')}</label>
        <input
          id={id}
          type="text"
          inputMode="decimal"
          autocomplete="off"
          placeholder={t('e.g. {example}', { example: '165 kg' })}
          value={typed}
          onInput={(event) => setTyped(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key !== 'Enter') return
            event.preventDefault()
            give()
          }}
        />
        <button type="button" class="add" disabled={!typed.trim()} onClick={give}>
          {t('Take it')}
        </button>
        <button
          type="button"
          class="add"
          onClick={() =>
            session.edit(
              withEstimate(
                session.tree.peek(),
                mass,
                t('usual mass of engines with such reciprocating parts'),
              ),
            )
          }
        >
          {t('Take the estimate: {mass} kg', { mass: shown })}
        </button>
      </div>
    </div>
  )
}

/** The views in which mounts are dragged, and what is done with the one that is chosen. */
function Views({ mounts }: { mounts: readonly unknown[] }) {
  const session = useSession()
  const tree = session.tree.value
  const [chosen, setChosen] = useState(0)
  const [second, setSecond] = useState<'side' | 'plan'>('plan')
  const { scene, whirl } = session
  const centreAt = whirl?.centre ?? [0, 0, 0]
  const things: Thing[] = [
    ...mountsIn(tree).map(({ index, name, place }) => ({
      ...{ key: `mount ${index}`, name, place },
      path: ['mounts', index],
    })),
    ...(at(tree, ['block', 'mass']) === undefined
      ? []
      : [
          {
            key: 'centre',
            name: t('centre of mass'),
            place: placeIn(tree, ['block'], centreAt),
            path: ['block'],
          },
        ]),
  ]
  if (!scene) return null
  const known = things.flatMap(({ place }) => (place ? [place] : []))
  const which = Math.min(chosen, mounts.length - 1)
  const name = things[which]?.name ?? ''
  return (
    <>
      <p class="help">
        {t(
          'Drag a mount or the centre of mass; shift drags finely. Arrow keys move what has the focus by 5 mm, with shift by 1 mm.',
        )}
      </p>
      <div class="views">
        <View side="front" things={things} places={known} chosen={which} choose={setChosen} />
        <View side={second} things={things} places={known} chosen={which} choose={setChosen} />
      </div>
      <div class="taking">
        <button
          type="button"
          class="add"
          aria-pressed={second === 'side'}
          onClick={() => setSecond(second === 'side' ? 'plan' : 'side')}
        >
          {second === 'side' ? t('Show the plan') : t('Show the side view')}
        </button>
        <button
          type="button"
          class="add"
          onClick={() => {
            session.set(['mounts'], [...mounts, oneMore(mounts)])
            setChosen(mounts.length)
          }}
        >
          {t('Add a mount')}
        </button>
        <button
          type="button"
          class="add"
          onClick={() => {
            const rest = mounts.filter((_, index) => index !== which)
            session.set(['mounts'], rest.length > 0 ? rest : undefined)
          }}
        >
          {t('Remove {name}', { name })}
        </button>
        <button type="button" class="add" onClick={() => lookAt(['mounts', which])}>
          {t('Numbers of {name}', { name })}
        </button>
      </div>
    </>
  )
}

/** Opens the fields of a record. */
function lookAt(path: Path): void {
  const element = document.getElementById(idOf(path))
  for (let fold = element?.closest('details'); fold; fold = fold.parentElement?.closest('details'))
    fold.open = true
  element?.scrollIntoView({ block: 'center' })
  element?.querySelector('summary')?.focus({ preventScroll: true })
}

/** Something that stands at a place of the file. */
interface Thing {
  readonly key: string
  readonly name: string
  readonly place: Place | null
  readonly path: Path
}

interface ViewProps {
  readonly side: Side
  readonly things: readonly Thing[]
  readonly places: readonly Place[]
  readonly chosen: number
  readonly choose: (index: number) => void
}

/** A view in which things are dragged or moved by keys. */
function View({ side, things, places, chosen, choose }: ViewProps) {
  const session = useSession()
  // no state: what is held must be known to the events that come before the next drawing
  const grasp = useSignal<{ key: string; frame: Frame; off: Spot } | null>(null)
  const held = grasp.value
  const root = useRef<HTMLDivElement>(null)
  const { scene } = session
  if (!scene) return null
  // while something is dragged, the drawing stands still under it
  const frame = held?.frame ?? frameOf(side, scene, places)
  const scale = scaleOf(frame)
  const under = ({ clientX, clientY }: PointerEvent): Spot | null => {
    const matrix = root.current?.querySelector('svg')?.getScreenCTM()
    if (!matrix) return null
    const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(matrix.inverse())
    return [x / scale, y / scale]
  }
  const move = (thing: Thing, to: (now: Place) => Spot, step: number): void => {
    // from where it is, not from where it was last drawn
    const now = thing.place && placeIn(session.tree.peek(), thing.path, thing.place)
    if (!now) return
    session.direct(
      placedAt(session.tree.peek(), thing.path, now, placeAt(side, to(now), now), step),
      `${thing.path.join('.')} place`,
    )
  }
  const follow = (thing: Thing, event: PointerEvent): void => {
    const own = grasp.peek()
    const spot = under(event)
    if (!spot || own?.key !== thing.key) return
    const to: Spot = [spot[0] - own.off[0], spot[1] - own.off[1]]
    move(thing, () => to, event.shiftKey || event.altKey ? FINE_DRAG : DRAG)
  }
  const leave = (): void => {
    grasp.value = null
    session.rest()
  }
  return (
    <div ref={root}>
      <Ground
        side={side}
        scene={scene}
        frame={frame}
        label={t('Layout of the mounts: {view}', { view: t(NAMES[side]) })}
      >
        {byNearness(side, things).map(({ thing, place, index, hidden }) => {
          const [x, y] = seen(side, place).map((each) => each * scale) as [number, number]
          return (
            // biome-ignore lint/a11y/useSemanticElements: a button cannot stand in a drawing
            <g
              key={thing.key}
              class={`handle ${index === chosen ? 'chosen' : ''} ${held?.key === thing.key ? 'held' : ''}`}
              data-thing={thing.key}
              transform={`translate(${x.toFixed(2)} ${y.toFixed(2)})`}
              role="button"
              tabIndex={0}
              aria-label={`${thing.name}: ${placeText(place)}`}
              onFocus={() => thing.key !== 'centre' && choose(index)}
              onPointerDown={(event) => {
                const spot = under(event)
                if (!spot || event.button !== 0) return
                event.currentTarget.setPointerCapture(event.pointerId)
                event.currentTarget.focus()
                const [atX, atY] = seen(side, place)
                grasp.value = { key: thing.key, frame, off: [spot[0] - atX, spot[1] - atY] }
              }}
              onPointerMove={(event) => follow(thing, event)}
              onPointerUp={leave}
              onPointerCancel={leave}
              onBlur={session.rest}
              onKeyDown={(event) => {
                const way = WAYS[event.key]
                if (!way) return
                event.preventDefault()
                const step = event.shiftKey ? FINE_KEY : KEY
                const next = (now: Place): Spot => {
                  const [atX, atY] = seen(side, now)
                  return [atX + step * way[0], atY + step * way[1]]
                }
                move(thing, next, FINE_KEY)
              }}
            >
              <circle class="grip" r="17" />
              {thing.key === 'centre' ? (
                <Centre at={[0, 0]} />
              ) : (
                <rect x="-7" y="-7" width="14" height="14" rx="2" />
              )}
              {!hidden && thing.key !== 'centre' && (
                <NameBelow name={thing.name} at={[x, y]} frame={frame} />
              )}
            </g>
          )
        })}
      </Ground>
      <output class="held-place" aria-live="off">
        {held ? placeText(things.find(({ key }) => key === held.key)?.place ?? [0, 0, 0]) : ' '}
      </output>
    </div>
  )
}

/** A thing that has a place, and whether one that is nearer hides its name. */
interface Shown {
  readonly thing: Thing
  readonly place: Place
  readonly index: number
  readonly hidden: boolean
}

/** Metres within which the names of two things would lie on each other. */
const CLOSE = 0.04
/** What of a place says how near it is: from the front, from the right, from above. */
const NEAR = { front: 2, side: 1, plan: 0 } as const satisfies Record<Side, 0 | 1 | 2>

/** The things on a view, the nearest last, so that it is taken hold of. */
function byNearness(side: Side, things: readonly Thing[]): Shown[] {
  const near = NEAR[side]
  const known = things
    .flatMap((thing, index) => (thing.place ? [{ thing, place: thing.place, index }] : []))
    .sort((one, other) => one.place[near] - other.place[near])
  return known.map((each, at) => {
    const [x, y] = seen(side, each.place)
    const hidden = known.slice(at + 1).some(({ thing, place }) => {
      const [otherX, otherY] = seen(side, place)
      return thing.key !== 'centre' && Math.hypot(otherX - x, otherY - y) < CLOSE
    })
    return { ...each, hidden }
  })
}

/** A place in words. */
function placeText([up, right, z]: Place): string {
  const [upward, rightward, along] = [up, right, z].map((each) => Math.round(1e4 * each) / 10)
  return t('{up} mm up, {right} mm right, {along} mm to the front', {
    up: upward ?? 0,
    right: rightward ?? 0,
    along: along ?? 0,
  })
}
