#!/usr/bin/env node
'use strict';

// browser.js FOLDER [PICTURES]: the edition's pages in a real browser, chromium without a window, told what to do over its
// debugging pipe. No page writes to the console or asks for anything but files; every link and anchor leads somewhere; no
// page is wider than its window; the figures pass their golden vectors; live curves lie on the certified ones; sliders change
// the curves; the start that is dragged, by mouse, by finger or by keys, changes the motion. PICTURES is a folder for a picture of each page at 1280 and
// at 390 pixels. Exit status 1 and a line each where that is not so.

const { spawn } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');

const folder = path.resolve(process.argv[2] ?? 'build/site'), pictures = process.argv[3];
const profile = fs.mkdtempSync(path.join(require('node:os').tmpdir(), 'browser-'));
const chromium = spawn('chromium', ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync', `--user-data-dir=${profile}`, '--remote-debugging-pipe'],
{ stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
chromium.on('error', () => { console.error('chromium is missing: run "make deps-ci".'); process.exit(1); });

// ---- the debugging protocol: JSON, a zero byte after each message ----

const answers = new Map(), messages = [];
let session, loaded = () => {}, count = 0, received = '';
chromium.stdio[4].on('data', (data) => {
  const parts = (received + data).split('\0');
  received = parts.pop();
  for (const { id, method, params, result, error } of parts.map((part) => JSON.parse(part))) {
    if (id) answers.get(id)(result ?? { error });
    if (method === 'Page.loadEventFired') loaded();
    if (method === 'Runtime.consoleAPICalled') messages.push(params.args.map((arg) => arg.value).join(' '));
    if (method === 'Runtime.exceptionThrown') messages.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Log.entryAdded') messages.push(`${params.entry.text} ${params.entry.url ?? ''}`);
    if (method === 'Network.requestWillBeSent' && !/^(file|data):/.test(params.request.url)) messages.push(`asks for ${params.request.url}`);
  }
});
const send = (method, params = {}) => new Promise((resolve) => {
  answers.set(++count, resolve);
  chromium.stdio[3].write(`${JSON.stringify({ id: count, method, params, sessionId: session })}\0`);
});
const evaluate = async (expression) => {
  const { result, exceptionDetails } = await send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
  if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
  return result.value;
};

// ---- what is asserted ----

let failures = 0;
const expect = (condition, text) => {
  if (!condition) {
    failures++;
    console.error(`browser.js: ${text}`);
  }
};
const open = async (page, width) => {
  messages.length = 0;
  await send('Emulation.setDeviceMetricsOverride', { width, height: 900, deviceScaleFactor: 1, mobile: width < 500 });
  for (const url of ['about:blank', `file://${folder}/${page}`]) { // the same page with another hash would not load again
    const done = new Promise((resolve) => { loaded = resolve; });
    await send('Page.navigate', { url });
    await done;
  }
};
const curves = (id) => evaluate(`document.getElementById('${id}').innerHTML`);
const said = (id) => evaluate(`document.getElementById('${id}').textContent`);
const turn = (name, value) => evaluate(`{ const input = document.getElementById('turn-${name}-input');
  input.value = ${value}; input.dispatchEvent(new Event('input', { bubbles: true })); }`);
const handle = () => evaluate(`{ const handle = document.querySelector('#turn-basin .handle');
  handle.scrollIntoView({ block: 'center' }); const box = handle.getBoundingClientRect(); [box.x + box.width / 2, box.y + box.height / 2]; }`);

const picture = async (page, width) => {
  const { cssContentSize } = await send('Page.getLayoutMetrics'), height = Math.min(Math.ceil(cssContentSize.height), 16000);
  await send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 500 });
  const { data } = await send('Page.captureScreenshot', { clip: { x: 0, y: 0, width, height, scale: 1 } });
  fs.writeFileSync(path.join(pictures, `${path.basename(page, '.html')}-${width}.png`), Buffer.from(data, 'base64'));
};

const checkPages = async (pages) => {
  const anchors = new Set(), links = [];
  for (const page of pages) {
    for (const width of [1280, 390]) {
      await open(page, width);
      const found = await evaluate(`({ ids: [...document.querySelectorAll('[id]')].map((e) => e.id), wide: document.documentElement.scrollWidth,
        links: [...document.querySelectorAll('[href], [src]')].map((e) => e.getAttribute('href') ?? e.getAttribute('src')),
        outside: [...document.querySelectorAll('main *')].filter((e) => e.getBoundingClientRect().right > ${width} && !e.closest('pre, table, .equation')).map((e) => e.outerHTML),
        broken: [...document.images].filter((image) => image.naturalWidth === 0).map((image) => image.src), text: document.body.innerText.length })`);
      expect(found.text > 200, `${page}: nothing is shown`);
      expect(found.wide <= width, `${page}: ${found.wide} pixels wide in a window of ${width}: ${found.outside[0]?.slice(0, 200)}`);
      expect(found.broken.length === 0, `${page}: no picture ${found.broken}`);
      if (pictures) await picture(page, width);
      expect(messages.length === 0, `${page}: ${messages}`);
      found.ids.forEach((id) => anchors.add(`${page}#${id}`));
      found.links.forEach((link) => links.push([page, link.startsWith('#') ? page + link : link]));
    }
  }
  for (const [page, link] of links) {
    const file = link.replace(/#.*/, ''), leads = !/^[a-z]+:/.test(link) && fs.existsSync(path.join(folder, file)) && (!link.includes('#') || anchors.has(link));
    expect(leads, `${page}: the link '${link}' leads nowhere`);
  }
  console.log(`${pages.length} pages without a message on the console, ${links.length / 2} links that lead somewhere`);
};

// How far, in pixels, the certified curves of a figure lie from the live ones of a kind, each from its own; all their points.
const apart = (id, kind, which = 0) => evaluate(`{
  const curve = (kind, which) => (document.querySelectorAll('#${id} path.' + kind)[which]?.getAttribute('d') ?? 'M').slice(1).split(/[ML]/)
    .map((point) => point.split(' ').map(Number));
  const [certified, live] = [curve('pale', ${which}), curve('${kind}', 0)];
  const toLine = (x, y, [x0, y0], [x1, y1]) => {
    const t = ((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / Math.hypot(x1 - x0, y1 - y0) ** 2, s = Math.min(Math.max(t || 0, 0), 1);
    return Math.hypot(x - x0 - s * (x1 - x0), y - y0 - s * (y1 - y0));
  };
  [certified.length, Math.max(...certified.map(([x, y]) => Math.min(...live.slice(1).map((end, i) => toLine(x, y, live[i], end)))))]; }`);

const checkFigures = async () => {
  await open('turn.html', 1280);
  const drawn = await evaluate('Math.round(performance.now())');
  await evaluate('new Promise((resolve) => setTimeout(resolve, 300))');
  const [, passed, all] = (await said('turn-check')).match(/(\d+) of (\d+) vectors passed/) ?? [];
  console.log(`${await said('turn-check')} Drawn ${drawn} ms after the page was asked for.`);
  expect(Number(passed) === Number(all) && all > 100, 'the figures do not pass their vectors');

  // As the page opens, in the paper's case: the gains' curve, then nonlinear motions under the solid lines, linear ones under the dashed.
  const motions = ['turn-psi', 'turn-theta', 'turn-dL'];
  const pairs = [['turn-rate', 'first'], ['turn-charge', 'first'], ...motions.map((id) => [id, 'first']), ...motions.map((id) => [id, 'second', 1])];
  for (const pair of pairs) {
    const [points, pixels] = await apart(...pair);
    expect(points > 100 && pixels < 1, `${pair[0]}: the live curve lies ${pixels} pixels from ${points} certified points`);
  }
  const [, different] = await apart('turn-rate', 'second');
  expect(different > 10, `turn-rate: a curve for another C2 lies only ${different} pixels from the certified one`);

  const figures = ['turn-rate', 'turn-roots', 'turn-psi', 'turn-theta', 'turn-dL', 'turn-charge', 'turn-basin'];
  const sliders = { n: [20, figures], c2: [4, figures], psi: [-0.3, ['turn-psi', 'turn-dL']], theta: [0.5, ['turn-theta', 'turn-dL']],
    dL: [-0.5, ['turn-psi', 'turn-dL', 'turn-charge']], ratio: [3, ['turn-charge']] };
  for (const [name, [value, moved]] of Object.entries(sliders)) {
    const before = await Promise.all(figures.map(curves));
    await turn(name, value);
    for (const id of moved) {
      const after = await curves(id);
      expect(/<path class="[a-z ]*first"/.test(after), `${id}: no curve`);
      expect(after !== before[figures.indexOf(id)], `${id}: the slider of ${name} changes nothing`);
    }
  }

  const motion = async () => (await curves('turn-basin')).match(/<path class="first"[^>]*>/)[0];
  const moves = async (what, act) => {
    const before = await motion();
    await act(...await handle());
    expect(await motion() !== before, `the start ${what} does not change the motion`);
  };
  const mouse = (type, x, y) => send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1, clickCount: 1 });
  const touch = (type, ...touchPoints) => send('Input.dispatchTouchEvent', { type, touchPoints });
  await moves('dragged by the mouse', async (x, y) => {
    await mouse('mousePressed', x, y);
    await mouse('mouseMoved', x + 25, y - 30);
    await mouse('mouseReleased', x + 25, y - 30);
  });
  await moves('dragged by a finger', async (x, y) => {
    await touch('touchStart', { x, y });
    await touch('touchMove', { x: x - 20, y: y - 20 });
    await touch('touchMove', { x: x - 40, y: y - 40 });
    await touch('touchEnd');
  });
  await evaluate("document.getElementById('turn-basin').focus()");
  await moves('moved by the keys', async () => {
    for (const type of ['keyDown', 'keyUp']) await send('Input.dispatchKeyEvent', { type, key: 'ArrowUp', code: 'ArrowUp', windowsVirtualKeyCode: 38 });
  });
  // Inside the basin a start comes back, far above it the pair is lost.
  for (const [x, end] of [[1.05, /inside the basin.*craft 1 above/], [1.5, /outside the basin.*lost/]]) {
    await open(`turn.html#x=${x}&s=0`, 1280);
    expect(end.test(await said('turn-end')), `from ${x} above: ${await said('turn-end')}`);
  }
  expect(messages.length === 0, `turn.html: ${messages}`);
  console.log(`${pairs.length} live curves lie within a pixel of the certified ones`);
  console.log('sliders, mouse, finger and keys move the figures');
};

const run = async () => {
  const { targetId } = await send('Target.createTarget', { url: 'about:blank' });
  session = (await send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
  await Promise.all(['Page.enable', 'Runtime.enable', 'Log.enable', 'Network.enable'].map((method) => send(method)));
  if (pictures) fs.mkdirSync(pictures, { recursive: true });
  await checkPages(fs.readdirSync(folder).filter((name) => name.endsWith('.html')));
  await checkFigures();
};

setTimeout(() => { console.error('browser.js: no answer within two minutes'); process.exit(1); }, 120000).unref();
run().catch((error) => { failures++; console.error(`browser.js: ${error.stack}`); }).finally(() => {
  chromium.on('exit', () => {
    try { // its children may write there for a while
      fs.rmSync(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
    } catch (error) { console.error(`browser.js: left behind: ${error.message}`); }
    process.exit(failures ? 1 : 0);
  });
  chromium.kill();
});
