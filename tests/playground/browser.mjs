// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

import {spawn} from 'node:child_process';
import {accessSync, constants, mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {delimiter, join} from 'node:path';

/** Chromium, or null. */
export function browser() {
  for (const folder of process.env.PATH.split(delimiter)) {
    for (const name of ['chromium', 'chromium-browser', 'google-chrome']) {
      try {
        accessSync(join(folder, name), constants.X_OK);
        return join(folder, name);
      } catch {
        // The next one.
      }
    }
  }
  return null;
}

/**
 * A page in Chromium without a window, asked by the DevTools protocol through a
 * pipe. There is no network.
 */
export class Page {
  /** What the browser had to say about the page. */
  said = [];

  static async open(program, address) {
    const page = new Page();
    page.home = mkdtempSync(join(tmpdir(), 'page-'));
    const flags = ['--headless=new', '--disable-gpu', '--no-first-run',
      '--disable-extensions', '--remote-debugging-pipe',
      `--user-data-dir=${page.home}`];
    if (process.getuid() === 0) flags.push('--no-sandbox');
    page.process = spawn(program, flags,
      {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    page.listen(page.process.stdio[4]);
    const {targetId} = await page.send('Target.createTarget', {url: 'about:blank'});
    const {sessionId} =
      await page.send('Target.attachToTarget', {targetId, flatten: true});
    page.session = sessionId;
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) {
      await page.send(`${domain}.enable`);
    }
    await page.send('Network.emulateNetworkConditions',
      {offline: true, latency: 0, downloadThroughput: 0, uploadThroughput: 0});
    const loaded = new Promise((resolve) => { page.loaded = resolve; });
    await page.send('Page.navigate', {url: address});
    await loaded;
    return page;
  }

  /** Messages end with a zero. */
  listen(pipe) {
    this.waiting = new Map();
    let rest = '';
    pipe.setEncoding('utf8').on('data', (text) => {
      const messages = (rest + text).split('\0');
      rest = messages.pop();
      messages.forEach((message) => this.take(JSON.parse(message)));
    });
  }

  take({id, method, params, result, error}) {
    if (id !== undefined) {
      const {resolve, reject} = this.waiting.get(id);
      this.waiting.delete(id);
      if (error) reject(new Error(error.message)); else resolve(result);
    } else if (method === 'Page.loadEventFired') {
      this.loaded();
    } else if (method === 'Runtime.exceptionThrown') {
      this.said.push(params.exceptionDetails.exception?.description ??
        params.exceptionDetails.text);
    } else if (method === 'Runtime.consoleAPICalled') {
      this.said.push(params.args.map((part) => part.value).join(' '));
    } else if (method === 'Log.entryAdded') {
      this.said.push(params.entry.text);
    }
  }

  send(method, params = {}) {
    const id = this.lastId = (this.lastId ?? 0) + 1;
    this.process.stdio[3].write(
      `${JSON.stringify({id, method, params, sessionId: this.session})}\0`);
    return new Promise((resolve, reject) =>
      this.waiting.set(id, {resolve, reject}));
  }

  /** The value of an expression in the page. */
  async value(expression) {
    const {result, exceptionDetails} =
      await this.send('Runtime.evaluate', {expression, returnByValue: true});
    if (exceptionDetails) {
      throw new Error(exceptionDetails.exception?.description ?? expression);
    }
    return result.value;
  }

  /** @returns {boolean} whether an expression became true in time */
  async becomes(expression, seconds = 30) {
    const end = performance.now() + 1e3 * seconds;
    while (performance.now() < end) {
      if (await this.value(expression)) return true;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    return false;
  }

  async close() {
    await this.send('Browser.close').catch(() => {});
    await new Promise((resolve) => this.process.on('exit', resolve));
    rmSync(this.home, {recursive: true, force: true});
  }
}
