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
  /**
   * Whose it is: of `all` engines on the stage, whatever is chosen above it; `each`: once for each
   * that is chosen; without it, it asks for them itself (`useExhibits`).
   */
  readonly of?: 'all' | 'each'
}
