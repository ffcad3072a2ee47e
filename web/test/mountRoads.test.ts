/// <reference types="node" />
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import type { Mounts } from '../src/exhibit'
import { answerAt } from '../src/mountResponse'
import { PER_RPM, pointWaves } from '../src/mounts'
import type { Coefficients } from '../src/phasor'

/**
 * What Python says of an engine on its mounts; written by tests/methods/test_mounts_ts.py, which
 * runs this file.
 */
interface Road {
  name: string
  mounts: Mounts
  said: Said[]
}

type Wave = [number, number][]

interface Said {
  rpm: number
  motion: Wave[]
  forces: Wave[][]
  points: Wave[][]
  through: (number | null)[]
  heat: number[]
}

const file = process.env.CRANKSTAR_MOUNT_ROADS
const roads: Road[] = file ? JSON.parse(readFileSync(file, 'utf8')) : []
const CLOSE = 1e-9

describe.skipIf(!file).each(roads)('$name', ({ mounts, said }) => {
  test.each(said)('shakes as in Python at $rpm rpm', ({ rpm, motion, forces, points, ...told }) => {
    if (!mounts.driving) throw new Error('nothing drives it')
    const answer = answerAt(mounts, mounts.driving, rpm * PER_RPM, null)
    alike(answer.motion.slice(0, 3), motion.slice(0, 3))
    alike(answer.motion.slice(3, 6), motion.slice(3, 6))
    alike(answer.motion.slice(6, 9), motion.slice(6, 9))
    alike(answer.motion.slice(9), motion.slice(9))
    alike(answer.forces.flat(), forces.flat())
    const moved = mounts.points.map((point) => pointWaves(mounts, answer.motion, point))
    alike(moved.flat(), points.flat())
    close(answer.through.slice(0, told.through.length), told.through)
    close(answer.heat, told.heat)
  })
})

test.skipIf(file)('(compared with Python by tests/methods/test_mounts_ts.py)', () => {})

/** Waves of one kind, to a share of the greatest. */
function alike(waves: readonly Coefficients[], expected: readonly Wave[]): void {
  expect(waves.length).toBe(expected.length)
  const flat = waves.flatMap((wave) => Array.from(wave))
  close(flat, expected.flat(2))
}

function close(values: readonly (number | null)[], expected: readonly (number | null)[]): void {
  expect(values.length).toBe(expected.length)
  const most = Math.max(...expected.map((each) => Math.abs(each ?? 0)))
  values.forEach((value, place) => {
    const other = expected[place] ?? null
    if (other === null) expect(value).toBeNull()
    else expect(Math.abs((value as number) - other)).toBeLessThanOrEqual(CLOSE * most)
  })
}
