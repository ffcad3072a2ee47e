import type { App } from '../../app'
import type { Panel } from '../panel'
import { about } from './About'
import { bearings } from './Bearings'
import { compare } from './Compare'
import { cylinders } from './Cylinders'
import { derivation } from './Derivation'
import { edit } from './Edit'
import { forces } from './Forces'
import { mounts } from './Mounts'
import { orders } from './Orders'
import { remedies } from './Remedies'
import { sound } from './Sound'
import { stars } from './Stars'
import { strokes } from './Strokes'
import { torque } from './Torque'
import { twist } from './Twist'
import { toldPanels } from './told'
import { verdict } from './Verdict'
import { whirl } from './WhirlPanel'

/** The panels in the order of their tabs. */
export const panelsOf = (app: App): Panel[] => [
  edit,
  orders,
  stars,
  forces,
  torque,
  cylinders,
  bearings,
  twist,
  mounts,
  strokes,
  sound,
  ...toldPanels(app),
  derivation,
  verdict,
  remedies,
  whirl,
  compare,
  about,
]
