// Figure 4 and the root locus, in units of Omega: what the gains n = C1/Omega^2 and c2 = C2/Omega do to the roots of (41).

const roots = (n, c2) => {
  const z = compute('eq41roots', 1, n, c2);
  return [0, 2, 4, 6].map((i) => [z[i], z[i + 1]]);
};
const slowest = (n, c2) => max(...roots(n, c2).map(([re]) => re));
const byRule = (n) => (n < 9 ? 0 : compute('eq44', 1, n));

// What no slider moves. The slowest pair of Figure 4 is in 1/s; beyond its last n nothing is certified.
const allN = [...range(9, 10, 20), ...range(10.1, 40, 299)];
const ruled = { decay: allN.map((n) => [n, slowest(n, byRule(n))]), locus: allN.map((n) => roots(n, byRule(n))) };
const certifiedDecay = rows(certified.figure4).map((row) => [Number(row.n), Number(row.re1) / Omega]);

// The roots come sorted by their real parts, so that the loci are drawn as dots.
const drawGains = ({ n, c2 }) => {
  const now = roots(n, c2), free = allN.map((m) => roots(m, c2));
  const worst = slowest(n, c2);
  plot(place('turn-rate'), { x: [5, 40], y: [-1.1, 0.4], titles: ['n = C1/Ω²', 'slowest root / Ω'] }, [
    ['axis', [[5, 0], [40, 0]]],
    ['pale', certifiedDecay],
    ['first', ruled.decay],
    ['second', allN.map((m, i) => [m, max(...free[i].map(([re]) => re))])],
    ['mark', [[n, worst]]],
  ]);
  plot(place('turn-roots'), { x: [-4, 1], y: [-3, 3], titles: ['real part / Ω', 'imaginary part / Ω'], height: 300 }, [
    ['axis', [[0, -3], [0, 3]]],
    ['dots second', free.flat().flatMap((z) => [z, z, null])],
    ['dots first', ruled.locus.flat().flatMap((z) => [z, z, null])],
    ...now.map((z) => ['mark', [z]]),
  ]);
  place('turn-said').textContent = `n = ${n}, C2 = ${c2.toFixed(3)} Ω: ${worst < 0 ? `the slowest root decays at ${(-worst).toFixed(4)} Ω, by a factor of e in `
    + `${(-1 / worst / Omega / 3600).toFixed(1)} h` : 'not stable: (42) asks for n > 9 and C2 > 0'}.`;
};
