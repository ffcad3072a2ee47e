import { message } from '../language/messages'
import type { Sight } from './stage'

/** What the stage shows, for readers who do not see it. */
export const LOOK = {
  sheet: message('{engine}: isometric view, plan, front and side view'),
  front: message('{engine}, seen from the front'),
  plan: message('{engine}, seen from above'),
  side: message('{engine}, seen from the side'),
  isometric: message('{engine}, isometric view'),
  orbit: message(
    '{engine}, free view: arrow keys turn it, plus and minus zoom, Home restores the view',
  ),
} as const satisfies Record<Sight, string>
