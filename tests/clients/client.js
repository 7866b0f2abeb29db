#!/usr/bin/env node
'use strict';

// The equations of a Coulomb tether formation in JavaScript, as a client of the oracle:
//
//     coulomb-tether conform -- node tests/clients/client.js
//
// An operation is a string and a function. The string has a letter for each input, saying what it may be:
// '+' positive, '0' not negative, '.' any finite number, 'i' positive or infinite. Units are SI. A function
// returns a number or an array of them, and throws OutsideDomain where the letters do not say all.

const { sin, cos, sqrt, exp, hypot, atan2, abs, sign, min, max, round } = Math;

class OutsideDomain extends Error {}

const demand = (condition) => { if (!condition) throw new OutsideDomain(); };

const dot = (a, b) => a.reduce((sum, a_i, i) => sum + a_i * b[i], 0);
const minus = (a, b) => a.map((a_i, i) => a_i - b[i]);
const cross = ([a1, a2, a3], [b1, b2, b3]) => [a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1];

const operations = {};
const equation = (id, letters, compute) => { operations[id] = { letters, compute }; return compute; };


// ---- the static formation ----

// (2) craft on the Clohessy-Wiltshire-Hill equations, their charges shielded by the plasma
const hill = (Omega, [x, , z], [x_dot, y_dot]) =>
  [2 * Omega * y_dot + 3 * Omega ** 2 * x, -2 * Omega * x_dot, -(Omega ** 2) * z];

equation('eq02', '++i+.......+.......+.......', (Omega, k_c, lambda_d, ...numbers) => {
  const craft = [0, 8, 16].map((i) => {
    const [m, q, ...state] = numbers.slice(i, i + 8);
    return { m, q, r: state.slice(0, 3), v: state.slice(3) };
  });
  return craft.flatMap((one) => {
    const a = hill(Omega, one.r, one.v);
    for (const other of craft.filter((c) => c !== one)) {
      const away = minus(one.r, other.r);
      const d = hypot(...away);
      demand(d > 0);
      const force = k_c * one.q * other.q * exp(-d / lambda_d) / d ** 3;
      away.forEach((component, i) => { a[i] += force / one.m * component; });
    }
    return a;
  });
});

// (4) the centre of mass is the origin
const eq04 = equation('eq04', '++...', (m1, m2, ...r1) => r1.map((component) => -m1 / m2 * component));

// (13) the distance from craft 1 alone
const eq13 = equation('eq13', '++...', (m1, m2, ...r1) => {
  const L = (m1 + m2) / m2 * hypot(...r1);
  demand(L > 0);
  return L;
});

// (3) craft 1 of a pair, with craft 2 from (4)
const eq03 = equation('eq03', '++++.......', (Omega, k_c, m1, m2, Q, ...state) => {
  const r1 = state.slice(0, 3);
  const away = minus(r1, eq04(m1, m2, ...r1));
  const force = k_c / m1 * Q / eq13(m1, m2, ...r1) ** 3;
  return hill(Omega, r1, state.slice(3)).map((a, i) => a + force * away[i]);
});

// (5), (7) where the static formation stands, and the charge product that holds it there
equation('eq05', '+++', (m1, m2, L) => [m2 / (m1 + m2) * L, -m1 / (m1 + m2) * L]);
const eq07 = equation('eq07', '+++++', (Omega, k_c, m1, m2, L) =>
  -3 * Omega ** 2 * L ** 3 / k_c * m1 * m2 / (m1 + m2));


// ---- the perturbed formation ----

// (9) rows of direction cosines
equation('eq09', '..', (psi, theta) => [
  cos(theta) * cos(psi), cos(theta) * sin(psi), -sin(theta),
  -sin(psi), cos(psi), 0,
  sin(theta) * cos(psi), sin(theta) * sin(psi), cos(theta),
]);

// (10), (11) craft 1 and its velocity, rho being its distance from the origin: exactly, then for small angles
equation('eq10', '+++..', (m1, m2, L, psi, theta) => {
  const rho = m2 / (m1 + m2) * L;
  return [rho * cos(theta) * cos(psi), rho * cos(theta) * sin(psi), -rho * sin(theta)];
});

equation('eq10lin', '+++..', (m1, m2, L, psi, theta) => {
  const rho = m2 / (m1 + m2) * L;
  return [rho, psi * rho, -theta * rho];
});

equation('eq11exact', '+++.....', (m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot) => {
  const share = m2 / (m1 + m2), rho = share * L, rho_dot = share * L_dot;
  const level = rho_dot * cos(theta) - rho * theta_dot * sin(theta);
  return [
    level * cos(psi) - rho * psi_dot * cos(theta) * sin(psi),
    level * sin(psi) + rho * psi_dot * cos(theta) * cos(psi),
    -rho_dot * sin(theta) - rho * theta_dot * cos(theta),
  ];
});

equation('eq11', '+++.....', (m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot) => {
  const share = m2 / (m1 + m2);
  return [share * L_dot, share * (psi * L_dot + psi_dot * L), -share * (theta * L_dot + theta_dot * L)];
});

// (10) the other way. Zero added makes -0 a 0: psi is pi, not -pi, on the negative x axis, and 0 on the z axis.
equation('eq10inv', '++...', (m1, m2, x1, y1, z1) =>
  [eq13(m1, m2, x1, y1, z1), atan2(y1 + 0, x1 + 0), atan2(-z1, hypot(x1, y1))]);

// (12) the distance between two craft
equation('eq12', '......', (...r) => {
  const L = hypot(...minus(r.slice(0, 3), r.slice(3)));
  demand(L > 0);
  return L;
});

// (14) solved for L_ddot, in which r^2 v^2 - (r.v)^2 is |r x v|^2
equation('eq14', '++++.......', (Omega, k_c, m1, m2, Q, ...state) => {
  const r1 = state.slice(0, 3), r = hypot(...r1);
  const v_across = hypot(...cross(r1, state.slice(3))) / r;
  return (m1 + m2) / m2 * (v_across ** 2 + dot(r1, eq03(Omega, k_c, m1, m2, Q, ...state))) / r;
});

// (15), (17) the distance and its error to first order
equation('eq15', '+++++..', (Omega, k_c, m1, m2, L, psi_dot, Q) =>
  (2 * Omega * psi_dot + 3 * Omega ** 2) * L + k_c / m1 * Q / L ** 2 * (m1 + m2) / m2);
equation('eq17', '+++++...', (Omega, k_c, m1, m2, L_ref, psi_dot, dL, dQ) =>
  2 * Omega * L_ref * psi_dot + 9 * Omega ** 2 * dL + k_c / m1 / L_ref ** 2 * (m1 + m2) / m2 * dQ);


// ---- the control law ----

// (18), (19) the charge product commanded, and what becomes of (17)
const eq18 = equation('eq18', '++++....', (k_c, m1, m2, L_ref, C1, C2, dL, dL_dot) =>
  m1 * m2 * L_ref ** 2 / ((m1 + m2) * k_c) * (-C1 * dL - C2 * dL_dot));
const eq19 = equation('eq19', '++.....', (Omega, L_ref, C1, C2, dL, dL_dot, psi_dot) =>
  -(C1 - 9 * Omega ** 2) * dL - C2 * dL_dot + 2 * Omega * L_ref * psi_dot);

// (20)-(22) charges; the absolute value in print would attract where the law commands to repel
equation('eq21', '..', (Q_ref, dQ) => {
  const Q = Q_ref + dQ;
  demand(Q < 0);
  return [sqrt(-Q), -sqrt(-Q)];
});


// ---- attitude ----

// (25)-(29) angular velocities and accelerations, in the body frame
equation('eq25', '+.', (Omega, theta) => [-Omega * sin(theta), 0, Omega * cos(theta)]);
equation('eq26', '...', (theta, psi_dot, theta_dot) => [-sin(theta) * psi_dot, theta_dot, cos(theta) * psi_dot]);
equation('eq27', '+...', (Omega, theta, psi_dot, theta_dot) =>
  [-sin(theta) * (psi_dot + Omega), theta_dot, cos(theta) * (psi_dot + Omega)]);
equation('eq28', '+...', (Omega, theta, psi_dot, theta_dot) => [-Omega * theta, theta_dot, psi_dot + Omega]);
equation('eq29', '+...', (Omega, theta_dot, theta_ddot, psi_ddot) => [-Omega * theta_dot, theta_ddot, psi_ddot]);

// (30) inertia of both craft, each with its own mass: the print has m1 in both terms
equation('eq30', '++......', (m1, m2, ...r) => {
  const inertia = (m, [x, y, z]) =>
    [m * (y * y + z * z), -m * x * y, -m * x * z, m * (x * x + z * z), -m * y * z, m * (x * x + y * y)];
  const second = inertia(m2, r.slice(3));
  return inertia(m1, r.slice(0, 3)).map((first, i) => first + second[i]);
});

// (32), (34) about an axis across the line of the craft, and its rate
equation('eq32', '+++', (m1, m2, L) => m1 * m2 / (m1 + m2) * L ** 2);
equation('eq34', '+++.', (m1, m2, L, L_dot) => 2 * m1 * m2 / (m1 + m2) * L * L_dot);

// (36)-(39) the centre of mass in the body frame, and the gravity gradient there with the inertia of (31)
equation('eq36', '+..', (R_c, psi, theta) =>
  [R_c * cos(theta) * cos(psi), -R_c * sin(psi), R_c * sin(theta) * cos(psi)]);
equation('eq37', '+...0', (GM, R_c1, R_c2, R_c3, I) => {
  const R_c = hypot(R_c1, R_c2, R_c3);
  demand(R_c > 0);
  const torque = 3 * GM / R_c ** 5 * I * R_c1;
  return [0, -torque * R_c3, torque * R_c2];
});
equation('eq38', '++', (GM, R_c) => sqrt(GM / R_c ** 3)); // Kepler's; the 3 in print belongs to (39)
equation('eq39', '+0..', (Omega, I, psi, theta) => [0, -3 * Omega ** 2 * I * theta, -3 * Omega ** 2 * I * psi]);


// ---- the linear model and its stability ----

// (40)
const eq40 = equation('eq40', '++.......', (Omega, L_ref, C1, C2, psi, theta, dL, dL_dot, psi_dot) => [
  -4 * Omega ** 2 * theta,
  -2 * Omega / L_ref * dL_dot - 3 * Omega ** 2 * psi,
  eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot),
]);

// (41) coefficients of the characteristic polynomial, ascending
const eq41 = equation('eq41', '+..', (Omega, C1, C2) =>
  [3 * Omega ** 2 * (C1 - 9 * Omega ** 2), 3 * C2 * Omega ** 2, C1 - 2 * Omega ** 2, C2, 1]);

// As much of complex numbers, [re, im], as roots need.
const plus = ([a, b], [c, d]) => [a + c, b + d];
const less = ([a, b], [c, d]) => [a - c, b - d];
const scaled = (k, [a, b]) => [k * a, k * b];
const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
const over = (z, [c, d]) => scaled(1 / hypot(c, d), times(z, scaled(1 / hypot(c, d), [c, -d])));
const modulus = (z) => hypot(...z);
const squareRoot = ([a, b]) => {
  const large = sqrt((hypot(a, b) + abs(a)) / 2), small = large && b / (2 * large);
  return a >= 0 ? [large, small] : [abs(small), b < 0 ? -large : large];
};

// A polynomial at z, with its first two derivatives and the sum of its terms' moduli.
const horner = (coefficients, z) => {
  let [p, slope, bend, terms] = [[0, 0], [0, 0], [0, 0], 0];
  for (const a of [...coefficients].reverse()) {
    bend = plus(times(bend, z), scaled(2, slope));
    slope = plus(times(slope, z), p);
    p = plus(times(p, z), a);
    terms = terms * modulus(z) + modulus(a);
  }
  return { p, slope, bend, terms };
};

// Laguerre's method. It starts from the origin, since deflation wants the small roots first.
const laguerre = (coefficients) => {
  const n = coefficients.length - 1;
  let z = [0, 0];
  for (let i = 0; i < 100; i++) {
    const { p, slope, bend, terms } = horner(coefficients, z);
    if (modulus(p) <= Number.EPSILON * terms) break;
    const g = over(slope, p), g2 = times(g, g), h = less(g2, over(bend, p));
    const spread = squareRoot(scaled(n - 1, less(scaled(n, h), g2)));
    const [one, other] = [plus(g, spread), less(g, spread)];
    z = less(z, over([n, 0], modulus(one) > modulus(other) ? one : other));
  }
  return z;
};

// The quotient by x - z; the remainder is nothing.
const deflated = (coefficients, z) => {
  let carried = [0, 0];
  return [...coefficients].reverse().map((a) => (carried = plus(times(carried, z), a))).slice(0, -1).reverse();
};

// Newton's method, for as long as it helps.
const polished = (coefficients, z) => {
  const { p, slope } = horner(coefficients, z), next = less(z, over(p, slope));
  return modulus(horner(coefficients, next).p) < modulus(p) / 2 ? polished(coefficients, next) : z;
};

// (41) roots, in units of Omega, where the coefficients are near one
equation('eq41roots', '+..', (Omega, C1, C2) => {
  const coefficients = eq41(1, C1 / Omega / Omega, C2 / Omega).map((a) => [a, 0]);
  const roots = [];
  for (let rest = coefficients; rest.length > 1; rest = deflated(rest, roots.at(-1))) roots.push(laguerre(rest));
  return roots.map((z) => scaled(Omega, polished(coefficients, z))).sort((z, w) => z[0] - w[0] || z[1] - w[1]).flat();
});

// (42)-(44) what stability asks of the gains, and the gains
equation('eq42', '+..', (Omega, C1, C2) => {
  const margin1 = C1 - 9 * Omega ** 2, margin2 = C2;
  return [margin1, margin2, margin1 > 0 && margin2 > 0 ? 1 : 0];
});
equation('eq43', '++', (Omega, n) => n * Omega ** 2);
equation('eq44', '+.', (Omega, n) => {
  demand(n >= 9);
  return 2 * Omega * sqrt(n - 9);
});


// ---- motions ----

// A model tells its slope at a state, in units of time in which Omega = 1, and the Taylor series of its motion
// from there: an array of coefficients for each of the three coordinates and their rates, grown degree by degree.
const DEGREE = 24;

const taylor = (state, accelerations) => {
  const y = state.map((value) => [value]);
  const nextCoefficients = accelerations(y);
  for (let k = 0; k < DEGREE; k++) {
    const next = [y[3][k], y[4][k], y[5][k], ...nextCoefficients(k)];
    next.forEach((slope, i) => y[i].push(slope / (k + 1)));
  }
  return y;
};

// (40) is linear: coefficients of one degree obey it by themselves.
const linearModel = (Omega, L_ref, C1, C2) => {
  const acceleration = ([psi, theta, dL, psi_dot, , dL_dot]) => {
    const [theta_ddot, psi_ddot, dL_ddot] =
      eq40(1, L_ref, C1 / Omega / Omega, C2 / Omega, psi, theta, dL, dL_dot, psi_dot);
    return [psi_ddot, theta_ddot, dL_ddot];
  };
  return {
    slope: (state) => [...state.slice(3), ...acceleration(state)],
    series: (state) => taylor(state, (y) => (k) => acceleration(y.map((coefficients) => coefficients[k]))),
  };
};

// The coefficient of degree k of a product, and of a power from its lower ones.
const product = (a, b, k) => {
  let sum = 0;
  for (let j = 0; j <= k; j++) sum += a[j] * b[k - j];
  return sum;
};

const power = (a, exponent, lower, k) => {
  if (k === 0) return a[0] ** exponent;
  let sum = 0;
  for (let j = 1; j <= k; j++) sum += (exponent * j - k + j) * a[j] * lower[k - j];
  return sum / (k * a[0]);
};

// (3) with the charge product of (7) and (18)
const nonlinearModel = (Omega, k_c_SI, m1, m2, L_ref, C1_SI, C2_SI) => {
  const [k_c, C1, C2] = [k_c_SI / Omega / Omega, C1_SI / Omega / Omega, C2_SI / Omega];
  const Q_ref = eq07(1, k_c, m1, m2, L_ref);
  const whole = (m1 + m2) / m2; // L/r

  const slope = (state) => {
    const r1 = state.slice(0, 3), v1 = state.slice(3);
    const L = eq13(m1, m2, ...r1), L_dot = whole ** 2 * dot(r1, v1) / L;
    const Q = Q_ref + eq18(k_c, m1, m2, L_ref, C1, C2, L - L_ref, L_dot);
    return [...v1, ...eq03(1, k_c, m1, m2, Q, ...state)];
  };

  const series = (state) => taylor(state, ([x, y, z, x_dot, y_dot, z_dot]) => {
    const [r2, rv, inverse, inverse2, inverse3, Q, force] = Array.from({ length: 7 }, () => []);
    return (k) => {
      r2.push(product(x, x, k) + product(y, y, k) + product(z, z, k));
      rv.push(product(x, x_dot, k) + product(y, y_dot, k) + product(z, z_dot, k));
      inverse.push(power(r2, -1 / 2, inverse, k)); // 1/r, 1/r^2, 1/r^3
      inverse2.push(product(inverse, inverse, k));
      inverse3.push(product(inverse, inverse2, k));
      const L = whole * product(r2, inverse, k), L_dot = whole * product(rv, inverse, k);
      Q.push(k === 0 ? Q_ref + eq18(k_c, m1, m2, L_ref, C1, C2, L - L_ref, L_dot)
        : eq18(k_c, m1, m2, L_ref, C1, C2, L, L_dot));
      force.push(k_c / m1 / whole ** 2 * product(inverse3, Q, k));
      return [
        2 * y_dot[k] + 3 * x[k] + product(force, x, k),
        -2 * x_dot[k] + product(force, y, k),
        -z[k] + product(force, z, k),
      ];
    };
  });
  return { slope, series };
};

// Along the Taylor series, each time as far as its last coefficients allow: exp(-2) of the radius of convergence.
const followed = ({ series }, state, tau) => {
  let y = state;
  for (let now = 0, steps = 0; now !== tau; steps++) {
    if (!(steps < 1e5 && y.every(Number.isFinite))) throw new RangeError('the motion cannot be followed');
    const coefficients = series(y);
    const size = (k) => max(...coefficients.map((a) => abs(a[k])));
    const radius = min(...[DEGREE - 1, DEGREE].map((k) => (size(0) / size(k)) ** (1 / k)));
    const last = !(radius * exp(-2) < abs(tau - now)); // at rest there is no radius
    const h = last ? tau - now : sign(tau) * radius * exp(-2);
    y = coefficients.map((a) => a.reduceRight((sum, a_k) => sum * h + a_k, 0));
    now = last ? tau : now + h;
  }
  return y;
};

// t/h steps of the classical Runge-Kutta method
const rungeKutta = ({ slope }, state, t, h) => {
  const along = (y, step, k) => y.map((y_i, i) => y_i + step * k[i]);
  let y = state;
  for (let n = round(t / h); n > 0; n--) {
    const k1 = slope(y);
    const k2 = slope(along(y, h / 2, k1));
    const k3 = slope(along(y, h / 2, k2));
    const k4 = slope(along(y, h, k3));
    y = y.map((y_i, i) => y_i + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]));
  }
  return y;
};

const inRadians = (Omega, motion, model, state, ...times) =>
  motion(model, state.map((y, i) => (i < 3 ? y : y / Omega)), ...times.map((t) => Omega * t))
    .map((y, i) => (i < 3 ? y : Omega * y));

equation('flow_linear', '++.........', (Omega, L_ref, C1, C2, t, ...state) =>
  inRadians(Omega, followed, linearModel(Omega, L_ref, C1, C2), state, t));

equation('flow_nonlinear', '+++++.........', (Omega, k_c, m1, m2, L_ref, C1, C2, t, ...state) => {
  eq13(m1, m2, ...state.slice(0, 3));
  return inRadians(Omega, followed, nonlinearModel(Omega, k_c, m1, m2, L_ref, C1, C2), state, t);
});

equation('rk4_linear', '++.........+', (Omega, L_ref, C1, C2, t, ...rest) => {
  const state = rest.slice(0, 6), h = rest[6];
  demand(t >= 0 && t % h === 0);
  return inRadians(Omega, rungeKutta, linearModel(Omega, L_ref, C1, C2), state, t, h);
});

equation('rk4_nonlinear', '+++++.........+', (Omega, k_c, m1, m2, L_ref, C1, C2, t, ...rest) => {
  const state = rest.slice(0, 6), h = rest[6];
  demand(t >= 0 && t % h === 0);
  eq13(m1, m2, ...state.slice(0, 3));
  return inRadians(Omega, rungeKutta, nonlinearModel(Omega, k_c, m1, m2, L_ref, C1, C2), state, t, h);
});


// ---- the protocol ----

const allows = {
  '+': (x) => x > 0 && x < Infinity,
  '0': (x) => x >= 0 && x < Infinity,
  '.': Number.isFinite,
  i: (x) => x > 0,
};

const number = (word) => ({ inf: Infinity, '-inf': -Infinity })[word] ?? Number(word);

const answer = (id, words) => {
  if (!Object.hasOwn(operations, id)) return 'skip unknown operation';
  const { letters, compute } = operations[id];
  const inputs = words.map(number);
  if (!inputs.every((x, i) => allows[letters[i]](x))) return 'invalid';
  try {
    return [compute(...inputs)].flat().join(' ');
  } catch (error) {
    if (error instanceof OutsideDomain) return 'invalid';
    if (error instanceof RangeError) return `skip ${error.message}`;
    throw error;
  }
};

// The web edition's figures take the operations from here; Node.js has a standard input to answer.
if (typeof require === 'function') {
  require('node:readline').createInterface({ input: process.stdin }).on('line', (line) => {
    const [id, vector, ...words] = line.trim().split(/\s+/);
    process.stdout.write(`${vector} ${answer(id, words)}\n`);
  });
}
