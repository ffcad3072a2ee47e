// Generated from src/crankstar/exhibit/records.py by `make types`; not edited by hand.

/**
 * What a page opens with: one engine, or two side by side, and for each the same engine with weights and shafts.
 */
export interface Exhibition {
  /**
   * @minItems 1
   * @maxItems 2
   */
  engines: [Exhibit] | [Exhibit, Exhibit]
  /**
   * each engine with weights and balance shafts, where they help
   */
  fitted: (Exhibit | null)[]
  /**
   * the words with which each was named on the command line
   */
  sources?: string[]
  command?: string
  version: string
}
/**
 * All that the page is told of one engine at once. Figures and derivations are asked for by their keys.
 */
export interface Exhibit {
  format?: 1
  name: string
  /**
   * the engine file as a tree, as it was given
   */
  file: {
    [k: string]: unknown
  }
  cycle_deg: number
  /**
   * turns of the first shaft after which everything, firing included, is back at the start
   */
  turns: number
  /**
   * 1 if the first shaft turns clockwise seen from the front
   */
  sense: -1 | 1
  speed_rpm: number | null
  units: Units
  /**
   * lines under the name: layout, firing, units, what is unverified
   */
  heading: string[]
  reference_z: number
  /**
   * the length that couples are counted in along z, in the unit of the scene
   */
  couple_length: number
  orders: number[]
  total: Sum
  cylinders: PartForce[]
  whirl: Whirl
  scene: Scene
  table: Row[]
  verdict: Fact[]
  strokes: Table[]
  stroke_windows: StrokeWindow[]
  charts: ChartKey[]
  derivations: DerivationKey[]
  /**
   * what `fitted` was fitted with and what it leaves, for a fitted engine; else empty
   */
  remedies: Table[]
}
/**
 * The units of the numbers, as they are printed.
 */
export interface Units {
  force: string
  couple: string
  roll: string
  length: string
}
/**
 * Force, couple, roll of the block and torque on the crankshaft for each order; pairs of signals are [real, imaginary].
 */
export interface Sum {
  force: Vectors
  couple: Vectors
  roll: [number, number][]
  torque: [number, number][]
}
/**
 * A vector of the clock plane over the crank angle: a pair [up, right] for each order of the exhibit.
 */
export interface Vectors {
  forward: [number, number][]
  backward: [number, number][]
}
/**
 * What one cylinder (its piston, rod, share of nothing else) does to the block, at its place along z.
 */
export interface PartForce {
  number: number
  z: number
  force: Vectors
}
/**
 * The free response of the rigid engine: how the block moves, order by order (docs, theory: whirl).
 *
 * `shift` is the displacement of the centre of mass, `tilt` the displacement of the crank axis for each unit of z away from
 * the centre of mass, `turn` the roll angle of the block (a signal, clockwise, radians). Multiply as for forces. Lengths are in
 * the scene's unit. Independent of speed.
 */
export interface Whirl {
  /**
   * @minItems 3
   * @maxItems 3
   */
  centre: [number, number, number]
  mass: number
  /**
   * of the block about axes through its centre of mass: up, right, z
   *
   * @minItems 3
   * @maxItems 3
   */
  inertia: [number, number, number]
  shift: Vectors
  tilt: Vectors
  turn: [number, number][]
  /**
   * what of mass, centre and inertia is an estimate, as sentences; empty if all are given
   */
  assumed: string[]
}
/**
 * The engine as things that can be drawn.
 */
export interface Scene {
  /**
   * "m", or "crank radii" where the engine has no sizes
   */
  length_unit: string
  /**
   * lower corner [up, right, z] of the box that all parts stay in
   *
   * @minItems 3
   * @maxItems 3
   */
  low: [number, number, number]
  /**
   * @minItems 3
   * @maxItems 3
   */
  high: [number, number, number]
  shafts: ShaftShown[]
  gears: GearShown[]
  cylinders: CylinderShown[]
  /**
   * proportions that are not in the engine file, as sentences
   */
  assumed: string[]
}
/**
 * A shaft along z at `up`, `right`; it turns `speed_ratio` times for each turn of the first shaft, negative the other way.
 */
export interface ShaftShown {
  name: string
  kind: 'crankshaft' | 'balance shaft'
  speed_ratio: number
  up: number
  right: number
  z_from: number
  z_to: number
  journal_radius: number
  throws: ThrowShown[]
  webs: Web[]
  weights: WeightShown[]
}
/**
 * A crank throw: its pin at bearing `angle` at theta = 0.
 */
export interface ThrowShown {
  angle: number
  radius: number
  z: number
  pin_radius: number
  pin_from: number
  pin_to: number
  /**
   * numbers of the cylinders whose rods work on this pin, masters and plain rods
   */
  cylinders: number[]
}
/**
 * A crank web (cheek): a plate square to the shaft between a journal and a pin.
 */
export interface Web {
  z_from: number
  z_to: number
  /**
   * index of the throw whose pin it carries
   */
  throw: number
}
/**
 * A counterweight, drawn as a segment of a disc: opposite a pin on a web, or an eccentric on a balance shaft.
 */
export interface WeightShown {
  angle: number
  z: number
  unbalance: number
  inner_radius: number
  outer_radius: number
  /**
   * half the sector it covers, radians
   */
  half_angle: number
  thickness: number
}
/**
 * A gear wheel on a shaft, so that one sees which shafts turn together and how.
 */
export interface GearShown {
  /**
   * index of its shaft
   */
  shaft: number
  radius: number
  z: number
  thickness: number
  teeth: number
}
/**
 * A cylinder, its piston and its rod, with all that is needed to move them (docs, theory: motion).
 *
 * The crank pin of shaft `shaft` stands at bearing `throw_angle` at theta = 0; `master` is the index in the list of cylinders
 * of the one whose rod carries this rod's knuckle pin, -1 for a rod on the crank pin.
 */
export interface CylinderShown {
  number: number
  shaft: number
  throw: number
  throw_angle: number
  crank_radius: number
  bearing: number
  z: number
  offset: number
  rod_length: number
  master: number
  knuckle_radius: number
  knuckle_angle: number
  rod: 'plain' | 'fork' | 'blade' | 'master' | 'slave'
  /**
   * where its rod runs along z: beside others on the same pin
   */
  rod_z: number
  rod_width: number
  bore: number
  /**
   * from the piston pin to the crown, along the axis
   */
  pin_height: number
  /**
   * from the piston pin to the lower edge of the piston
   */
  skirt: number
  /**
   * lower end of the cylinder bore, from the shaft axis along the cylinder axis
   */
  bore_from: number
  /**
   * upper end of the bore, where the head begins
   */
  bore_to: number
  bank: string
  chamber: number
  /**
   * crank angle at which its chamber fires, degrees of theta; null without a firing order
   */
  fires_deg: number | null
}
/**
 * A row of the table of orders: numbers as they are printed, and the ellipse that goes with them.
 */
export interface Row {
  order: number
  label: string
  quantity: 'force' | 'couple' | 'roll' | 'torque'
  up: string
  right: string
  /**
   * in words: none, circle with the crank, horizontal line, ellipse, ...
   */
  path: string
  greatest: string
  /**
   * of the ellipse (vectors only), in the unit of the quantity
   */
  semi_axes: [number, number] | null
  /**
   * bearing of its long axis, radians
   */
  direction: number | null
  /**
   * the sense in which it is run through, seen from the front; 0 for a line
   */
  turning: (-1 | 0 | 1) | null
}
/**
 * A sentence of the verdict and what it is about.
 */
export interface Fact {
  about: string
  sentence: string
}
/**
 * A table to be shown as text: heads, rows, and lines under it.
 */
export interface Table {
  title: string
  heads: string[]
  rows: string[][]
  notes?: string[]
}
/**
 * What a chamber does between two crank angles (degrees; the end may lie in the next cycle).
 */
export interface StrokeWindow {
  chamber: number
  stroke: 'power' | 'exhaust' | 'intake' | 'compression'
  from_deg: number
  to_deg: number
}
/**
 * A figure that can be asked for: `key` is what to ask with, the rest is what to choose it by.
 */
export interface ChartKey {
  key: string
  /**
   * name of the figure, as in crankstar plot
   */
  figure: string
  label: string
  quantity?: string | null
  order?: number | null
  /**
   * whether it has the parameter theta (degrees)
   */
  turning: boolean
}
/**
 * A derivation that can be asked for.
 */
export interface DerivationKey {
  key: string
  label: string
  quantity: 'force' | 'couple'
  order: number
}
/**
 * What a page opens with: one engine, or two side by side, and for each the same engine with weights and shafts.
 */
export interface Exhibition1 {
  /**
   * @minItems 1
   * @maxItems 2
   */
  engines: [Exhibit] | [Exhibit, Exhibit]
  /**
   * each engine with weights and balance shafts, where they help
   */
  fitted: (Exhibit | null)[]
  /**
   * the words with which each was named on the command line
   */
  sources?: string[]
  command?: string
  version: string
}
/**
 * One mistake of an engine file: where (key path), and what would be right.
 */
export interface Problem {
  path: string
  message: string
}
