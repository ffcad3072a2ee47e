/** Small drawings on buttons; the words are the button's label. */
const PATHS = {
  play: 'M8 5v14l11-7z',
  stop: 'M7 5h4v14H7zM13 5h4v14h-4z',
  back: 'M15 6l-6 6 6 6',
  forth: 'M9 6l6 6-6 6',
  link: 'M10 14a4 4 0 0 0 5.7 0l3-3A4 4 0 0 0 13 5.300l-1.200 1.200M14 10a4 4 0 0 0-5.700 0l-3 3A4 4 0 0 0 11 18.700l1.200-1.200',
  light:
    'M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8zM12 2v3M12 19v3M2 12h3M19 12h3M5 5l2 2M17 17l2 2M19 5l-2 2M7 17l-2 2',
  dark: 'M20 14.500A8.500 8.500 0 1 1 9.500 4a7 7 0 0 0 10.500 10.500z',
  auto: 'M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM12 3v18M12 8h7M12 12h9M12 16h7',
  guide:
    'M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM9.500 9.500a2.500 2.500 0 1 1 3.600 2.200c-.800.500-1.100 1-1.100 1.800M12 16.500v.100',
  engines:
    'M4 4h6.500v6.500H4zM13.500 4H20v6.500h-6.500zM4 13.500h6.500V20H4zM13.500 13.500H20V20h-6.500z',
  export: 'M12 3v11M8 10l4 4 4-4M5 15v4h14v-4',
  present: 'M4 5h16v11H4zM12 16v4M8 20h8M3 5h18',
  full: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  force: 'M3 12h17M14 6l6 6-6 6',
  couple: 'M7 20V5M3 9l4-4 4 4M17 4v15M13 15l4 4 4-4',
  roll: 'M4 8a9 9 0 0 1 15 9M22.500 12.500l-3.500 5-5-3.500',
  layers: 'M12 4l9 5-9 5-9-5zM4 13.500l8 4.500 8-4.500',
} as const
export type IconName = keyof typeof PATHS
const FILLED: readonly IconName[] = ['play', 'stop']

export function Icon({ name }: { name: IconName }) {
  return (
    <svg
      class={`icon${FILLED.includes(name) ? ' filled' : ''}`}
      viewBox="0 0 24 24"
      aria-hidden="true"
      focusable="false"
    >
      <path d={PATHS[name]} />
    </svg>
  )
}
