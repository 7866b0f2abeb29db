// Whether this browser computes what was proved: `golden` holds tables of golden vectors by operation, `certified` motions and
// roots of the paper's figures, both as CSV.

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
  const failed = all.filter(([, passed]) => !passed).map(([name]) => name);
  place('turn-check').textContent =
    `${all.length - failed.length} of ${all.length} vectors passed in this browser${failed.length ? `, not ${failed.join(' ')}` : ''}.`;
};
