import { useEffect } from 'preact/hooks'
import type { Preset } from '../exhibit'
import type { Tree } from '../host/host'
import { t } from '../language/messages'
import { useSession } from './context'
import type { Bench } from './offers'

/** Usual layouts as small pictures. */
export function Presets({ bench }: { bench: Bench }) {
  const session = useSession()
  useEffect(bench.loadPresets, [bench])
  const groups = new Map<string, Preset[]>()
  for (const preset of bench.presets.value)
    groups.set(preset.group, [...(groups.get(preset.group) ?? []), preset])
  return (
    <div class="presets">
      {[...groups].map(([group, presets]) => (
        <fieldset key={group}>
          <legend>{group}</legend>
          {presets.map((preset) => (
            <button
              key={preset.key}
              type="button"
              onClick={() => {
                session.replace(preset.tree as Tree)
                session.note.value = t('{what} is now in the form.', {
                  what: preset.tree.name as string,
                })
              }}
            >
              <Picture of={preset} />
              <span>{preset.label}</span>
            </button>
          ))}
        </fieldset>
      ))}
    </div>
  )
}

const turned = (degrees: number): string => `rotate(${degrees})`

/** Cylinders and crank pins as seen from the front. */
export function Picture({ of }: { of: Pick<Preset, 'axes_deg' | 'throws_deg' | 'radial'> }) {
  return (
    <svg class="picture" viewBox="-24 -24 48 48" aria-hidden="true" focusable="false">
      {of.axes_deg.map((angle) => (
        <rect
          key={angle}
          class="bore"
          x="-4"
          y="-22"
          width="8"
          height="9"
          transform={turned(angle)}
        />
      ))}
      <circle class="orbit" r="9" />
      {of.throws_deg.map((angle, place) => (
        <g key={place} transform={turned(angle)}>
          <path d="M0 0V-9" />
          <circle class="dot" cy="-9" r="2.4" />
        </g>
      ))}
    </svg>
  )
}
