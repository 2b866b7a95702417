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
  // docs/validation.md, "the base case".
  expect('the answer is confirmed',
    await page.becomes(`${text('verdict')}.startsWith('Confirmed')`));
  expect('  and is that of the base case',
    (await page.value(text('tau'))).startsWith('5.09344446'),
    await page.value(text('tau')));

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
