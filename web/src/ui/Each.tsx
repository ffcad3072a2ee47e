import type { ComponentType } from 'preact'
import { Subject, useApp } from './context'

/** A part of a panel for each of the engines that the panels show, named where there are two. */
export function Each({ Part }: { Part: ComponentType }) {
  const { subjects, shown } = useApp()
  const several = subjects.value.length > 1
  return (
    <div class={several ? 'each' : 'stacked'}>
      {subjects.value.map((place) => (
        <Subject.Provider key={place} value={place}>
          {several ? (
            // no landmark: the stage of the engine is one of the same name
            // biome-ignore lint/a11y/useSemanticElements: a fieldset is for what is filled in
            <div role="group" class="of-engine stacked" aria-label={shown.value[place]?.name}>
              <h3 class="whose">{shown.value[place]?.name}</h3>
              <Part />
            </div>
          ) : (
            <Part />
          )}
        </Subject.Provider>
      ))}
    </div>
  )
}
