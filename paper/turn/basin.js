// The energy of a start at rest, in units of Omega and L_ref, over the places of craft 1 in the orbit's plane (s along the
// track) or upright (s across it): its contours, the basin up to the separatrix level, and a start that one drags.

const potential = (n, upright) => (x, s) => {
  const r = hypot(x, s);
  return (upright ? s * s : 0) / 2 - 1.5 * x * x + (n - 3) / r + n * Math.log(r);
};
// The radial equilibria are r = 1 and this one, the end of the basin for n > 9; the level there is the separatrix's.
const outerEquilibrium = (n) => (sqrt(12 * n - 27) - 3) / 6;

// The curve f = level over a grid of values, segment by segment: marching squares.
const contour = (xs, ss, values, level) => {
  const points = [];
  for (let i = 0; i + 1 < xs.length; i++) {
    for (let j = 0; j + 1 < ss.length; j++) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(([a, b]) => [xs[a], ss[b], values[a][b] - level]);
      const crossed = corners.flatMap(([x, s, v], k) => {
        const [x1, s1, v1] = corners[(k + 1) % 4];
        return v < 0 === v1 < 0 ? [] : [[x + (x1 - x) * v / (v - v1), s + (s1 - s) * v / (v - v1)]];
      });
      for (let k = 0; k + 1 < crossed.length; k += 2) points.push(crossed[k], crossed[k + 1], null);
    }
  }
  return points;
};

// The window about the basin, and what is drawn in it whatever the start.
const landscape = (n, upright) => {
  const V = potential(n, upright), end = outerEquilibrium(n), level = V(end, 0);
  const inner = range(0.02, 1, 490).find((x) => V(x, 0) < level) ?? 1;
  const wide = V(0.01, 1 - 3 / n) < level ? end * 1.25 : max(0.75 * (end - inner), 0.06);
  const centre = V(0.01, 1 - 3 / n) < level ? 0 : (inner + end) / 2;
  const xs = range(centre - wide, centre + wide, 72), ss = range(-wide, wide, 72);
  const values = xs.map((x) => ss.map((s) => V(x, s)));
  const h = xs[1] - xs[0], basin = xs.flatMap((x, i) => ss.filter((s, j) => values[i][j] < level && hypot(x, s) < end).map((s) => [x, s]));
  const step = (level - V(1, 0)) / 3;
  const turned = (points) => points.map((point) => point && [point[1], point[0]]); // s to the right, x upwards
  return { V, end, level, x: [-wide, wide], y: [centre - wide, centre + wide], shapes: [
    ['basin', turned(basin.flatMap(([x, s]) => [[x, s - h / 2], [x, s + h / 2], null]))],
    ...[-2, -1, 1, 2, 4, 7, 12, 20].map((k) => ['contour', turned(contour(xs, ss, values, level + k * step))]),
    ['separatrix', turned(contour(xs, ss, values, level))],
  ] };
};
let known = { key: '' };

// Draws the motion from the start [x, s]; returns the way back from the screen to a place.
const drawBasin = (state, [x, s]) => {
  const { n, ratio, upright } = state, key = `${n} ${upright}`;
  if (known.key !== key) known = { key, ...landscape(n, upright) };
  const arm = ratio / (1 + ratio) * L_ref, start = upright ? [x, 0, s] : [x, s, 0];
  const states = nonlinearMotion(state, [...start.map((part) => arm * part), 0, 0, 0]);
  const path = states.map((y) => [(upright ? y[2] : y[1]) / arm, y[0] / arm]);
  const back = plot(place('turn-basin'), { x: known.x, y: known.y, height: 420,
    titles: [`${upright ? 'across' : 'along'} the track / L_ref`, 'along the radius / L_ref'] }, [
    ...known.shapes,
    ['first', path],
    ['rest', [[0, 1]]],
    ['handle', [[s, x]]],
  ]);
  const energy = known.V(x, s), inside = n > 9 && energy < known.level && hypot(x, s) < known.end;
  const last = states.at(-1), L = hypot(...last.slice(0, 3)) / arm, lost = states.length <= SAMPLES || L > 2 * max(known.end, 1);
  place('turn-end').textContent = `Start: ${x.toFixed(3)} along the radius, ${s.toFixed(3)} ${upright ? 'across' : 'along'} the track; `
    + `energy ${energy.toFixed(5)}, separatrix level ${known.level.toFixed(5)}: ${inside ? 'inside the basin' : n > 9 ? 'outside the basin' : 'no basin, since n ≤ 9'}. `
    + `After three days ${lost ? 'the pair is lost' : `the length is ${L.toFixed(3)} L_ref, ${last[0] > 0 ? 'craft 1 above' : 'craft 1 below'}`}.`;
  return back;
};
