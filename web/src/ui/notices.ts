/** The licences of the packages in the bundle; the build puts their text in (licences.mjs). */
export const NOTICES = 'THIRD_PARTY_NOTICES'
