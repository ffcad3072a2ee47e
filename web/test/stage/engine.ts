import type { CylinderShown, Exhibit, ShaftShown, StrokeColours } from '../../src/exhibit'

/** A shaft with nothing on it. */
export function shaft(changes: Partial<ShaftShown> = {}): ShaftShown {
  return {
    name: 'crank',
    kind: 'crankshaft',
    speed_ratio: 1,
    up: 0,
    right: 0,
    z_from: -1,
    z_to: 2,
    journal_radius: 0.2,
    throws: [],
    webs: [],
    weights: [],
    ...changes,
  }
}

export function cylinder(changes: Partial<CylinderShown> = {}): CylinderShown {
  return {
    number: 1,
    shaft: 0,
    throw: 0,
    throw_angle: 0,
    crank_radius: 1,
    bearing: 0,
    z: 0,
    offset: 0,
    rod_length: 4,
    master: -1,
    knuckle_radius: 0,
    knuckle_angle: 0,
    rod: 'plain',
    rod_z: 0,
    rod_width: 0.4,
    bore: 2,
    pin_height: 1,
    skirt: 1,
    bore_from: 2,
    bore_to: 6.2,
    chamber: 1,
    ...changes,
  }
}

/** Colours of the strokes that no palette has. */
export const COLOURS: StrokeColours = {
  intake: '#0000ff',
  compression: '#00ff00',
  power: '#ff0000',
  exhaust: '#808080',
}

/** An exhibit of one order whose forces and response are given. */
export function exhibit(changes: Partial<Exhibit> = {}): Exhibit {
  const none = { forward: [[0, 0]], backward: [[0, 0]] } as Exhibit['total']['force']
  return {
    name: 'test',
    file: {},
    cycle_deg: 720,
    turns: 2,
    relative: [],
    weight_throws: [],
    sense: 1,
    speed_rpm: null,
    units: {
      chosen: 'si',
      force: 'N',
      couple: 'N m',
      roll: 'N m',
      length: 'm',
      force_factor: 1,
      couple_factor: 1,
      roll_factor: 1,
      counted: ['N', 'N m'],
      lengths: [
        { label: 'µm', factor: 1e6 },
        { label: 'mm', factor: 1e3 },
      ],
      mass: { label: 'kg', factor: 1 },
      inertia: { label: 'kg m²', factor: 1 },
      pressure: { label: 'bar', factor: 1e-5 },
      power: { label: 'kW', factor: 1e-3 },
    },
    estimated: [],
    can_estimate: false,
    ends: [],
    scale: { length: 1, force: 1, couple: 1, roll: 1 },
    heading: [],
    unverified: [],
    reference_z: 0,
    couple_length: 1,
    orders: [1],
    total: { force: none, couple: none, roll: [[0, 0]], torque: [[0, 0]] },
    cylinders: [{ number: 1, bank: '1', z: 0, force: none }],
    bearings: { orders: [1], model: '', loads: [] },
    bearing_numbers: {
      bearing_unit: 'N',
      pin_unit: 'N',
      greatest: [],
      estimated: false,
      tables: [],
      about: [],
    },
    gas_bearings: null,
    gas_bearing_numbers: null,
    whirl: {
      centre: [0.3, 0.1, 0.5],
      mass: 1,
      inertia: [1, 1, 1],
      shift: none,
      tilt: none,
      turn: [[0, 0]],
      assumed: [],
    },
    whirl_ends: [],
    scene: {
      length_unit: 'm',
      low: [-2, -2, -1],
      high: [7, 2, 2],
      shafts: [shaft()],
      gears: [],
      cylinders: [cylinder()],
      assumed: [],
    },
    table: [],
    verdict: [],
    strokes: [],
    stroke_windows: [],
    torque: null,
    torque_unit: { label: 'N m', factor: 1 },
    gas_needs: '',
    exhaust: null,
    torsion: null,
    torsion_numbers: null,
    torsion_needs: '',
    charts: [],
    derivations: [],
    remedies: [],
    ...changes,
  }
}
