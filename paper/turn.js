'use strict';

// The figures that one can turn, from the operations of client.js and what the build left in vectors.js: `golden`, tables
// of golden vectors by operation, and `certified`, the linear motion of Figure 5(a), as text. Plain SVG.

// ---- whether this browser computes what was proved ----

const rows = (text) => {
  const [names, ...lines] = text.trim().split('\n').map((line) => line.split(','));
  return lines.map((cells) => Object.fromEntries(names.map((name, i) => [name, cells[i]])));
};

// An algebraic result may err by 8 units of u (|y| + S), as the library may, of u |y| where S is infinite; a motion is good to
// 9 digits of its largest part; of roots each true one has to have one of them so near, a double one the square root of that.
const passes = (id, row) => {
  const names = Object.keys(row), n = operations[id].letters.length;
  const said = answer(id, names.slice(1, 1 + n).map((name) => row[name]));
  if (row.flags.includes('invalid')) return said === 'invalid';
  const outputs = names.slice(1 + n).filter((name) => !/^S_|^flags$/.test(name));
  const exact = outputs.map((name) => number(row[name])), got = said.split(' ').map(Number);
  const size = max(...exact.map(abs)), S = outputs.map((name) => number((row[`S_${name}`] ?? '0').toLowerCase()));
  const double = id === 'eq41roots' && S.includes(Infinity), units = 8 * 2 ** -53 * (size + max(...S.filter(Number.isFinite), 0));
  const bound = id.startsWith('flow') ? 1e-9 * size : double ? sqrt(units * size) : units;
  const near = (i, k, width) => hypot(...exact.slice(i, i + width).map((y, j) => got[k + j] - y)) <= bound;
  if (id !== 'eq41roots') return got.length === exact.length && exact.every((_, i) => near(i, i, 1));
  return [0, 2, 4, 6].every((i) => [0, 2, 4, 6].some((k) => near(i, k, 2)));
};

const selfCheck = () => {
  const all = Object.entries(golden).flatMap(([id, text]) => rows(text).map((row) => [row.id, passes(id, row)]));
  return { count: all.length, failed: all.filter(([, passed]) => !passed).map(([name]) => name) };
};

// ---- drawing ----

// Lines [[x, y], ...] with a class each, in a frame of these bounds.
const WIDTH = 640, HEIGHT = 260, LEFT = 70, BOTTOM = 36;
const draw = (element, [x0, x1], [y0, y1], xTitle, yTitle, lines) => {
  const X = (x) => LEFT + (x - x0) / (x1 - x0) * (WIDTH - LEFT - 10);
  const Y = (y) => HEIGHT - BOTTOM - (y - y0) / (y1 - y0) * (HEIGHT - BOTTOM - 12);
  const marks = (low, high) => [0, 1, 2, 3, 4].map((i) => low + i / 4 * (high - low));
  const text = (x, y, words, rest = '') => `<text x="${x}" y="${y}" ${rest}>${words}</text>`;
  const short = (value) => Number(value.toPrecision(3)).toString();
  element.innerHTML = `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${yTitle} against ${xTitle}">`
    + marks(x0, x1).map((x) => text(X(x), HEIGHT - BOTTOM + 16, short(x), 'text-anchor="middle"')).join('')
    + marks(y0, y1).map((y) => `<line class="grid" x1="${LEFT}" x2="${WIDTH - 10}" y1="${Y(y)}" y2="${Y(y)}"/>`
      + text(LEFT - 6, Y(y) + 4, short(y), 'text-anchor="end"')).join('')
    + text((LEFT + WIDTH) / 2, HEIGHT - 4, xTitle, 'text-anchor="middle"')
    + text(0, 0, yTitle, `text-anchor="middle" transform="translate(14 ${HEIGHT / 2 - 10}) rotate(-90)"`)
    + lines.map(([kind, points]) => (points.length === 1
      ? `<circle class="${kind}" cx="${X(points[0][0])}" cy="${Y(points[0][1])}" r="5"/>`
      : `<path class="${kind}" d="M${points.map(([x, y]) => `${X(x).toFixed(1)} ${Y(min(max(y, y0), y1)).toFixed(1)}`).join('L')}"/>`)).join('')
    + '</svg>';
};

// ---- the figures, in units of Omega and L_ref where they can be ----

const Omega = 7.2915e-5, k_c = 8.99e9, L_ref = 10, m1 = 150, DAYS = 3, SAMPLES = 180;
const compute = (id, ...inputs) => operations[id].compute(...inputs);
const range = (low, high, count) => Array.from({ length: count + 1 }, (_, i) => low + i / count * (high - low));

const roots = (n, c2) => {
  const z = compute('eq41roots', 1, n, c2);
  return [0, 2, 4, 6].map((i) => [z[i], z[i + 1]]);
};
const slowest = (n, c2) => max(...roots(n, c2).map(([re]) => re));

// The curves that no slider moves.
const rates = ((gains) => [(m) => compute('eq44', 1, m), () => 4].map((c2) => gains.map((m) => [m, slowest(m, c2(m))])))(range(9.001, 40, 150));

const drawRoots = ({ n, c2 }) => {
  const byRule = compute('eq44', 1, n), chosen = c2 ?? byRule;
  draw(document.getElementById('turn-rate'), [9, 40], [-1.1, 0], 'n', 'slowest root / Ω', [
    ['first', rates[0]],
    ['second', rates[1]],
    ['mark', [[n, slowest(n, chosen)]]],
  ]);
  draw(document.getElementById('turn-roots'), [-6, 1], [-3, 3], 'real part / Ω', 'imaginary part / Ω', [
    ['axis', [[0, -3], [0, 3]]],
    ...roots(n, chosen).map((z) => ['mark', [z]]),
  ]);
  document.getElementById('turn-said').textContent = `n = ${n}, C2 = ${chosen.toFixed(3)} Ω${c2 === null ? ' by (44)' : ''}: `
    + `the slowest root decays at ${(-slowest(n, chosen)).toFixed(4)} Ω.`;
};

// Linear and nonlinear motion, sample by sample.
const motions = ({ n, c2, psi, theta, dL, ratio }) => {
  const C1 = compute('eq43', Omega, n), C2 = (c2 ?? compute('eq44', 1, n)) * Omega, m2 = ratio * m1, h = DAYS * 86400 / SAMPLES;
  let linear = [psi, theta, dL, 0, 0, 0], place = [...compute('eq10', m1, m2, L_ref + dL, psi, theta), 0, 0, 0];
  const samples = [];
  for (let i = 0; i <= SAMPLES; i++) {
    const [L, angle, pitch] = place ? compute('eq10inv', m1, m2, ...place.slice(0, 3)) : [NaN, NaN, NaN];
    samples.push({ day: i * DAYS / SAMPLES, linear, nonlinear: [angle, pitch, L - L_ref] });
    linear = compute('flow_linear', Omega, L_ref, C1, C2, h, ...linear);
    try {
      place = place && compute('flow_nonlinear', Omega, k_c, m1, m2, L_ref, C1, C2, h, ...place);
    } catch (error) {
      place = null; // lost: the craft meet or part without bound
    }
  }
  return samples;
};

const drawMotion = (state) => {
  const samples = motions(state), paper = state.n === 10 && state.c2 === null && state.psi === 0.01 && state.theta === 0.01 && state.dL === 0.1;
  [['turn-psi', 0, 'yaw [rad]', 'psi'], ['turn-theta', 1, 'pitch [rad]', 'theta'], ['turn-dL', 2, 'length error [m]', 'dL']].forEach(([id, k, title, name]) => {
    const of = (kind) => samples.filter((s) => abs(s[kind][k]) < 1e3).map((s) => [s.day, s[kind][k]]);
    const known = paper ? rows(certified).map((row) => [row.t / 86400, Number(row[name])]) : [];
    const bound = 1.1 * min(max(1e-6, ...of('linear').map(([, y]) => abs(y)), ...of('nonlinear').map(([, y]) => abs(y))), k === 2 ? 30 : 4);
    draw(document.getElementById(id), [0, DAYS], [-bound, bound], 'days', title,
      [['pale', known], ['second', of('linear')], ['first', of('nonlinear')]].filter(([, points]) => points.length > 1));
  });
};

// ---- what one turns: an input each, from the address where it says so (#n=20&dL=-2) ----

const controls = [ // name, label, least, most, step, value
  ['n', 'n = C1/Ω²', 9, 40, 0.1, 10], ['c2', 'C2/Ω (leftmost: by (44))', 0, 8, 0.1, 0], ['psi', 'initial yaw [rad]', -1, 1, 0.01, 0.01],
  ['theta', 'initial pitch [rad]', -1, 1, 0.01, 0.01], ['dL', 'initial length error [m]', -4, 4, 0.1, 0.1], ['ratio', 'm2/m1', 0.1, 10, 0.1, 1],
];

const begin = () => {
  const asked = new URLSearchParams(location.hash.slice(1)), inputs = {};
  for (const [name, label, least, most, step, value] of controls) {
    const line = document.createElement('label'), output = document.createElement('output');
    inputs[name] = Object.assign(document.createElement('input'), { type: 'range', min: least, max: most, step, id: `turn-${name}-input` });
    inputs[name].value = asked.get(name) ?? value;
    line.append(`${label} `, inputs[name], output);
    document.getElementById('turn').append(line);
  }
  const redraw = () => {
    const state = Object.fromEntries(Object.entries(inputs).map(([name, input]) => [name, Number(input.value)]));
    for (const input of Object.values(inputs)) input.nextSibling.textContent = input.value;
    if (state.c2 === 0) state.c2 = null;
    drawRoots(state);
    drawMotion(state);
  };
  document.getElementById('turn').addEventListener('input', redraw);
  redraw();
  setTimeout(() => { // a second's work, when all is drawn
    const { count, failed } = selfCheck();
    document.getElementById('turn-check').textContent =
      `${count - failed.length} of ${count} vectors passed in this browser${failed.length ? `, not ${failed.join(' ')}` : ''}.`;
  }, 50);
};

begin();
