'use strict';

// Plots as plain SVG, as wide as the element that holds them: their text has the size of the page's.

// About so many round numbers between two bounds.
const ticks = (low, high, count) => {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((k) => k * power >= rough);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(9)));
};

// Shapes are [class, points]: curves, interrupted at null, or a mark where there is one point. Returns the way back from a
// position on the screen.
const plot = (element, { x: [x0, x1], y: [y0, y1], titles: [xTitle, yTitle], height = 240 }, shapes) => {
  const width = element.clientWidth || 640, left = 62, right = 8, top = 8, bottom = 40;
  const X = (x) => left + (x - x0) / (x1 - x0) * (width - left - right);
  const Y = (y) => height - bottom - (y - y0) / (y1 - y0) * (height - top - bottom);
  const at = (value) => min(max(value, -1e4), 1e4).toFixed(1);
  const text = (x, y, words, rest) => `<text x="${x}" y="${y}" ${rest}>${words}</text>`;
  const grid = ticks(x0, x1, width / 110).map((x) => `<path class="grid" d="M${X(x)} ${top}V${height - bottom}"/>`
      + text(X(x), height - bottom + 16, x, 'text-anchor="middle"'))
    .concat(ticks(y0, y1, height / 55).map((y) => `<path class="grid" d="M${left} ${Y(y)}H${width - right}"/>`
      + text(left - 6, Y(y) + 4, y, 'text-anchor="end"')));
  const drawn = shapes.filter(([, points]) => points.length > 0).map(([kind, points]) => {
    if (points.length === 1) return `<circle class="${kind}" cx="${at(X(points[0][0]))}" cy="${at(Y(points[0][1]))}" r="6"/>`;
    const path = points.map((point, i) => point && `${points[i - 1] ? 'L' : 'M'}${at(X(point[0]))} ${at(Y(point[1]))}`);
    return `<path class="${kind}" d="${path.join('')}"/>`;
  });
  element.innerHTML = `<svg width="${width}" height="${height}" role="img" aria-label="${yTitle} against ${xTitle}">`
    + `<clipPath id="${element.id}-frame"><rect x="${left}" y="${top}" width="${width - left - right}" height="${height - top - bottom}"/></clipPath>`
    + grid.join('') + `<g clip-path="url(#${element.id}-frame)">${drawn.join('')}</g>`
    + text((left + width) / 2, height - 6, xTitle, 'text-anchor="middle"')
    + text(0, 0, yTitle, `text-anchor="middle" transform="translate(12 ${(top + height - bottom) / 2}) rotate(-90)"`) + '</svg>';
  return (clientX, clientY) => {
    const box = element.getBoundingClientRect();
    return [x0 + (clientX - box.left - left) / (width - left - right) * (x1 - x0),
      y0 + (height - bottom - clientY + box.top) / (height - top - bottom) * (y1 - y0)];
  };
};

const range = (low, high, count) => Array.from({ length: count + 1 }, (_, i) => low + i / count * (high - low));
const place = (id) => document.getElementById(id);
const compute = (id, ...inputs) => operations[id].compute(...inputs);

// The paper's pair.
const Omega = 7.2915e-5, k_c = 8.99e9, L_ref = 10, m1 = 150;
