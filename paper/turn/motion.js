// Figures 5 to 7: the linear and the nonlinear motion from one start, and the charges.

const DAYS = 3, SAMPLES = 240;

// Craft 1 in the Hill frame from here on, a state each STEP seconds, as long as it can be followed.
const STEP = DAYS * 86400 / SAMPLES;
const nonlinearMotion = ({ n, c2, ratio }, start) => {
  const states = [start];
  try {
    while (states.length <= SAMPLES) {
      states.push(compute('flow_nonlinear', Omega, k_c, m1, ratio * m1, L_ref, n * Omega ** 2, c2 * Omega, STEP, ...states.at(-1)));
    }
  } catch (error) { /* the craft have met, or parted without bound */ }
  return states;
};
const linearMotion = ({ n, c2 }, start) => {
  const states = [start];
  while (states.length <= SAMPLES) states.push(compute('flow_linear', Omega, L_ref, n * Omega ** 2, c2 * Omega, STEP, ...states.at(-1)));
  return states;
};

// Angles and length error, and the charge of craft 1 [uC]: none where the law asks for a push.
const shape = (m2, [x1, y1, z1]) => {
  const [L, psi, theta] = compute('eq10inv', m1, m2, x1, y1, z1);
  return [psi, theta, L - L_ref];
};
const charge = ({ n, c2, ratio }, dL, dL_dot) => {
  const m2 = ratio * m1, dQ = compute('eq18', k_c, m1, m2, L_ref, n * Omega ** 2, c2 * Omega, dL, dL_dot);
  try {
    return 1e6 * compute('eq21', compute('eq07', Omega, k_c, m1, m2, L_ref), dQ)[0];
  } catch (error) {
    return NaN;
  }
};
const rateOfLength = (m2, [x1, y1, z1, ...v]) => (m1 + m2) / m2 * (x1 * v[0] + y1 * v[1] + z1 * v[2]) / hypot(x1, y1, z1);

// What the build certified, where the sliders stand as in the paper: linear angles, nonlinear places, charges.
const PAPER = { n: 10, c2: 2, psi: 0.01, theta: 0.01, dL: 0.1, ratio: 1 };
const isPaper = (state) => Object.entries(PAPER).every(([name, value]) => state[name] === value);
const numbers = (text) => rows(text).map((row) => Object.values(row).map(Number));
const certifiedMotion = { linear: numbers(certified.figure5a), nonlinear: numbers(certified.figure6), charge: numbers(certified.figure7a) };

const drawMotion = (state) => {
  const { psi, theta, dL, ratio, hill } = state, m2 = ratio * m1;
  const linear = linearMotion(state, [psi, theta, dL, 0, 0, 0]);
  const nonlinear = nonlinearMotion(state, [...compute('eq10', m1, m2, L_ref + dL, psi, theta), 0, 0, 0]);
  const day = (i) => i * STEP / 86400, known = isPaper(state) ? certifiedMotion : { linear: [], nonlinear: [], charge: [] };
  // Either in the angles, or in the places of craft 1 by (10): each picture its own.
  const [ofLinear, ofNonlinear] = hill ? [([a, b, c]) => compute('eq10lin', m1, m2, L_ref + c, a, b), (y) => y.slice(0, 3)]
    : [(y) => y.slice(0, 3), (y) => shape(m2, y)];
  const titles = hill ? ['x1 [m]', 'y1 [m]', 'z1 [m]'] : ['yaw [rad]', 'pitch [rad]', 'length error [m]'];
  ['turn-psi', 'turn-theta', 'turn-dL'].forEach((id, k) => {
    const lines = [nonlinear.map((y, i) => [day(i), ofNonlinear(y)[k]]), linear.map((y, i) => [day(i), ofLinear(y)[k]])];
    const limit = hill ? 3 * L_ref : k === 2 ? 3 * L_ref : 4, values = lines.flat().map(([, y]) => y).filter((y) => abs(y) <= limit);
    const [low, high] = [min(...values), max(...values)], pad = max(0.06 * (high - low), 1e-4);
    plot(place(id), { x: [0, DAYS], y: [low - pad, high + pad], titles: ['days', titles[k]] }, [
      ['pale', known.nonlinear.map(([t, ...y]) => [t / 86400, ofNonlinear(y)[k]])],
      ['pale', known.linear.map(([t, ...y]) => [t / 86400, ofLinear(y)[k]])],
      ['second', lines[1]], ['first', lines[0]],
    ]);
  });
  const charges = [nonlinear.map((y, i) => [day(i), charge(state, shape(m2, y)[2], rateOfLength(m2, y))]),
    linear.map((y, i) => [day(i), charge(state, y[2], y[5])])].map((line) => line.filter(([, q]) => q === q));
  const all = charges.flat().map(([, q]) => q).filter((q) => q < 100);
  plot(place('turn-charge'), { x: [0, DAYS], y: [min(...all) - 0.01, max(...all) + 0.01], titles: ['days', 'q1 = −q2 [µC]'] }, [
    ['pale', known.charge.map(([t, q]) => [t / 86400, q])], ['second', charges[1]], ['first', charges[0]],
  ]);
  const end = shape(m2, nonlinear.at(-1));
  place('turn-moved').textContent = nonlinear.length <= SAMPLES ? `The craft meet or part after ${day(nonlinear.length - 1).toFixed(2)} days.`
    : `After three days: yaw ${end[0].toPrecision(3)} rad, pitch ${end[1].toPrecision(3)} rad, length error ${end[2].toPrecision(3)} m.`
      + (charges[0].length < nonlinear.length ? ' Where the curve of the charge is open the law asks for a push, which no charges of opposite sign give.' : '');
};
