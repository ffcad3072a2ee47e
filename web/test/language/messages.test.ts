import { afterEach, expect, test } from 'vitest'
import { resource } from '../../build/catalogs.mjs'
import { language, plural, t } from '../../src/language/messages'

const mistakes = (count: number): string =>
  plural('{count} mistake', '{count} mistakes', count, { count })

afterEach(() => {
  language.value = 'en'
})

test('a sentence is shown in English with its values where no catalog translates it', () => {
  language.value = 'ru'
  expect(t('Order {order}: {path}.', { order: 2, path: 'a $t(circle), {not} a value' })).toBe(
    'Order 2: a $t(circle), {not} a value.',
  )
  language.value = 'xx'
  expect(language.value).toBe('en')
})

test('an English number has two forms, a Russian one three, a Japanese one one', () => {
  expect([1, 2, 0].map(mistakes)).toEqual(['1 mistake', '2 mistakes', '0 mistakes'])
  language.value = 'ru-RU'
  expect([1, 2, 5, 11, 21, 104].map(mistakes)).toEqual([
    '1 ошибка',
    '2 ошибки',
    '5 ошибок',
    '11 ошибок',
    '21 ошибка',
    '104 ошибки',
  ])
  language.value = 'ja'
  expect([1, 2].map(mistakes)).toEqual(['1 件の誤り', '2 件の誤り'])
})

test('a count without a translation, or with some of its forms only, has the English form', () => {
  language.value = 'ru'
  const bolts = (count: number): string => plural('{count} bolt', '{count} bolts', count, { count })
  expect([1, 2, 5, 21].map(bolts)).toEqual(['1 bolt', '2 bolts', '5 bolts', '21 bolts'])
  const half = 'msgid "a nut"\nmsgid_plural "nuts"\nmsgstr[0] "гайка"\nmsgstr[1] ""\nmsgstr[2] ""\n'
  const header = 'msgid ""\nmsgstr "Language: ru\\n"\n\n'
  expect(resource(`${header}msgid "bolt"\nmsgstr "болт"\n\n${half}`)).toEqual({ bolt: 'болт' })
})
