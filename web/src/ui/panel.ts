import type { ComponentType } from 'preact'
import type { App } from '../app'

/**
 * A panel beside the stage, declared whole in one file of `panels/`: its name in links and tests,
 * its label, what it shows, and when there is anything to show. What a reader chooses in it goes
 * into links with `useChoice`.
 */
export interface Panel {
  readonly key: string
  readonly label: string
  readonly Content: ComponentType
  /** Whether there is anything to show; without it, always. */
  readonly when?: (app: App) => boolean
  /** Whether it shows all engines on the stage at once, not one that is chosen above it. */
  readonly ofAll?: boolean
}
