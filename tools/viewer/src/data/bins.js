/** Where bins are missing, one empty bin for each quarter of a doubling. */
export function withEmptyBins(bins) {
  return bins.flatMap((bin, i) => {
    const next = bins[i + 1];
    if (!next || next[0] <= bin[1] * 1.0001) return [bin];
    const missing = Math.max(1, Math.round(4 * Math.log2(next[0] / bin[1])));
    const edge = (k) => bin[1] * (next[0] / bin[1]) ** (k / missing);
    return [bin, ...Array.from({ length: missing }, (_, k) => [edge(k), edge(k + 1), 0])];
  });
}
