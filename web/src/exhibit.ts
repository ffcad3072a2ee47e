// Generated from src/crankstar/page/records.py by `make types`; not edited by hand.

export interface Exchange {
  Exhibition: Exhibition
  Problem: Problem
  CatalogEntry: CatalogEntry
  DerivationShown: DerivationShown
  FittedShown: FittedShown
  SearchShown: SearchShown
  TomlShown: TomlShown
  TreeShown: TreeShown
  WatchedShown: WatchedShown
  Preset: Preset
  SlidersShown: SlidersShown
  WorkshopShown: WorkshopShown
  FittedQuestion: FittedQuestion
  SearchQuestion: SearchQuestion
}
/** The contents of a page: one engine or two, each also with weights and shafts. */
export interface Exhibition {
  engines: [Exhibit] | [Exhibit, Exhibit]
  /** each engine with weights and balance shafts, where they help */
  fitted: (Exhibit | null)[]
  stroke_colours: StrokeColours
  /** of `told` of the engines */
  panels: PanelShown[]
  /** the choices of units that are offered by name */
  units?: UnitsOffered[]
  /** the terms that the page explains where they stand */
  glossary?: Term[]
  /** names or files of the engines on the command line */
  sources?: string[]
  command?: string
  version: string
}
/** One engine on the page; its figures and derivations are requested by their keys. */
export interface Exhibit {
  format?: 1
  name: string
  /** the engine file as a tree, as it was given */
  file: Record<string, unknown>
  cycle_deg: number
  /** turns of the first shaft after which all shafts and the firing repeat */
  turns: number
  /** shaft by shaft, the number of the throw with which each weight turns */
  weight_throws: (number | null)[][]
  /** what is not known, and so counted in its own unit */
  relative: ('mass' | 'radius' | 'pitch')[]
  /** 1 if the first shaft turns clockwise seen from the front */
  sense: -1 | 1
  /** of the engine file; null where it gives none */
  speed_rpm: number | null
  units: Units
  scale: Scale
  /** lines under the name: layout, firing, units */
  heading: string[]
  /** sentences on what is missing, assumed or unverified, what matters most first */
  rests_on: string[]
  /** key paths of estimated values */
  estimated: string[]
  /** whether masses that are missing can be estimated */
  can_estimate: boolean
  /** the sums in the middle and at the corners of the ranges of estimated values */
  ends: Sum[]
  reference_z: number
  /** the length that couples are counted in along z, in the unit of the scene */
  couple_length: number
  orders: number[]
  total: Sum
  cylinders: PartForce[]
  whirl: Whirl
  /** the same in the middle and at the corners of the ranges of estimated values */
  whirl_ends: Whirl[]
  bearings: Bearings
  bearing_numbers: BearingNumbers
  /** the loads with the gas of its first operating point; null where it has none */
  gas_bearings: Bearings | null
  gas_bearing_numbers: BearingNumbers | null
  scene: Scene
  table: Row[]
  verdict: Fact[]
  strokes: Table[]
  stroke_windows: StrokeWindow[]
  /** null where its gas cannot be computed */
  torque: Torque | null
  torque_unit: Unit
  /** what its gas torque needs, a sentence; else empty */
  gas_needs: string
  /** as a sound; null without a firing order */
  exhaust: Exhaust | null
  /** null without the table [torsion] */
  torsion: Torsion | null
  torsion_numbers: TorsionNumbers | null
  /** what torsion needs, a sentence; else empty */
  torsion_needs: string
  /** null without [[mounts]] */
  mounts: Mounts | null
  mount_numbers: MountNumbers | null
  charts: ChartKey[]
  derivations: DerivationKey[]
  /** what analyses print that have a panel of their own, by its key */
  told: {
    [k: string]: Table[]
  }
  /** weights, shafts and remaining unbalance of a fitted engine; else empty */
  remedies: Table[]
}
/**
 * The units of the numbers, as they are printed; numbers that are sent stay as they are.
 *
 * The factors lead from what is sent (N, N m, or m r ω²) to the unit that is printed.
 */
export interface Units {
  /** the choice of units, as --units names it */
  chosen: string
  force: string
  couple: string
  roll: string
  length: string
  force_factor: number
  couple_factor: number
  roll_factor: number
  /** in which force and couple are sent */
  counted: [string, string]
  /** of lengths of the scene, the smallest first; each from 0.1 of it on */
  lengths: Unit[]
  mass: Unit
  inertia: Unit
  pressure: Unit1
  power: Unit2
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit {
  label: string
  factor: number
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit1 {
  label: string
  factor: number
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit2 {
  label: string
  factor: number
}
/**
 * Sizes of the first cylinder in the engine's own units.
 *
 * Lengths, forces and couples of two engines that differ in units are compared after division by
 * these: in crank radii, m r ω², m r ω² times the bore pitch, and m r² ω².
 */
export interface Scale {
  /** crank radius, in units.length */
  length: number
  /** m r ω², in units.force */
  force: number
  /** m r ω² times the bore pitch, in units.couple */
  couple: number
  /** m r² ω², in units.roll */
  roll: number
}
/**
 * Force, couple, rolling moment and torque on the crankshaft for each order.
 *
 * Pairs of signals are [real, imaginary].
 */
export interface Sum {
  force: Vectors
  couple: Vectors
  roll: [number, number][]
  torque: [number, number][]
}
/**
 * A vector of the clock plane over the crank angle.
 *
 * A pair [up, right] for each order of the exhibit.
 */
export interface Vectors {
  forward: [number, number][]
  backward: [number, number][]
}
/** The force of one cylinder (its piston and rod) on the block, at its place along z. */
export interface PartForce {
  number: number
  /** the name of its bank */
  bank: string
  z: number
  force: Vectors
}
/**
 * The free response of the rigid engine: how the block moves, order by order.
 *
 * `shift` is the displacement of the centre of mass, `tilt` the displacement of the crank axis for
 * each unit of z away from the centre of mass, `turn` the roll angle of the block (a signal,
 * clockwise, radians). Multiply as for forces. Lengths are in the scene's unit. Independent of
 * speed.
 */
export interface Whirl {
  centre: [number, number, number]
  mass: number
  /** of the block about axes through its centre of mass: up, right, z */
  inertia: [number, number, number]
  shift: Vectors
  tilt: Vectors
  turn: [number, number][]
  /** sentences on estimates of mass, centre and inertia; empty if all are given */
  assumed: string[]
}
/**
 * What journals push on their bearings and rods on their pins, without gas or with it.
 *
 * Drawn to one scale, so that their unit says nothing.
 */
export interface Bearings {
  orders: number[]
  /** how the bearings share the load, as a sentence */
  model: string
  loads: LoadShown[]
}
/** The load on a main bearing, or of the rods on a crank pin, at the orders of `Bearings`. */
export interface LoadShown {
  on: 'bearing' | 'pin'
  name: string
  /** turns of its shaft for each turn of the first */
  speed_ratio: number
  load: Vectors
  /** the greatest length over the turn */
  peak: number
  /** the crank angle at which it is so long, radians */
  peak_theta: number
}
/** The numbers of `Bearings`, in the units that are shown, with the ranges of estimates. */
export interface BearingNumbers {
  bearing_unit: string
  pin_unit: string
  /** of each load the greatest over a turn, and its crank angle */
  greatest: string[]
  /** whether the numbers rest on estimates and have ranges */
  estimated: boolean
  tables: Table[]
  /** which gas is in them, as sentences; empty without */
  about: string[]
}
/** A table as it is printed: heads with units, rows, notes under it. */
export interface Table {
  title: string
  heads: string[]
  rows: string[][]
  notes?: string[]
  /** which columns hold numbers, which are aligned to the right */
  numeric?: boolean[]
}
/** The engine as things that can be drawn. */
export interface Scene {
  /** "m", or "crank radii" where the engine has no sizes */
  length_unit: string
  /** lower corner [up, right, z] of the box that all parts stay in */
  low: [number, number, number]
  high: [number, number, number]
  shafts: ShaftShown[]
  gears: GearShown[]
  cylinders: CylinderShown[]
  /** proportions that are not in the engine file, as sentences */
  assumed: string[]
}
/**
 * A shaft along z at `up`, `right`.
 *
 * It turns `speed_ratio` times for each turn of the first shaft, negative the other way.
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
/** A crank throw: its pin at bearing `angle` at theta = 0. */
export interface ThrowShown {
  angle: number
  radius: number
  z: number
  pin_radius: number
  pin_from: number
  pin_to: number
  /** numbers of the cylinders whose rods work on this pin, masters and plain rods */
  cylinders: number[]
}
/** A crank web (cheek): a plate square to the shaft between a journal and a pin. */
export interface Web {
  z_from: number
  z_to: number
  /** index of the throw whose pin it carries */
  throw: number
}
/**
 * A counterweight, drawn as a segment of a disc.
 *
 * Opposite a pin on a web, or an eccentric on a balance shaft.
 */
export interface WeightShown {
  angle: number
  z: number
  unbalance: number
  inner_radius: number
  outer_radius: number
  /** half the sector it covers, radians */
  half_angle: number
  thickness: number
}
/** A gear wheel on a shaft, so that one sees which shafts turn together and how. */
export interface GearShown {
  /** index of its shaft */
  shaft: number
  radius: number
  z: number
  thickness: number
  teeth: number
}
/**
 * A cylinder, its piston and its rod, with the dimensions that their motion depends on.
 *
 * The crank pin of shaft `shaft` stands at bearing `throw_angle` at theta = 0; `master` is the
 * index in the list of cylinders of the one whose rod carries this rod's knuckle pin, -1 for a rod
 * on the crank pin.
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
  /** where its rod runs along z: beside others on the same pin */
  rod_z: number
  rod_width: number
  bore: number
  /** from the piston pin to the crown, along the axis */
  pin_height: number
  /** from the piston pin to the lower edge of the piston */
  skirt: number
  /** lower end of the cylinder bore, from the shaft axis along the cylinder axis */
  bore_from: number
  /** upper end of the bore, where the head begins */
  bore_to: number
  chamber: number
}
/** A row of the table of orders: numbers as they are printed, and the ellipse of the vector. */
export interface Row {
  order: number
  label: string
  quantity: 'force' | 'couple' | 'roll' | 'torque'
  up: string
  right: string
  /** whether the numbers rest on estimates and have ranges */
  estimated: boolean
  /** shape of the path as a phrase: none, circle with the crank, horizontal line */
  path: string
  greatest: string
  /** greatest as a number, 0 where nothing remains of the order */
  size: number
  /** whether anything remains of the order; if estimated, other masses may differ */
  remains: boolean
  /** of the ellipse (vectors only), in the unit of the quantity */
  semi_axes: [number, number] | null
  /** bearing of its long axis, radians */
  direction: number | null
}
/** A sentence of the verdict and what it is about. */
export interface Fact {
  /** force, couple, roll, ... whatever the language */
  subject: string
  about: string
  sentence: string
}
/** A stroke of a chamber between two crank angles (degrees; it may end in the next cycle). */
export interface StrokeWindow {
  chamber: number
  stroke: 'power' | 'exhaust' | 'intake' | 'compression'
  from_deg: number
  to_deg: number
}
/** Torque on the crankshaft over a working cycle, at the orders of `orders`. */
export interface Torque {
  orders: number[]
  /** length of a working cycle, radians */
  cycle: number
  /** of all chambers, m^3 */
  displacement: number
  chambers: Chamber[]
  /** inertia torque at 1 rad/s, it grows with the square; null without masses */
  moving: [number, number][] | null
  /** moment of the moving parts about the axis at 1 rad/s */
  axis: [number, number][]
  loads: Load[]
}
/** A combustion chamber: when it fires, and which of the waves of a load is its own. */
export interface Chamber {
  number: number
  /** the crank angle at which it fires, radians */
  fires: number
  wave: number
}
/**
 * The gas torque at an operating point, N m: of each wave its amplitudes and its mean.
 *
 * The crank angle of a wave is counted from where its chamber fires.
 */
export interface Load {
  /** of the engine file; empty for the load of its table [gas] */
  name: string
  /** whether the load is assumed: the file gives none */
  assumed: boolean
  /** rad/s */
  speed: number | null
  burning: [number, number][][]
  burning_mean: number[]
  /** the same without combustion */
  still: [number, number][][]
  still_mean: number[]
  /** the torque that friction takes; 0 if not known */
  friction: number
  /** degree of, with every chamber burning */
  irregularity: number | null
  /** of all that turns, kg m^2; null if not known */
  inertia: number | null
  /** what is assumed, as sentences */
  notes: string[]
  /** what is hardly so, as sentences */
  doubts: string[]
  /** side thrust, and gears between crankshafts, with every chamber burning */
  tables: Table[]
}
/**
 * The exhaust as a sound: equal pulses at the firings through plain pipes.
 *
 * `pulse` are the amplitudes of one pulse at the orders 1, 2, ... of a cycle, of that at order 0;
 * what a pipe sends out comes back after `back` seconds, `reflected` times as large, upside down.
 */
export interface Exhaust {
  /** length of a working cycle, radians */
  cycle: number
  pulse: number[]
  back: number
  reflected: number
  pipes: Pipe[]
}
/** What shares an exhaust: its name, its chambers, and the crank angles at which they fire. */
export interface Pipe {
  name: string
  chambers: number[]
  fires: number[]
}
/**
 * The twist of the first crankshaft, front first.
 *
 * `throws` are the throws of the scene from front to rear, `masses_of_throws` their masses; none
 * of several crankshafts, which are not seen to twist. `pieces` are the shafts ahead of the first
 * throw, between the throws and behind the last; null where what hangs there turns with the throw.
 */
export interface Torsion {
  masses: string[]
  throws: number[]
  masses_of_throws: number[]
  pieces: (Piece | null)[]
  /** whether stiffnesses are estimated from dimensions */
  estimated: boolean
  modes: ModeShown[]
  criticals: CriticalShown[]
  /** of the vibrations */
  orders: number[]
  vibrations: Vibration[]
}
/** A shaft of the crank that is seen: between two throws, or at one of its ends. */
export interface Piece {
  name: string
  /** torque over shear stress, m^3; null if not known */
  modulus: number | null
}
/** A way in which the crankshaft vibrates freely. */
export interface ModeShown {
  number: number
  frequency_hz: number
  /** the turn of each mass, 1 at the first */
  shape: number[]
  /**
   * in each piece, N m for each radian that a mass with a shape of 1 turns; 0 where there is no piece
   */
  torque: number[]
}
/** An order that meets a mode within the range of speeds. */
export interface CriticalShown {
  mode: number
  order: number
  speed_rpm: number
  /** by how much it counts beside others */
  strength: number
}
/** The forced vibration in all orders at the speed of an operating point, or a critical one. */
export interface Vibration {
  /** the operating points whose gas drives; empty without a name */
  point: string
  /** whether there is gas, or the moving parts alone */
  gas: boolean
  speed_rpm: number
  /** mode and order that meet there; null at the speed of an operating point */
  critical: [number, number] | null
  /** of each throw, front first: how far it is ahead, radians */
  turns: [number, number][][]
  /** in each piece, N m; empty where there is none */
  torque: [number, number][][]
  /** the greatest of it over a cycle, N m */
  peak: number[]
}
/**
 * The numbers of `Torsion` in the units that are shown, as the command prints them.
 *
 * The units lead from Pa and N m; `criticals` are those that count.
 */
export interface TorsionNumbers {
  stress_unit: Unit
  torque_unit: Unit
  frequencies: Table
  criticals: Table
  every_critical: Table
  /** masses, shafts and shapes */
  chain: Table[]
  /** greatest vibration, barred speeds */
  over_speeds: Table[]
  /** of each vibration */
  vibrations: Table[][]
  notes: string[]
  doubts: string[]
}
/** The block on its mounts. */
export interface Mounts {
  /** of mass, of the block and of a foundation */
  centres: [number, number, number][]
  /** of which motion can be told; the first unless another is chosen */
  points: MountedPoint[]
  mounts: MountShown[]
  modes: MountedMode[]
  torque_roll: MountAxis
  elastic: MountAxis
  /** null where no speed is known */
  over: MountsOverSpeed | null
  /** of what shakes it */
  orders: number[]
  /** null where no speed is known */
  driving: Driving | null
  vibrations: MountVibration[]
}
/** A point of the block or of the foundation, and how it shakes over the range of speeds. */
export interface MountedPoint {
  name: string
  place: [number, number, number]
  /** whether it is of the foundation */
  below: boolean
  /** rms, m; empty where no speed is known */
  displacement: number[]
  /** rms, m/s */
  velocity: number[]
}
/** A mount of the block, or one below the foundation. */
export interface MountShown {
  name: string
  place: [number, number, number]
  /** the directions of its three axes */
  axes: [[number, number, number], [number, number, number], [number, number, number]]
  /** whether it is between the foundation and the ground */
  below: boolean
  /** what it bears at rest: force on what is below it, N */
  load: [number, number, number]
}
/** A natural mode of the block on its mounts. */
export interface MountedMode {
  number: number
  frequency_hz: number
  damping: number
  /** the share of each freedom in the kinetic energy */
  energy: number[]
  /** how far each freedom goes, m and rad, no size */
  shape: number[]
  /** of each mount on what is below it, N at that shape, without damping */
  forces: [number, number, number][]
}
/** A line in the block. */
export interface MountAxis {
  point: [number, number, number]
  direction: [number, number, number]
}
/** What is passed on over the range of speeds. */
export interface MountsOverSpeed {
  speeds_rpm: number[]
  /** on what the mounts stand on, rms, N */
  force: number[]
  /** of each mount of the block; null where it would bear next to nothing */
  transmissibility: (number | null)[][]
}
/**
 * What shakes the block, and what it has against it: at any speed the answer follows.
 *
 * -W^2 M + i W C + K(W) at W = k w, as in `dynamics.mounted_block`; the force of order k is that
 * of the moving parts times w^2, and the gas on the roll.
 */
export interface Driving {
  /** M of the freedoms, kg, kg m and kg m^2 */
  mass: number[][]
  springs: Spring[]
  /** on each freedom of the block at 1 rad/s */
  inertia: [number, number][][]
  /** rad/s, rising, at which the gas is known; empty without gas */
  gas_speeds: number[]
  /** on the roll of the block at these, N m; straight between, kept beyond */
  gas: [number, number][][]
}
/**
 * A mount as a spring: what the freedoms do along its axes, and what it does against that.
 *
 * Angular frequencies in rad/s; straight between those that are given.
 */
export interface Spring {
  arms: [number[], number[], number[]]
  /** along each axis under a load that stands still, N/m */
  stiffness: [number, number, number]
  /** along each axis, N s/m */
  damping: [number, number, number]
  loss: number
  /** frequency, and factor of the stiffness; from 1 at 0 */
  stiffening: [number, number][]
  /** frequency, and receptance of what it stands on along each axis, m/N */
  foot: [number, [number, number], [number, number], [number, number]][]
}
/** A speed of note, at which the block may be shown. */
export interface MountVibration {
  /** the operating point whose gas drives; empty without a name */
  point: string
  /** of that point on the roll of the block, N m; null: as over the speeds */
  gas: [number, number][] | null
  speed_rpm: number
  /** whether the block is in resonance here: shakes more than at speeds beside it */
  peak: boolean
}
/** The numbers of the mounts as they are printed, in the units of the page. */
export interface MountNumbers {
  displacement_unit: Unit3
  velocity_unit: Unit4
  acceleration_unit: Unit5
  force_unit: Unit6
  heat_unit: Unit7
  load_unit: Unit8
  mounts: Table
  modes: Table
  axes: Table
  speeds: Table1
  notes: string[]
  doubts: string[]
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit3 {
  label: string
  factor: number
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit4 {
  label: string
  factor: number
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit5 {
  label: string
  factor: number
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit6 {
  label: string
  factor: number
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit7 {
  label: string
  factor: number
}
/** A unit as it is printed, and the factor to it from the number that is sent. */
export interface Unit8 {
  label: string
  factor: number
}
/** A table as it is printed: heads with units, rows, notes under it. */
export interface Table1 {
  title: string
  heads: string[]
  rows: string[][]
  notes?: string[]
  /** which columns hold numbers, which are aligned to the right */
  numeric?: boolean[]
}
/** A figure of an engine: the `key` that it is requested by, and the properties to choose by. */
export interface ChartKey {
  key: string
  /** name of the figure, as in crankstar plot */
  figure: string
  label: string
  quantity?: string | null
  order?: number | null
}
/** A derivation of an engine, requested by its `key`. */
export interface DerivationKey {
  key: string
  label: string
  quantity: 'force' | 'couple'
  order: number
}
/** The colours of the strokes on the stage and in the stroke chart, `#rrggbb`. */
export interface StrokeColours {
  intake: string
  compression: string
  power: string
  exhaust: string
}
/** A panel with what an analysis has found of an engine, as its command prints it. */
export interface PanelShown {
  key: string
  label: string
  /** what stands there of an engine that has nothing of it */
  needs: string
  /** names of the figures in it */
  figures: string[]
}
/** A choice of units: its name, as --units takes it, and what a reader knows it by. */
export interface UnitsOffered {
  name: string
  label: string
}
/** A term: its names, its meaning in each language, its symbol or "", other words for it. */
export interface Term {
  term: string
  japanese: string
  russian: string
  meanings: {
    [k: string]: string
  }
  symbol?: string
  also?: string[]
}
/** One fault of an engine file: its key path, and what would be right. */
export interface Problem {
  path: string
  /** which fault */
  code?: string
  /** the values of its sentence */
  values?: Record<string, unknown>
  message: string
}
/** An engine of the catalog. */
export interface CatalogEntry {
  /** what to ask for it by */
  name: string
  title: string
  layout: string
  cylinders: number
  cycle: string
}
/** A derivation: HTML with MathML, every name in it escaped. */
export interface DerivationShown {
  html: string
}
/** An engine with weights and balance shafts as an exhibit, or null where nothing is needed. */
export interface FittedShown {
  exhibit: Exhibit | null
}
/** How far a search has come, and what it found. */
export interface SearchShown {
  id: string
  state: 'running' | 'done' | 'cancelled' | 'failed'
  /** blocks that were searched */
  done: number
  /** of so many; 0 until that is known */
  blocks: number
  /** how fast it is and how long it will take yet, or why it failed */
  note: string
  heads: string[]
  rows: Found[]
  /** what was asked, and what proves that the answer is complete */
  sentences: string[]
}
/** A row of what a search found. */
export interface Found {
  cells: string[]
  /** the engine file that it makes */
  tree: Record<string, unknown>
}
/** An engine file. */
export interface TomlShown {
  toml: string
}
/** An engine file as a tree of keys. */
export interface TreeShown {
  tree: Record<string, unknown>
}
/** The file that the server watches: its engine, and the mistakes that it has at present. */
export interface WatchedShown {
  /** grows with every change; 0: no file is watched */
  version: number
  /** its name, without its directory */
  file?: string
  /** its engine, as it was when it last had no mistake */
  tree?: Record<string, unknown> | null
  /** what is wrong with it now */
  problems?: Problem[]
}
/** A usual layout: its engine file, and what a small picture of it shows. */
export interface Preset {
  key: string
  label: string
  group: string
  tree: Record<string, unknown>
  cylinders: number
  /** bearings of the cylinder axes, each once */
  axes_deg: number[]
  /** bearings of the crank pins at theta = 0 */
  throws_deg: number[]
  radial: boolean
  shafts: number
}
/** The curves behind the sliders of an engine. */
export interface SlidersShown {
  sliders: Slider[]
}
/** The curves of a control. */
export interface Slider {
  key: string
  /** the value of the engine */
  present: number
  values: number[]
  curves: SliderCurve[]
  /** the same as crankstar sweep --over takes it */
  range: string
}
/** What an engine leaves over the range of a slider, at the `values` of its `Slider`. */
export interface SliderCurve {
  label: string
  /** as crankstar sweep --watch takes it */
  what: string
  order: number | null
  unit: string
  results: number[]
  /** at the present value of the slider */
  present: number
}
/** An engine on the bench: how many cylinders it may have, its cranks, orders, controls. */
export interface WorkshopShown {
  tree: Record<string, unknown>
  cylinders: number
  /** the next smaller number of cylinders */
  fewer: number | null
  /** the next greater number of cylinders */
  more: number | null
  /** what was decided, and what was left out */
  sentences: string[]
  cranks: OfferShown[]
  orders: OfferShown[]
  controls: Control[]
  /** of the first crankshaft, from front to rear */
  pins: Pin[]
}
/** An engine file one click away. */
export interface OfferShown {
  label: string
  tree: Record<string, unknown>
  /** whether it is the present one */
  chosen: boolean
}
/** A number of an engine that is changed directly, in `unit` ("" for a bare number). */
export interface Control {
  /** its key path, as crankstar sweep --over takes it */
  key: string
  label: string
  help: string
  value: number
  unit: string
  low: number
  high: number
  step: number
  /** values that a drag comes to rest at */
  snaps: number[]
  sets: Setting[]
  /** whether its slider has curves */
  swept: boolean
}
/** A key of the engine file that a control sets: to `factor` times its value, and `added`. */
export interface Setting {
  path: string
  factor: number
  added: number
}
/** A crank throw that can be turned: its key path, and the throws of its list as they stand. */
export interface Pin {
  path: string
  label: string
  /** what the file says: from pin 1 of its list, clockwise */
  angle_deg: number
  /** of the pin at theta = 0, clockwise from up */
  bearing_deg: number
  /** whether the others are counted from it */
  fixed: boolean
}
/** The weights and balance shafts to fit an engine with; by default the verdict's advice. */
export interface FittedQuestion {
  engine: string | {}
  /** as --units takes them; by default those of the server */
  units?: string | null
  /** balance factor of the counterweights */
  factor?: number | null
  /** where the counterweights go */
  weights?: ('pins' | 'webs' | 'ends') | null
  /** replace the counterweights of the file instead of adding to them */
  bare?: boolean
  /** which balance shafts */
  shafts?: ('none' | 'needed' | 'all') | null
}
/** The options of a search, of an in-line engine or of a number of cylinders. */
export interface SearchQuestion {
  /**
   * Working cycle: four-stroke or two-stroke. Default: that of the engine file, else four-stroke.
   */
  cycle?: ('two-stroke' | 'four-stroke') | null
  /**
   * Quantity to minimise. Several with commas: couples M1, M2, ... (M1V, M1H: the external moment in the vertical, in the horizontal plane), forces F1, ..., torsion T1.5, ..., guide-force moments that twist the frame X3, ..., neighbours (cylinders side by side that fire in succession), couple (rms over a turn of the couple of orders 1, 2, 4 and 6 of an engine); else M1,M2. In a list of the best with weights, as in M1,2*M2. On the command line also twist, the largest torsion of --orders, which also chooses the firing order.
   */
  minimise?: string | null
  /** Quantities that must vanish, as in M2. */
  zero?: string | null
  /**
   * Greatest permissible value of a quantity, as in QUANTITY=VALUE, with a unit or in that of the result; repeatable. Such as M2=1.5, M1V="800 kN m" or neighbours=1.
   */
  limit?: string[]
  /** Gaps between cylinders from the front in pitches, as in 1,1,1.4; else equal. */
  gaps?: string | null
  /** Fixed throws, as in 1=0,4=3: direction d is 360 d/n deg behind direction 0. */
  fix?: string | null
  /** Only cranks whose rear half mirrors the front half. */
  symmetric?: boolean
  /**
   * For torsion: straight, mode N of the engine's [torsion], or the amplitude at each cylinder (default: its mode, if it has that table).
   */
  mode_shape?: string | null
  /** No cylinders side by side fire in succession. */
  avoid_adjacent?: boolean
  /** The Pareto front: where one quantity can improve only at the expense of another. */
  front?: boolean
  /** List this many of the best stars. */
  best?: number | null
  /** All stars within the limits. */
  all?: boolean
  /**
   * All stars with the same moments as a firing order, as in 1-6-3-4-5-2-7, or with values, as in M1=0.2673,M2=1.0056.
   */
  all_with?: string | null
  /** an in-line engine whose cylinders they are */
  engine?: (string | {}) | null
  /** the number of cylinders, where there is no engine */
  cylinders?: number | null
}
