/** Colour of a cell: by outcome, or by a figure from its least to its largest; read on both backgrounds. */

const OUTCOMES = { walked: "#2b8a4b", fell: "#c0392b", fault: "#7d3c98", limit: "#b9770e", interrupted: "#5b6875" };
const RAMP = [[38, 70, 130], [46, 125, 170], [60, 150, 110], [200, 140, 40], [190, 60, 45]];

export function outcomeColour(outcome) {
  return OUTCOMES[outcome] ?? "#b9770e";
}

/** @param {number} share  0 to 1 */
export function rampColour(share) {
  const at = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1);
  const low = Math.min(Math.floor(at), RAMP.length - 2);
  const mixed = RAMP[low].map((value, i) => Math.round(value + (RAMP[low + 1][i] - value) * (at - low)));
  return `rgb(${mixed.join(",")})`;
}

/** Share of the rows of a cell that walked, between the two outcomes' colours. */
export function shareColour(share) {
  if (share === 1) return OUTCOMES.walked;
  return share === 0 ? OUTCOMES.fell : `color-mix(in srgb, ${OUTCOMES.walked} ${Math.round(100 * share)}%, ${OUTCOMES.fell})`;
}
