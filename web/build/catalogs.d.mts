/** Sentences by their English, from a catalog; for the tests. */
export function resource(text: string): Record<string, string>
