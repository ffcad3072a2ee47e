import { signal } from '@preact/signals'
import { createInstance, type TOptions } from 'i18next'
import ja from './ja.po'
import ru from './ru.po'

/** Languages the page can be shown in; what a catalog does not translate is shown in English. */
const CATALOGS = { ja, ru }
const SPACE = 'translation'

const translator = createInstance()
void translator.init({
  lng: 'en',
  initAsync: false,
  resources: {},
  // an English sentence is its own key: no point or colon in it has a meaning
  keySeparator: false,
  nsSeparator: false,
  interpolation: { prefix: '{', suffix: '}', escapeValue: false },
})

const chosen = signal('en')
/** Sentences without values in that language: a page shows hundreds, again with every edit. */
const plain = new Map<string, string>()

/** The language of the page; a component that shows a message is drawn again when it changes. */
export const language = {
  get value() {
    return chosen.value
  },
  /** `en`, `ja`, `ru`, or one of them with a region; English for every other. */
  set value(wanted: string) {
    const code = wanted.split('-')[0]
    const known = code === 'ja' || code === 'ru' ? code : 'en'
    if (known !== 'en' && !translator.hasResourceBundle(known, SPACE))
      translator.addResourceBundle(known, SPACE, CATALOGS[known]())
    void translator.changeLanguage(known)
    plain.clear()
    chosen.value = known
  },
}

type Names<Text extends string> = Text extends `${string}{${infer Name}}${infer Rest}`
  ? Name | Names<Rest>
  : never
type Values<Text extends string> = [Names<Text>] extends [never]
  ? []
  : [values: Readonly<Record<Names<Text>, string | number>>]

function translated(text: string, options?: TOptions): string {
  void chosen.value // who shows it is drawn again in another language
  if (options) return translator.t(text, options)
  const sentence = plain.get(text) ?? translator.t(text)
  plain.set(text, sentence)
  return sentence
}

/** The sentence in the language of the page, with a value for each `{name}` in it. */
export function t<Text extends string>(text: Text, ...[values]: Values<Text>): string {
  return translated(text, values && { replace: values })
}

/** One of two sentences, or of as many as the language has, by a number that both may show. */
export function plural<Text extends string>(
  one: string,
  many: Text,
  count: number,
  ...[values]: Values<Text>
): string {
  // also for want of a translation, where the language has other forms than English
  const defaultValue = count === 1 ? one : many
  return translated(one, { count, replace: values ?? {}, defaultValue })
}

/** Marks a sentence for the extractor; `t` translates it where it is shown. */
export const message = <Text extends string>(text: Text): Text => text
