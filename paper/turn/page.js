// What one turns: an input each, and the start that is dragged. The address may say where they stand: #n=20&dL=-0.5&x=1.2&s=0.1

const controls = { // of the gains, of the motion's start: name, label, least, most, step, value
  'turn-gains': [['n', 'n = C1/Ω²', 5, 40, 0.1, 10], ['c2', 'C2/Ω', 0, 8, 0.05, 2]],
  'turn-start': [['psi', 'initial yaw [rad]', -1, 1, 0.01, 0.01], ['theta', 'initial pitch [rad]', -1, 1, 0.01, 0.01],
    ['dL', 'initial length error [m]', -4, 4, 0.1, 0.1], ['ratio', 'm2/m1', 0.1, 10, 0.1, 1]],
};
const choices = [['turn-gains', 'rule', 'C2 by (44)', true], ['turn-start', 'hill', 'places of craft 1', false],
  ['turn-plane', 'upright', 'across the orbit', false]];

const begin = () => {
  const asked = new URLSearchParams(location.hash.slice(1)), inputs = {}, start = [Number(asked.get('x') ?? 1.04), Number(asked.get('s') ?? 0.02)];
  const add = (group, name, label, properties) => {
    const line = document.createElement('label'), input = document.createElement('input'), output = document.createElement('output');
    inputs[name] = Object.assign(input, properties, { id: `turn-${name}-input` });
    line.append(`${label} `, input, output);
    place(group).append(line);
  };
  for (const [group, list] of Object.entries(controls)) {
    for (const [name, label, least, most, step, value] of list) {
      add(group, name, label, { type: 'range', min: least, max: most, step });
      inputs[name].value = asked.get(name) ?? value;
    }
  }
  for (const [group, name, label, checked] of choices) add(group, name, label, { type: 'checkbox', checked: asked.has('c2') && name === 'rule' ? false : checked });

  // All of it, or what the dragged start changes.
  let state, back;
  const redrawBasin = () => { back = drawBasin(state, start); };
  const redraw = () => {
    if (inputs.rule.checked) inputs.c2.value = byRule(Number(inputs.n.value));
    state = Object.fromEntries(Object.entries(inputs).map(([name, input]) => [name, input.type === 'checkbox' ? input.checked : Number(input.value)]));
    if (state.rule) state.c2 = byRule(state.n); // the slider has steps
    for (const input of Object.values(inputs)) if (input.type === 'range') input.nextSibling.textContent = Number(input.value);
    drawGains(state);
    drawMotion(state);
    redrawBasin();
  };
  const moveStart = (x, s) => {
    if (!(hypot(x, s) > 0.05)) return; // the craft apart
    start.splice(0, 2, x, s);
    redrawBasin();
  };
  addEventListener('input', (event) => {
    if (event.target === inputs.c2) inputs.rule.checked = false;
    redraw();
  });
  addEventListener('resize', redraw);

  const basin = place('turn-basin');
  const toPointer = (event) => moveStart(...back(event.clientX, event.clientY).reverse());
  basin.addEventListener('pointerdown', (event) => {
    if (event.target.closest('.handle')) basin.setPointerCapture(event.pointerId);
  });
  basin.addEventListener('pointermove', (event) => {
    if (basin.hasPointerCapture(event.pointerId)) toPointer(event);
  });
  basin.addEventListener('click', toPointer);
  basin.addEventListener('keydown', (event) => {
    const [right, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key] ?? [0, 0];
    if (right === 0 && up === 0) return;
    const step = (known.x[1] - known.x[0]) / (event.shiftKey ? 400 : 40);
    event.preventDefault();
    moveStart(start[0] + up * step, start[1] + right * step);
  });
  redraw();
  setTimeout(selfCheck, 50); // when all is drawn
};

begin();
