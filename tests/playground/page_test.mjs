// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The page of the playground in Chromium, as somebody uses it, and how fast it
// answers there:
//
//   node page_test.mjs PLAYGROUND.html
//
// Exits with 77 where the page has not been built or there is no Chromium.

import {existsSync, statSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {browser, Page} from './browser.mjs';
import {answersASecond} from './drags.mjs';

const file = resolve(process.argv[2]);
const program = browser();
if (!existsSync(file) || !program) process.exit(77);

let failures = 0;
function expect(what, holds, found = '') {
  failures += holds ? 0 : 1;
  console.log(`${holds ? 'ok  ' : 'FAIL'} ${what} ${found}`);
}
const text = (id) => `document.getElementById('${id}').textContent`;
const click = (id) => `document.getElementById('${id}').click()`;

const MOST_BYTES = 600_000;
expect('the page is small', statSync(file).size < MOST_BYTES,
  `${statSync(file).size} bytes`);

const page = await Page.open(program, pathToFileURL(file).href);
try {
  // docs/validation.md, reference_case.
  expect('the answer is confirmed',
    await page.becomes(`${text('verdict')}.startsWith('Confirmed')`));
  expect('  and is that of the base case',
    (await page.value(text('tau'))).startsWith('5.09344446'),
    await page.value(text('tau')));

  // A track drawn by mouse and by touch: straight, of a cylinder with its mass on
  // the axis, for which playground_test.mjs has the time. Pixels are 4 to 10 mm.
  const STRAIGHT = 2 * Math.sqrt(15);
  const PIXELS = 0.01;
  const drawnTime = async () =>
    Number(/τ = ([\d.]+),/.exec(await page.value(text('own-result')))?.[1]);
  /** Where on the screen a share of the way from A to B is. */
  const onScreen = (share) => page.value(`(() => {
    const box = picture.getBoundingClientRect();
    const [x, y] = toPixels(${share} * wanted.L, ${share} * wanted.H);
    return {x: box.left + x, y: box.top + y};
  })()`);
  const drawStraight = async (pointer) => {
    await page.value(click('straight'));
    await page.value(click('more'));  // another track than that which is drawn
    await page.value(click('draw'));
    const STEPS = 12;
    for (let i = 0; i <= STEPS; ++i) {
      const phase = i === 0 ? 'begin' : i === STEPS ? 'end' : 'move';
      await pointer(phase, await onScreen(i / STEPS));
    }
  };
  await page.value(`eta.value = 0; eta.dispatchEvent(new Event('input'))`);
  await page.value(click('own'));
  expect('an answer to compare with is there', await page.becomes(
    `${text('verdict')}.includes('5.11510065')`));
  await drawStraight((phase, place) => page.send('Input.dispatchMouseEvent', {
    type: {begin: 'mousePressed', move: 'mouseMoved', end: 'mouseReleased'}[phase],
    button: 'left', buttons: phase === 'end' ? 0 : 1, clickCount: 1, ...place}));
  expect('drawn by mouse', Math.abs(await drawnTime() / STRAIGHT - 1) < PIXELS,
    await page.value(text('own-result')));
  // τ of the answer over that of the track, of 100; none for one that slips.
  expect('  it is scored', (await page.value(text('own-result'))).includes(
    `Score: ${Math.round(100 * 5.11510065 / await drawnTime())} of 100`));
  const gripOf = (value) => page.value(
    `grip.value = ${value}; grip.dispatchEvent(new Event('input'))`);
  await page.value(click('straight'));  // which takes a grip of 1/9
  await gripOf(0.1);
  expect('  not if it slips', await page.becomes(
    `${text('own-result')}.includes('Score: 0 of 100')`) &&
    (await page.value(text('own-remark'))).includes('takes a grip of 0.11'),
    await page.value(text('own-result')));
  await gripOf(2);
  await drawStraight((phase, place) => page.send('Input.dispatchMouseEvent', {
    type: {begin: 'mousePressed', move: 'mouseMoved', end: 'mouseReleased'}[phase],
    button: 'left', buttons: phase === 'end' ? 0 : 1, clickCount: 1, ...place}));
  const points = `document.querySelectorAll('#points [tabindex]')`;
  expect('  it has points that keys move', await page.value(`${points}.length`) === 10);
  const before = await drawnTime();
  const label = `${points}[4].getAttribute('aria-label')`;
  const said = await page.value(label);
  await page.value(`${points}[4].focus()`);
  await page.send('Input.dispatchKeyEvent',
    {type: 'keyDown', key: 'ArrowDown', code: 'ArrowDown'});
  expect('  and one was moved', await page.value(label) !== said &&
    await drawnTime() < before, await page.value(label));

  await page.send('Emulation.setDeviceMetricsOverride',
    {width: 420, height: 800, deviceScaleFactor: 1, mobile: true});
  await page.send('Emulation.setTouchEmulationEnabled', {enabled: true});
  await drawStraight(async (phase, place) => page.send('Input.dispatchTouchEvent', {
    type: {begin: 'touchStart', move: 'touchMove', end: 'touchEnd'}[phase],
    touchPoints: phase === 'end' ? [] : [place]}));
  expect('drawn by touch', Math.abs(await drawnTime() / STRAIGHT - 1) < PIXELS,
    await page.value(text('own-result')));
  expect('  without a word more to draw', await page.value(
    `document.getElementById('draw').getAttribute('aria-pressed')`) === 'false');

  await page.value(click('play'));  // stops the body
  const rates = await page.value(`(${answersASecond})(solver, () =>
    performance.now() / 1e3)`);
  for (const [key, rate, fallbacks] of rates) {
    console.log(`     dragging ${key.padEnd(7)} ${rate.toFixed(0)
    } answers a second, ${fallbacks} from the cycloid`);
  }

  expect('the browser has nothing to say', page.said.length === 0,
    page.said.join('; '));
} finally {
  await page.close();
}
process.exit(failures === 0 ? 0 : 1);
