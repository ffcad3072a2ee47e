import type { ComponentType } from 'preact'
import { Subject, useApp } from './context'

/** A part of a panel for each of the engines that the panels show, named where there are two. */
export function Each({ Part }: { Part: ComponentType }) {
  const { subjects, shown } = useApp()
  const several = subjects.value.length > 1
  return (
    <div class={several ? 'each' : ''}>
      {subjects.value.map((place) => (
        <Subject.Provider key={place} value={place}>
          {several ? (
            <section class="of-engine" aria-label={shown.value[place]?.name}>
              <h3 class="whose">{shown.value[place]?.name}</h3>
              <Part />
            </section>
          ) : (
            <Part />
          )}
        </Subject.Provider>
      ))}
    </div>
  )
}
