#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The page in a headless Chromium, as a person with keys or fingers has it. TAP; run by `make check-web`.
// Environment: MATVIB, MATVIB_BUILDDIR, MATVIB_BROWSER (chromium), MATVIB_SHOTS (a folder for screenshots).
'use strict';
const fs = require('fs'), os = require('os'), path = require('path'), http = require('http');
const {execFileSync, spawnSync} = require('child_process');
const {createRequire} = require('module');
const built = process.env.MATVIB_BUILDDIR;
const puppeteer = createRequire(path.join(built, 'web-work', 'x.js'))('puppeteer-core');
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'matvib-page-'));
const patience = 30000;
let number = 0, broken = false, browser, page, served;

function result(name, holds, told = '') {
	console.log(`${holds ? 'ok' : 'not ok'} ${++number} - ${name}`);
	if (!holds) {
		broken = true;
		for (const line of String(told).split('\n')) console.log('# ' + line);
	}
}
const note = (text) => console.log('# ' + text);

// --- what is seen --------------------------------------------------------------------------------
const screen = () => page.evaluate(() => {
	const buffer = term.buffer.active, rows = [];
	for (let i = 0; i < term.rows; i++) rows.push(buffer.getLine(buffer.viewportY + i).translateToString(true));
	return rows.join('\n');
});
async function until(what, holds) {
	const begin = Date.now();
	for (;;) {
		const text = await screen().catch(() => '');
		if (holds(text)) return {time: Date.now() - begin, text};
		if (Date.now() - begin > patience) return {time: Infinity, text};
		await new Promise((done) => setTimeout(done, 5));
	}
}
async function shows(name, holds) {
	const {time, text} = await until(name, holds);
	result(name, time < Infinity, text);
	return time;
}
const has = (word) => (text) => text.includes(word);
const type = async (text) => { for (const letter of text) await page.keyboard.press(letter === '\r' ? 'Enter' : letter); };
const file = (name) => page.evaluate((name) => {
	const bytes = written.get(name);
	return bytes ? Array.from(bytes) : null;
}, name).then((bytes) => bytes && Buffer.from(bytes));
async function written(name) {
	for (let i = 0; i < patience / 50; i++) {
		const bytes = await file(name);
		if (bytes) return bytes;
		await new Promise((done) => setTimeout(done, 50));
	}
	return null;
}
async function shot(name) {
	if (!process.env.MATVIB_SHOTS) return;
	await new Promise((done) => setTimeout(done, 300));
	await page.screenshot({path: path.join(process.env.MATVIB_SHOTS, name + '.png')});
}

const one = 'file://' + path.join(built, 'matvib.html');
async function open(address, how = {}) {
	if (page) await page.close();
	page = await browser.newPage();
	page.on('pageerror', (error) => note('page: ' + error.message));
	page.on('console', (message) => message.type() === 'error' && note('console: ' + message.text()));
	page.on('request', (request) => {
		if (!/^(file|data|blob):/.test(request.url()) && !request.url().startsWith(served)) result('nothing is asked for elsewhere', false, request.url());
	});
	await page.setViewport(Object.assign({width: 1280, height: 800}, how));
	const begin = Date.now();
	await page.goto(address);
	return begin;
}

// --- the cases -----------------------------------------------------------------------------------
async function first_picture() {
	const begin = await open(one);
	await shows('one file from the disk opens the laboratory', has('Space pause'));
	note(`first picture after ${Date.now() - begin} ms`);
	await shot('1280x800');
	const heap = await page.evaluate(() => [term.cols, term.rows]);
	note(`${heap[0]}x${heap[1]} characters`);
}

async function keys_and_size() {
	await page.keyboard.press(' ');
	note(`a key is answered in ${await shows('a key pauses', has('Space run'))} ms`);
	const columns = await page.evaluate(() => term.cols);
	await page.setViewport({width: 900, height: 600});
	await shows('the laboratory takes the size of its window', (text) => text.split('\n').length < 40 && text.includes('Space run'));
	result('with fewer columns', (await page.evaluate(() => term.cols)) < columns);
	await page.setViewport({width: 1280, height: 800});
	await until('', has('Space run'));
}

async function export_of_a_run() {
	await open(one + '?scenario=mode5&set=mesh.cell_size=0.5');
	await shows('a link opens its scenario', has('Space pause'));
	await page.keyboard.press(' ');
	await until('', has('Space run'));
	await type(':export page\r');
	const bytes = await written('page-series.csv');
	result('an export is offered', bytes !== null, await screen());
	const rows = (text) => text.toString().split('\n').filter((line) => line && !line.startsWith('#'));
	// a head, the start, and a row for each step
	const steps = bytes ? rows(bytes).length - 2 : 1;
	spawnSync(process.env.MATVIB, ['run', 'mode5', '--set', 'mesh.cell_size=0.5', '--steps', String(steps), '--series', 'native.csv', '--quiet', '--force'], {cwd: scratch});
	const native = fs.readFileSync(path.join(scratch, 'native.csv'));
	result('its rows are the native run\'s', bytes && rows(bytes).join('\n') === rows(native).join('\n'),
		bytes && `${rows(bytes).length} rows, natively ${rows(native).length}\n${rows(bytes).slice(-3).join('\n')}\n${rows(native).slice(-3).join('\n')}`);
}

async function dropped_scenario() {
	const own = path.join(scratch, 'own.ini');
	fs.writeFileSync(own, '[scenario]\ntitle = Brought in by hand\nproblem = bar\nmethod = mpm\n');
	const chooser = await page.$('#bring');
	await chooser.uploadFile(own);
	await shows('a scenario from outside is opened', has('Brought in by hand'));
	fs.writeFileSync(path.join(scratch, 'page.html'), '<p>x');
	await chooser.uploadFile(path.join(scratch, 'page.html'));
	await new Promise((done) => setTimeout(done, 200));
	result('what is no file of matvib is refused in a line', /can be opened, not page\.html/.test(await page.$eval('#notice', (p) => p.textContent)));
}

async function dropped_series() {
	await open(one + '?scenario=mode5&set=mesh.cell_size=0.5');
	await until('', has('Space pause'));
	await page.keyboard.press(' ');
	await until('', has('Space run'));
	await (await page.$('#bring')).uploadFile(path.join(scratch, 'native.csv'));
	await new Promise((done) => setTimeout(done, 1000));
	result('what can be done with a series is said', /:diagnose native\.csv/.test(await page.$eval('#notice', (p) => p.textContent)));
	await type(':diagnose native.csv\r');
	await shows('and it is told whose numbers they are', has("the right code's numbers"));
}

async function lesson_by_taps() {
	await open(one + '?lesson=one-step', {width: 412, height: 915, isMobile: true, hasTouch: true});
	await shows('a lesson on a telephone', (text) => /1 of \d+|1\/\d+/.test(text));
	await shot('412x915');
	result('keys for fingers are there', await page.$eval('#keys', (nav) => !nav.hidden && nav.children.length > 8));
	const next = async () => {
		for (const button of await page.$$('#keys button'))
			if ((await button.evaluate((button) => button.textContent)) === 'n next') return button.tap();
	};
	for (let i = 2; i <= 3; i++) {
		await next();
		await shows(`a tap leads to page ${i}`, (text) => new RegExp(`\\b${i} of \\d+|\\b${i}/\\d+`).test(text));
	}
	result('no keyboard comes by itself', await page.evaluate(() => term.textarea.inputMode === 'none'));
	await open(one, {width: 1024, height: 768, isMobile: true, hasTouch: true});
	await until('', has('Space pause'));
	await shot('1024x768');
	const at = await page.evaluate(() => {
		const box = document.querySelector('.xterm-screen').getBoundingClientRect();
		const offer = offers().find(({word}) => word === 'pause');
		return {x: box.left + (offer.from + 1.5) * box.width / term.cols, y: box.top + (term.rows - .5) * box.height / term.rows};
	});
	await page.touchscreen.tap(at.x, at.y);
	await shows('a tap on a word of the key line presses it', has('Space run'));
}

async function homework() {
	await open(one + '?lesson=homework-late&name=Ada&id=7');
	await shows('homework opens for the name of a link', (text) => /Ada/.test(text) || /1 of \d+|1\/\d+/.test(text));
	for (const key of ['n', 'n', 'Enter', '4', '2', 'Enter']) {
		await page.keyboard.press(key === 'Enter' ? 'Enter' : key);
		await new Promise((done) => setTimeout(done, 300));
	}
	const name = 'homework-late-Ada.session';
	let bytes = await written(name);
	await new Promise((done) => setTimeout(done, 1000));
	bytes = await file(name);
	result('it is recorded', bytes !== null && bytes.includes('Ada'), await screen());
	result('whose it is stands on the page', /homework of Ada/.test(await page.$eval('#whose', (span) => span.textContent)));
	const other = await browser.newPage();
	await other.goto(one + '?lesson=homework-late&name=Bob');
	await other.waitForFunction(() => !document.getElementById('notice').hidden, {timeout: patience}).catch(() => {});
	result('another tab keeps none meanwhile', /Another tab/.test(await other.$eval('#notice', (p) => p.textContent)));
	await other.close();
	await page.bringToFront();
	await page.goto(one);
	await until('', has('Space pause'));
	const after = await file(name);
	result('it survives a reload', bytes && after && after.equals(bytes));
	// a session that was cut off has no end: it is done again, and goes on
	await page.click('#whose button');
	await until('', has('Ada'));
	await new Promise((done) => setTimeout(done, 1500));
	await page.keyboard.press(' ');
	await page.waitForFunction(() => document.querySelector('#whose button').textContent === 'hand in', {timeout: patience}).catch(() => {});
	await page.click('#whose button');
	await page.waitForFunction(() => document.getElementById('end-sheet').open, {timeout: patience}).catch(() => {});
	result('it goes on and is handed in', /hand in this file/.test(await page.$eval('#end-files', (list) => list.textContent)), await screen());
	fs.writeFileSync(path.join(scratch, name), (await file('homework-late-Ada-go1.session')) || '');
	const graded = spawnSync(process.env.MATVIB, ['grade', 'homework-late', path.join(scratch, name)], {encoding: 'utf8'});
	result('and is graded natively', graded.status === 0 && /Ada/.test(graded.stdout), graded.stdout + graded.stderr);
	await page.evaluate(() => { document.getElementById('forget').click(); });
	await until('', has('Space pause'));
	result('"forget me" leaves nothing', (await page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith('matvib/')).length)) === 0);
}

async function computing() {
	await open(one + '?scenario=branching');
	await shows('a plate of the papers\' size opens', has('Space'));
	await page.keyboard.press(' ');
	await new Promise((done) => setTimeout(done, 500));
	await type(':full\r');
	await new Promise((done) => setTimeout(done, 1500));
	await type(':goto #3000\r');
	await until('', (text) => /comput|stop here/.test(text));
	await page.keyboard.press('Escape');
	const time = await shows('Esc stops a long computation', (text) => !/stop here/.test(text));
	note(`Esc is answered in ${time} ms`);
}

async function hostile() {
	const bad = '<img src=x onerror="document.title=1">';
	for (const link of ['?scenario=' + encodeURIComponent(bad), '?lesson=' + encodeURIComponent('../../etc/passwd'),
		'?scenario=mode5&set=' + encodeURIComponent('bar.length=1\x1b[2J') + '&set=--record', '?scenario=mode5&set=' + 'x'.repeat(50000)]) {
		await open(one + link);
		await until('', has('Space pause'));
		result(`a link with ${link.slice(0, 40)} does no harm`, (await page.title()) === 'matvib' && (await page.$$('img')).length === 0 && has('Space pause')(await screen()));
	}
	await page.evaluate(() => {
		localStorage.setItem('matvib/work/../../x.session', 'junk');
		localStorage.setItem('matvib/work/\u0007.session', 'junk');
		localStorage.setItem('matvib/state/progress', '\u1234'.repeat(1000));
		localStorage.setItem('matvib/state/last.session', '\0'.repeat(100000));
		localStorage.setItem('matvib/tab', 'x 9e99');
	});
	await open(one);
	await shows('what another page left in the storage does no harm', has('Space pause'));
	await page.evaluate(() => localStorage.clear());
	await open(one + '?scenario=mode5');
	await until('', has('Space pause'));
	await type('q');
	await page.waitForFunction(() => document.getElementById('end-sheet').open, {timeout: patience}).catch(() => {});
	result('the end of the program offers to begin again', await page.$eval('#end-sheet', (sheet) => sheet.open), await screen());
	await page.click('#again');
	await shows('which does', has('Space pause'));
}

async function in_firefox() {
	const path_of = process.env.MATVIB_FIREFOX || '/usr/bin/firefox-esr';
	if (!fs.existsSync(path_of)) return console.log(`ok ${++number} - in Firefox # SKIP firefox-esr is not installed`);
	const other = await puppeteer.launch({browser: 'firefox', executablePath: path_of, headless: true});
	page = await other.newPage();
	await page.setViewport({width: 1280, height: 800});
	await page.goto(one + '?scenario=mode1');
	await shows('Firefox opens the one file from the disk', has('Space pause'));
	await page.keyboard.press(' ');
	await shows('and a key pauses there', has('Space run'));
	await type(':export page\r\r');
	result('and an export is offered', (await written('page-series.csv')) !== null, await screen());
	await other.close();
	page = null;
}

async function from_a_server() {
	await open(served + 'index.html?scenario=mode1');
	await shows('the folder works on a server without headers of its own', has('Space pause'));
}

async function main() {
	const types = {'.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm', '.css': 'text/css'};
	const server = http.createServer((request, answer) => {
		const name = path.basename(new URL(request.url, 'http://x').pathname), where = path.join(built, 'web', name);
		if (!fs.existsSync(where)) return answer.writeHead(404).end();
		answer.writeHead(200, {'content-type': types[path.extname(name)] || 'application/octet-stream'}).end(fs.readFileSync(where));
	}).listen(0, '127.0.0.1');
	await new Promise((done) => server.on('listening', done));
	served = `http://127.0.0.1:${server.address().port}/`;
	browser = await puppeteer.launch({
		executablePath: process.env.MATVIB_BROWSER || '/usr/bin/chromium', headless: true, userDataDir: path.join(scratch, 'profile'),
		args: ['--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking'],
	});
	const cases = {first_picture, keys_and_size, export_of_a_run, dropped_scenario, dropped_series, lesson_by_taps, homework, computing, hostile, from_a_server, in_firefox};
	const wanted = process.argv.slice(2);
	for (const [name, run] of Object.entries(cases)) {
		if (wanted.length > 0 && !wanted.includes(name)) continue;
		await run().catch((error) => result(name, false, error.stack));
	}
	console.log(`1..${number}`);
	await browser.close();
	server.close();
	fs.rmSync(scratch, {recursive: true, force: true});
	process.exit(broken ? 1 : 0);
}
main();
