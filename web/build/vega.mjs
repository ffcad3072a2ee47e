/**
 * What the figures need of Vega, in place of the package `vega`: maps, forces, trees and word clouds
 * would be 180 kB more.
 */
import { transforms } from 'vega-dataflow'
import * as encode from 'vega-encode'
import * as basic from 'vega-transforms'
import * as layout from 'vega-view-transforms'

Object.assign(transforms, basic, layout, encode)

export { loader } from 'vega-loader'
export { parse } from 'vega-parser'
export * from 'vega-util'
export { View } from 'vega-view'
