import { t } from '../language/messages'
import { Dialog } from './Dialog'
import { KeyList } from './keyList'

/** The keys, at the press of one. */
export function KeyDialog() {
  return (
    <Dialog name="keys" title={t('Keys')}>
      <KeyList />
    </Dialog>
  )
}
