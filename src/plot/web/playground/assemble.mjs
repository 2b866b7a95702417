// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The page with its style, its scripts and the module in one file, which opens
// from a disk:  node assemble.mjs PLAYGROUND.wasm PLAYGROUND.html

import {readFileSync, writeFileSync} from 'node:fs';
import {gzipSync} from 'node:zlib';

const [wasm, page] = process.argv.slice(2);
const part = (name) => readFileSync(new URL(name, import.meta.url), 'utf8');
const moduleText = gzipSync(readFileSync(wasm), {level: 9}).toString('base64');

const whole = part('index.html')
  .replace(/<link rel="stylesheet" href="(.+)">/,
    (_, name) => `<style>\n${part(name)}</style>`)
  .replace(/<script src="solver.js">/,
    (tag) => `<script type="application/gzip" id="module">${moduleText}</script>\n` +
      tag)
  .replace(/<script src="(.+)">/g, (_, name) => `<script>\n${part(name)}`);
writeFileSync(page, whole);
