#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The page in a headless Chromium and a headless Firefox, as a person with keys or fingers has it: the same list in both.
// browser.js CASE...: these alone. TAP; run by `make check-web`. Environment: MATVIB, MATVIB_BUILDDIR, MATVIB_BROWSER (chromium),
// MATVIB_FIREFOX (firefox-esr), MATVIB_SHOTS (a folder for screenshots), MATVIB_TIMES (how long each case took).
// Processes side by side, each with a browser, take the cases one after the other; a case has a context of its own, with nothing kept
// from the one before. What is waited for is a state of the page, never a time.
'use strict';
const fs = require('fs'), os = require('os'), path = require('path'), http = require('http'), zlib = require('zlib');
const {createHash} = require('crypto');
const {fork, spawnSync} = require('child_process');
const {createRequire} = require('module');
const built = process.env.MATVIB_BUILDDIR;
const puppeteer = createRequire(path.join(built, 'web-work', 'x.js'))('puppeteer-core');
const scratch = process.env.MATVIB_ENGINE && fs.mkdtempSync(path.join(os.tmpdir(), 'matvib-page-'));
const patience = 300000; // for whatever is waited for: a machine may be loaded
const PICTURE_MOST = 2; // processor time of the first picture, in that of 20 million steps of a generator; 1.3 to 1.7, and from 2.07 on before it was unpacked in a worker
const asked = []; // of the server
let away = false, held = null, browser, context, page, served, engine;

function result(name, holds, told = '') {
	console.log(`${holds ? 'ok' : 'not ok'} - ${engine.name}: ${name}`);
	if (!holds) for (const line of String(told).split('\n')) console.log('# ' + line);
}
const note = (text) => console.log('# ' + text);

// --- what is seen --------------------------------------------------------------------------------
const screen = () => page.evaluate(() => {
	const buffer = term.buffer.active, rows = [];
	for (let i = 0; i < term.rows; i++) rows.push(buffer.getLine(buffer.viewportY + i).translateToString(true));
	return rows.join('\n');
});
// The screen once it is another than `before`, or after a second.
const next_screen = (before) => page.evaluate((before) => new Promise((done) => {
	const read = () => Array.from({length: term.rows}, (_, i) => term.buffer.active.getLine(term.buffer.active.viewportY + i).translateToString(true)).join('\n');
	const end = (text) => { parsed.dispose(); clearTimeout(timer); done(text); };
	const look = () => { const text = read(); if (text !== before) end(text); };
	const parsed = term.onWriteParsed(look), timer = setTimeout(() => end(read()), 1000);
	look();
}), before);
async function look_for(holds) {
	const begin = Date.now();
	for (let text = '';; await pause(20)) {
		text = await next_screen(text).catch(() => '');
		if (holds(text)) return {time: Date.now() - begin, text};
		if (Date.now() - begin > patience) return {time: Infinity, text};
	}
}
// Without it the rest of a case means nothing.
async function until(holds) {
	const found = await look_for(holds);
	if (found.time === Infinity) throw new Error(`not ${holds} on the screen\n${found.text}`);
	return found;
}
async function shows(name, holds) {
	const {time, text} = await look_for(holds);
	result(name, time < Infinity, text);
	return time;
}
// What `get` finds, once it holds or patience has ended.
async function sooner(get, holds) {
	let found;
	for (const begin = Date.now(); !holds(found = await get().catch(() => '')) && Date.now() - begin < patience;) await pause(50);
	return found;
}
async function becomes(name, get, holds) {
	const found = await sooner(get, holds);
	result(name, holds(found), found);
}
const has = (word) => (text) => text.includes(word);
const pause = (time) => new Promise((done) => setTimeout(done, time));
const text_of = (place) => page.$eval(place, (found) => found.textContent.replace(/\s+/g, ' '));
const notice_of = () => text_of('#notice');
const is_open = (sheet) => page.waitForFunction((sheet) => document.getElementById(sheet).open, {}, sheet).then(() => true, () => false);
const type = async (text) => { for (const letter of text) await page.keyboard.press(letter === '\r' ? 'Enter' : letter); };
const file = (name) => page.evaluate((name) => {
	const bytes = written.get(name);
	return bytes ? Array.from(bytes) : null;
}, name).then((bytes) => bytes && Buffer.from(bytes));
const written = (name) => sooner(() => file(name), Boolean);
async function shot(name) {
	if (!process.env.MATVIB_SHOTS) return;
	await pause(300);
	await page.screenshot({path: path.join(process.env.MATVIB_SHOTS, engine.name + '-' + name + '.png')});
}

// Fingers and darkness are a browser's own affair: Chromium takes them page by page, Firefox by its preferences, from the start.
const engines = {
	Chromium: {
		path: process.env.MATVIB_BROWSER, package: 'chromium',
		launch: () => puppeteer.launch({
			executablePath: process.env.MATVIB_BROWSER, headless: true, timeout: patience, protocolTimeout: 2 * patience, userDataDir: path.join(scratch, 'profile'),
			args: ['--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking'],
		}),
		fingers: {isMobile: true, hasTouch: true},
		darken: () => page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'dark'}]),
		tap: (x, y) => fingers([[x, y]]),
	},
	Firefox: {
		path: process.env.MATVIB_FIREFOX, package: 'firefox-esr',
		launch: (touch) => puppeteer.launch({
			browser: 'firefox', executablePath: process.env.MATVIB_FIREFOX, headless: true, timeout: patience, protocolTimeout: 2 * patience,
			extraPrefsFirefox: touch ? {'ui.primaryPointerCapabilities': 1, 'ui.allPointerCapabilities': 1, 'dom.w3c_touch_events.enabled': 1} : {},
		}),
		fingers: {},
		// a plain touch: of the angle of a pen that puppeteer adds this Firefox knows nothing
		tap: (x, y) => page.mainFrame().browsingContext.performActions([{type: 'pointer', id: 'finger', parameters: {pointerType: 'touch'}, actions: [
			{type: 'pointerMove', x: Math.round(x), y: Math.round(y)}, {type: 'pointerDown', button: 0}, {type: 'pointerUp', button: 0}]}]),
	},
};

const one = 'file://' + path.join(built, 'matvib.html');
const endless = one + '?scenario=mode5&set=time.end:1e4'; // for what is done while a run goes on, however slow the machine is
let touching = false;
async function with_fingers(touch) {
	if (browser && (touch === touching || engine === engines.Chromium)) return;
	if (browser) await browser.close();
	browser = await engine.launch(touch);
	touching = touch;
	page = context = null;
}
async function open(address, how = {}, touch = false, before = null) {
	await with_fingers(touch);
	if (page) await page.close();
	context = context || await browser.createBrowserContext();
	page = await context.newPage();
	page.setDefaultTimeout(patience);
	page.on('pageerror', (error) => note('page: ' + error.message));
	page.on('console', (message) => message.type() === 'error' && note('console: ' + message.text()));
	page.on('request', (request) => {
		if (!/^(file|data|blob):/.test(request.url()) && !request.url().startsWith(served)) result('nothing is asked for elsewhere', false, request.url());
	});
	await page.setViewport(Object.assign({width: 1280, height: 800}, how, touch ? engine.fingers : {}));
	if (before) await page.evaluateOnNewDocument(before);
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
	if (!engine.darken) return;
	const grounds = () => page.evaluate(() => [term.options.theme.background, getComputedStyle(document.body).backgroundColor].join(' '));
	await engine.darken();
	result('a program under way keeps the ground that its colours are for', (await grounds()) === '#ffffff rgb(16, 20, 24)', await grounds());
	await page.select('#chooser', 'scenario mode1');
	await shows('another one is begun', has('Where mesh and bar agree'));
	result('dark, where the system is', (await grounds()) === '#101418 rgb(16, 20, 24)', await grounds());
	await shot('dark');
}

// What the page's own thread, which a browser slows down six times, computes before the first picture: in processor time, and held
// to a loop's, so that it is the same on a machine that does other things.
async function first_picture_of_a_slow_machine() {
	if (engine !== engines.Chromium) return;
	let least = Infinity, told = '';
	for (let i = 0; i < 3 && least > PICTURE_MOST; i++) {
		await open('about:blank', {}, false, () => {
			window.pictured = new Promise((done) => addEventListener('DOMContentLoaded', () => typeof term !== 'undefined' && term.onRender(() => {
				const line = term.buffer.active.getLine(term.rows - 1);
				if (line && line.translateToString().includes('Space')) done();
			})));
		});
		const client = await page.createCDPSession();
		await client.send('Performance.enable', {timeDomain: 'threadTicks'});
		const busy = async () => 1000 * (await client.send('Performance.getMetrics')).metrics.find(({name}) => name === 'TaskDuration').value;
		const before = await busy();
		await page.evaluate(() => { let x = 1; for (let i = 0; i < 2e7; i++) x = x * 48271 % 2147483647; return x; });
		const loop = await busy() - before;
		await page.goto(one); // in a process of its own, whose time begins there
		await page.evaluate(() => pictured);
		const took = await busy();
		if (took / loop > least) continue;
		least = took / loop;
		told = `first picture after ${Math.round(took)} ms of a processor, ${Math.round(6 * took)} ms of one six times as slow; ${least.toFixed(2)} times a loop`;
	}
	note(told);
	result('the first picture takes no more of a processor than it did', least <= PICTURE_MOST, `at most ${PICTURE_MOST} times the loop`);
}

async function keys_and_size() {
	await open(endless);
	await until(has('Space pause'));
	await page.keyboard.press(' ');
	note(`a key is answered in ${await shows('a key pauses', has('Space run'))} ms`);
	const columns = await page.evaluate(() => term.cols);
	await page.setViewport({width: 900, height: 600});
	await shows('the laboratory takes the size of its window', (text) => text.split('\n').length < 40 && text.includes('Space run'));
	result('with fewer columns', (await page.evaluate(() => term.cols)) < columns);
	const cut = [];
	for (const width of [1280, 1277, 1001, 900]) {
		await page.setViewport({width, height: 600});
		const fits = await sooner(() => page.evaluate((width) => {
			const [drawn, room] = [document.querySelector('.xterm-screen'), document.getElementById('screen')].map((e) => e.getBoundingClientRect());
			return innerWidth === width && drawn.right <= room.right && drawn.bottom <= room.bottom && drawn.right > room.right - 30;
		}, width), Boolean);
		if (!fits) cut.push(width);
	}
	result('no column or row is cut off', cut.length === 0, 'cut at ' + cut.join(' '));
	await page.setViewport({width: 1280, height: 800});
	await until(has('Space run'));
}

async function edit_and_stages() {
	await open(one + '?scenario=mode5');
	await until(has('Space pause'));
	await halt();
	await type('mesh.cell_size=0.5'.replace(/^/, ':') + '\r');
	await shows('a parameter is edited', (text) => /cell size +0\.5/.test(text) && /tries cell size 1/.test(text));
	await page.keyboard.press(']');
	await shows('and the stages of a step are opened', (text) => /stage 1|1 of \d+|\] stage/.test(text));
}

async function export_of_a_run() {
	// to the end: a run that has gone further is asked about
	await open(one + '?scenario=mode5&set=mesh.cell_size=0.5&set=time.end=1.5');
	await shows('a link opens its scenario', has('Space pause'));
	await halt();
	await type(':goto #300\r');
	await shows('it goes to a step', has('t 1.500'));
	await page.evaluate(() => { window.looking = setInterval(() => worker && worker.postMessage({look: true}), 1); }); // while they are written too
	await type(':export page\r');
	await written('page-series.csv');
	await page.evaluate(() => clearInterval(window.looking));
	await becomes('an export is offered at once, by a button', () => text_of('#latest'), (text) => text === 'save page-series.csv');
	const native = native_export();
	for (const name of native) result(`${name} has the native bytes`, fs.readFileSync(path.join(scratch, name)).equals((await file(name)) || Buffer.alloc(0)));
	result('all of its files', native.length === 6 && (await page.evaluate(() => written.size)) === 6, native.join());
}

function native_export() {
	fs.writeFileSync(path.join(scratch, 'export.script'), 'key Space\ntype :goto #300\nkey Enter\ntype :export page\nkey Enter\n');
	spawnSync(process.env.MATVIB, ['mode5', '--set', 'mesh.cell_size=0.5', '--set', 'time.end=1.5', '--script', 'export.script'], {cwd: scratch});
	return fs.readdirSync(scratch).filter((name) => /^page-.*(csv|ini)$/.test(name));
}

async function dropped_scenario() {
	await open(one);
	await until(has('Space pause'));
	const own = path.join(scratch, 'own.ini');
	const text = (title) => `[scenario]\ntitle = ${title}\nproblem = bar\nmethod = mpm\n`;
	fs.writeFileSync(own, text('Brought in by hand'));
	const chooser = await page.$('#bring');
	await chooser.uploadFile(own);
	await shows('a scenario from outside is opened', has('Brought in by hand'));
	await page.evaluate((text) => {
		const dropped = new DataTransfer();
		dropped.items.add(new File([text], 'other.ini'));
		document.dispatchEvent(new DragEvent('drop', {dataTransfer: dropped, bubbles: true, cancelable: true}));
	}, text('Dropped on the page'));
	await shows('and one that is dropped', has('Dropped on the page'));
	fs.writeFileSync(own, text('Brought in anew'));
	await chooser.uploadFile(own);
	await shows('the same file comes again as it is now', has('Brought in anew'));
	fs.writeFileSync(path.join(scratch, 'page.html'), '<p>x');
	await chooser.uploadFile(path.join(scratch, 'page.html'));
	await becomes('what is no file of matvib is refused in a line', notice_of, (text) => /can be opened, not page\.html/.test(text));
}

async function dropped_series() {
	native_export();
	await open(one + '?scenario=mode5&set=mesh.cell_size=0.5');
	await until(has('Space pause'));
	await halt();
	await (await page.$('#bring')).uploadFile(path.join(scratch, 'page-series.csv'));
	await becomes('a diagnosis of a series is offered', notice_of, (text) => /which code made its numbers/.test(text));
	await page.click('#notice button');
	await shows('and it is told whose numbers they are', has('Right, USF, to 16 digits'));
	await page.keyboard.press('Escape');
	await type(':fit bar.youngs_modulus\r');
	await shows('and what fits them', (text) => /fitted: bar\.youngs_modulus 100 /.test(text));
	await open(one);
	await until(has('Space pause'));
	await page.evaluate((text) => {
		open_one({scenario: 'mode5'});
		bring([new File([text], 'early.ini')]);
	}, '[scenario]\ntitle = Dropped at once\nproblem = bar\nmethod = mpm\n');
	await shows('a file that comes before the program is there waits for it', has('Dropped at once'));
	await page.evaluate(() => { stop(); bring([new File(['x'], 'late.csv')]); });
	await page.waitForFunction(() => /Begin first/.test(document.getElementById('notice').textContent)).catch(() => {});
	result('one that comes when there is none is told to wait', /Begin first; then late\.csv/.test(await notice_of()), await notice_of());
}

// Under remote control a touch of Firefox lasts until its page has heard of the beginning: on a busy one it may be a long one, which selects.
async function tap(x, y) {
	for (let left = 20, long = true; long && left > 0; left--) {
		await engine.tap(x, y);
		long = engine === engines.Firefox && await page.evaluate(() => !element('selected').hidden && (element('selected').lastChild.click(), true));
	}
}

// in the middle of a character
async function tap_at(column, row) {
	const at = await page.evaluate((column, row) => {
		const box = document.querySelector('.xterm-screen').getBoundingClientRect();
		return {x: box.left + (column + .5) * box.width / term.cols, y: box.top + (row + .5) * box.height / term.rows};
	}, column, row);
	await tap(at.x, at.y);
}
const tap_word = async (word) => tap_at(...await page.evaluate((word) => [(offers().find((offer) => offer.word === word) || {from: 0}).from + 1, term.rows - 1], word));
async function tap_text(text, into = 0) {
	const rows = (await screen()).split('\n'), row = rows.findIndex((line) => line.includes(text));
	await tap_at(row < 0 ? 0 : rows[row].indexOf(text) + into, row < 0 ? 0 : row);
}
async function tap_button(label) {
	// the row is made new when the key line changes: a button is tapped once it has stayed where it is
	for (let i = 0, before = ''; i < 200; i++) {
		const box = await page.evaluate((label) => {
			const button = [...document.querySelectorAll('#keys button')].find(({textContent}) => textContent === label || textContent.startsWith(label + ' '));
			if (!button) return null;
			button.scrollIntoView();
			const {x, y, width, height} = button.getBoundingClientRect();
			return {x: x + width / 2, y: y + height / 2};
		}, label);
		if (box && JSON.stringify(box) === before) return tap(box.x, box.y);
		before = JSON.stringify(box);
		await pause(100);
	}
	result('there is a button ' + label, false, await page.$eval('#keys', (nav) => nav.textContent));
}

async function lesson_by_taps() {
	await open(one + '?lesson=one-step', {width: 412, height: 915}, true);
	await shows('a lesson on a telephone', (text) => /1 of \d+|1\/\d+/.test(text));
	await shot('412x915');
	result('keys for fingers are there', await page.$eval('#keys', (nav) => !nav.hidden && nav.children.length > 8));
	const pages = Number(/1(?: of |\/)(\d+)/.exec(await screen())[1]);
	for (let i = 2; i <= pages; i++) {
		await tap_button('n next');
		await shows(`a tap leads to page ${i} of ${pages}`, (text) => new RegExp(`\\b${i} of \\d+|\\b${i}/\\d+`).test(text));
	}
	await tap_button('b back');
	await shows('and one back', (text) => new RegExp(`\\b${pages - 1} of \\d+|\\b${pages - 1}/\\d+`).test(text));
	result('no keyboard comes by itself', await page.evaluate(() => term.textarea.inputMode === 'none'));
	await open(endless, {width: 1024, height: 768}, true);
	await until(has('Space pause'));
	await shot('1024x768');
	await tap_word('pause');
	await shows('a tap on a word of the key line presses it', has('Space run'));
	await page.setViewport(Object.assign({width: 820, height: 1180}, engine.fingers));
	await becomes('the header of a tablet is one row', () => page.$eval('header', (header) => header.offsetHeight), (height) => height >= 44 && height < 60);
}

// from the plain sheet to the full one and back, and into a step, without a keyboard
async function sheets_by_taps() {
	await open(endless, {width: 1024, height: 768}, true);
	await until(has('Space pause'));
	await tap_word('pause');
	await until(has('Space run'));
	await tap_word('full');
	await shows('a tap on the key line opens the full sheet', (text) => /MPM USF hat/.test(text) && /\. step/.test(text));
	await shot('full');
	await tap_word('run');
	await shows('whose key line is tapped too', has('Space pause'));
	await tap_word('pause');
	await until(has('Space run'));
	await tap_word('stage');
	await shows('a tap on its key line opens a step', has('Stage 1 of 7'));
	await tap_button('f sheet');
	await shows('a tap leads back to the plain sheet', (text) => /f full/.test(text) && /t tries cell size/.test(text));
}

// what lies in the picture of one cell is chosen by a finger
async function cell_by_taps() {
	await open(one + '?lesson=one-step', {width: 1024, height: 768}, true);
	await until((text) => /1 of \d+|1\/\d+/.test(text));
	await tap_button('n next');
	await until((text) => /2 of \d+|2\/\d+/.test(text));
	await tap_button('n next');
	await shows('a lesson shows two cells from near', (text) => /particle 25, (next )?stage/.test(text) && /○ 24/.test(text));
	await tap_text('○ 24');
	await shows('a tap on a particle chooses it', (text) => /particle 24, (next )?stage/.test(text));
	await shot('cell');
	// the nodes lie on the line of the mesh, whose height in its row is the window's
	const line = (await screen()).match(/●[⠉⠒⠤⣀]/);
	await tap_text(line ? line[0] : '●⣀');
	await shows('and one on a node the node', (text) => /node 12, (next )?stage/.test(text));
}

async function homework() {
	await open(one + '?lesson=homework-late&name=Ada&id=7');
	await shows('homework opens for the name of a link', (text) => /Ada/.test(text) || /1 of \d+|1\/\d+/.test(text));
	result('whose it is stands on the page from the start', /^homework of Ada/.test(await page.$eval('#whose', (span) => span.textContent)));
	await page.evaluate(() => { // an answer is there before the file
		const take = worker.onmessage, files = [];
		worker.onmessage = (event) => { event.data.file ? files.push(event) : take(event); };
		window.let_files = () => { worker.onmessage = take; files.forEach(take); };
	});
	await answer('42');
	await page.evaluate(() => let_files());
	const name = 'homework-late-Ada.session';
	let bytes = await sooner(() => file(name), (found) => found && /Enter\n$/.test(found));
	result('it is recorded', bytes && bytes.includes('Ada') && /Enter\n$/.test(bytes), bytes + await screen());
	// a key is recorded while the mouse is down
	await page.waitForSelector('#whose button');
	const stays = await page.evaluateHandle(() => document.querySelector('#whose button'));
	await page.keyboard.press('b');
	bytes = await sooner(() => file(name), (found) => found && / b\n$/.test(found));
	result('a button stays while the file grows', await stays.evaluate((button) => button.isConnected));
	result('whose it is stands on the page', /homework of Ada/.test(await page.$eval('#whose', (span) => span.textContent)));
	const other = await context.newPage();
	await other.goto(one + '?lesson=homework-late&name=Bob', {timeout: patience});
	await other.waitForFunction(() => /Another tab/.test(document.getElementById('notice').textContent), {timeout: patience}).catch(() => {});
	result('another tab keeps none meanwhile', /Another tab/.test(await other.$eval('#notice', (p) => p.textContent)));
	await other.close();
	await page.bringToFront();
	await page.goto(one);
	await until(has('Space pause'));
	const after = await file(name);
	result('it survives a reload', bytes && after && after.equals(bytes));
	// a session that was cut off has no end: it is done again, and goes on
	result('what was cut off cannot be handed in', /^kept here: go on with Ada's \(1 answer, \d\d:\d\d\)$/.test(await text_of('#whose')), await text_of('#whose'));
	await page.click('#whose button');
	await until(has('the laboratory is yours'));
	await page.keyboard.press(' ');
	await page.waitForFunction(() => document.querySelector('#whose button')?.textContent === 'hand in').catch(() => {});
	result('her name stays on the page', /^homework of Ada /.test(await text_of('#whose')), await text_of('#whose'));
	await page.click('#whose button');
	result('handing in says what it does', /ends your homework.*save the file for your teacher/.test(await text_of('#hand-sheet')), await text_of('#hand-sheet'));
	await page.evaluate(() => Object.assign(navigator, {canShare: () => true, share: async ({files}) => { window.shared = files[0].name; }}));
	await page.click('#hand-now');
	await page.waitForFunction(() => document.getElementById('end-sheet').open).catch(() => {});
	result('it goes on and is handed in', /save the file for your teacher: homework-late-Ada-go1\.session/.test(await text_of('#end-files')), await screen());
	await page.evaluate(() => [...document.querySelectorAll('#end-files button')].find((button) => button.textContent === 'share it').click());
	await becomes('or shared, where the system does that', () => page.evaluate(() => window.shared), (name) => name === 'homework-late-Ada-go1.session');
	await page.click('#end-files button');
	result('and it is told where the file is', /where this browser puts downloads/.test(await text_of('#end-files')), await text_of('#end-files'));
	fs.writeFileSync(path.join(scratch, name), (await file('homework-late-Ada-go1.session')) || '');
	const graded = spawnSync(process.env.MATVIB, ['grade', 'homework-late', path.join(scratch, name)], {encoding: 'utf8'});
	result('and is graded natively', graded.status === 0 && /Ada/.test(graded.stdout), graded.stdout + graded.stderr);
	await page.evaluate(() => { document.getElementById('end-sheet').close(); document.getElementById('forget').click(); });
	result('"forget me" asks', await page.$eval('#forget-sheet', (sheet) => sheet.open) && (await page.evaluate(() => localStorage.length)) > 0);
	await page.click('#forget-sheet [value=forget]');
	await until(has('Space pause'));
	result('"forget me" leaves nothing', (await page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith('matvib/')).length)) === 0);
}

// From the first page of the homework to its question, and an answer, each key once the one before has been taken.
async function answer(text) {
	for (const number of [1, 2, 3]) {
		if (number > 1) await page.keyboard.press('n');
		await until((text) => new RegExp(`\\b${number} of \\d+|\\b${number}/\\d+`).test(text) && !text.includes('computing'));
	}
	await until(has('Enter: your answer'));
	await page.keyboard.press('Enter');
	await until((text) => /your answer/.test(text) && !has('Enter: your answer')(text));
	await type(text);
	await until((shown) => shown.includes(text));
	await page.keyboard.press('Enter');
	await until(has('Try again')); // keys that come while it is computed are not taken
}

// What was typed while the program ran is there after a reload, and after the tab has died.
async function homework_is_kept() {
	const begin = async (link) => {
		await open(one + link);
		await until((text) => /1 of \d+|1\/\d+/.test(text));
	};
	const keys = async (...list) => { for (const key of list) await page.keyboard.press(key); };
	const kept = () => page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith('matvib/work/')).map((key) => localStorage.getItem(key)).join('\n'));
	await begin('?lesson=homework-late&name=Eve&id=7');
	await keys(' ', ' ');
	await answer('5.5');
	await keys('b');
	await sooner(kept, (text) => / b\n$/.test(text));
	result('a key after the simulation has run is kept', /^at .* 5\n.*\nat .* 5\nat .* Enter\nat .* b\n$/m.test(await kept()), (await kept()).slice(-400) + await screen());
	const told = await page.evaluate(async () => {
		const begin = performance.now();
		let count = 0;
		worker.addEventListener('message', ({data}) => { count += /session$/.test(data.file); });
		for (let i = 0; i < 40; i++) {
			press(' ');
			await new Promise((done) => { setTimeout(done, 50); });
		}
		return [count, 2 + (performance.now() - begin) / 1000];
	});
	result('the file is told of at most once a second', told[0] > 0 && told[0] <= told[1], told);
	await page.reload();
	await is_open('kept-sheet');
	result('a reload offers to go on', /^go on with Eve's \(1 answer, \d\d:\d\d\)start againit was somebody else$/.test(await text_of('#kept')), await text_of('#kept'));
	result('of the lesson that is chosen above', (await page.$eval('#chooser', (chooser) => chooser.value)) === 'lesson homework-late');
	await shot('go-on');
	await page.click('#kept button');
	await shows('and goes on where it was', (text) => /[23] of \d+|[23]\/\d+/.test(text));
	await until(has('the laboratory is yours'));
	await keys(' ', ' ');
	await sooner(() => page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith('matvib/work/')).length), (count) => count === 1); // the one before is left
	const entries = async () => ((await kept()).match(/^at /gm) || []).length;
	for (const [target, name] of [['document', 'visibilitychange'], ['document', 'freeze'], ['window', 'pagehide']]) {
		const before = await sooner(entries, Boolean);
		const asks = await page.evaluate((target, name) => {
			const begun = worker, sent = [];
			begun.postMessage = (message) => { sent.push(...Object.keys(message)); Worker.prototype.postMessage.call(begun, message); };
			press(' ');
			window[target].dispatchEvent(new Event(name));
			delete begun.postMessage;
			return sent.join();
		}, target, name);
		result('what is written is asked for with ' + name, asks === 'keys,look', asks);
		await becomes('and kept', entries, (now) => now > before);
	}
	if (engine === engines.Chromium) {
		const before = (await kept()).length;
		await keys('b');
		await becomes('a key is kept', kept, (text) => text.length > before);
		const client = await page.createCDPSession(), dead = new Promise((done) => page.once('error', done));
		client.send('Page.crash').catch(() => {});
		await Promise.race([dead, pause(patience)]);
		page.close().catch(() => {});
		page = null;
		await open(one);
		await until(has('Space pause'));
		result('what was done is there after the tab has died', (await kept()).length > before, `${before} ${(await kept()).length}`);
	}
	await page.evaluate(() => localStorage.clear());
	for (const [name, id] of [['李雷', '1'], ['王芳', '2'], ['Zoë Müller-Ångström', '3']]) {
		await begin(`?lesson=homework-late&name=${encodeURIComponent(name)}&id=${id}`);
		await keys(' ', ' ', 'n');
		await becomes(name + ' has a file', kept, (text) => text.includes('\nid ' + id + '\n') && / n\n/.test(text));
	}
	await open(one + '?lesson=homework-late');
	await is_open('kept-sheet');
	const rows = await text_of('#kept');
	result('each student has a file and a row', (await page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith('matvib/work/')).length)) === 3 &&
		['李雷', '王芳', 'Zoë Müller-Ångström'].every((name) => rows.split(name).length === 2 + (name[0] === 'Z')), rows);
	await page.click('#kept li:last-child button');
	await is_open('whose-sheet');
	await page.click('#whose-sheet [value=begin]');
	result('a name is asked for', await is_open('whose-sheet') && /nothing is kept/.test(await text_of('#name-needed')));
	await page.click('#whose-sheet [value=look]');
	await until((text) => /1 of \d+|1\/\d+/.test(text));
	result('without one the header says that nothing is kept', /only looking: nothing is kept/.test(await text_of('#whose')), await text_of('#whose'));
	await page.evaluate(() => localStorage.clear());
	await open(one + '?scenario=mode5');
	await until(has('Space pause'));
	await keys('f');
	await page.waitForFunction(() => /sheet=full/.test(location.search));
	await page.select('#chooser', 'lesson homework-late');
	await is_open('whose-sheet');
	await page.type('#name', 'Bob');
	await page.click('#whose-sheet [value=begin]');
	await until((text) => /1 of \d+|1\/\d+/.test(text));
	await keys('n'); // with the first key there is a file
	await becomes('the sheet that one student chose is not the next one\'s', kept, (text) => /^student Bob$/m.test(text) && /^sheet plain$/m.test(text));
	await page.evaluate(() => localStorage.clear());
}

// The run is paused or over, however slow the machine is.
async function halt() {
	const stands = (text) => /Space (run|again)/.test(text);
	await until(has('Space'));
	if (!stands(await screen())) await page.keyboard.press(' ');
	// a run that has ended before the key came asks whether it is to begin again
	if (stands((await until((text) => stands(text) || text.includes('run again from'))).text)) return;
	await page.keyboard.press('Escape');
	await until(stands);
}

async function address() {
	const where = () => page.evaluate(() => location.search);
	await open(one + '?scenario=mode5&set=mesh.cell_size:0.5');
	await shows('a link sets a parameter', (text) => /cell size +0\.5/.test(text));
	result('the title names the scenario', (await page.title()) === 'Why is mode 5 late? - matvib', await page.title());
	await type('f');
	await page.waitForFunction(() => /sheet=full/.test(location.search)).catch(() => {});
	result('the address follows the sheet', /^\?scenario=mode5&set=mesh\.cell_size:0\.5&sheet=full$/.test(await where()), await where());
	await page.reload();
	await shows('and a reload has it again', (text) => /MPM USF hat/.test(text) && /cell size +0\.5/.test(text));
	await page.select('#chooser', 'scenario mode1');
	await until(has('Where mesh and bar agree'));
	result('another scenario is another address', (await where()) === '?scenario=mode1', await where());
	await page.goBack().catch(() => {});
	await shows('Back goes to the one before', (text) => /cell size +0\.5/.test(text));
	// output of the program before that the terminal has still to read
	const before = await page.evaluate(() => history.length);
	await page.evaluate(() => {
		term.write(new Uint8Array(400000).fill(32));
		term.write('\x1b]7770;P0;T0;Ncrossing\x07');
		return open_one({scenario: 'mode5', sets: ['mesh.cell_size=0.5'], sheet: 'full'});
	});
	await until((text) => /cell size +0\.5/.test(text));
	await page.waitForFunction(() => followed).catch(() => {});
	await page.evaluate(() => new Promise((done) => { setTimeout(done, FOLLOWS + 1); })); // behind what would follow it
	result('what the program before tells late is not followed', (await where()) === '?scenario=mode5&set=mesh.cell_size:0.5&sheet=full' &&
		(await page.evaluate(() => history.length)) === before, await where());
	const comes = (wanted) => page.waitForFunction((wanted) => location.search === wanted, {}, wanted).then(() => true, () => false);
	await halt();
	await type(':initial.mode=3\r');
	result('the address follows what is changed in the program', await comes('?scenario=mode5&set=initial.mode:3&set=mesh.cell_size:0.5&sheet=full'), await where());
	result('and the link', (await page.evaluate(() => link_to_opened())).endsWith('?scenario=mode5&set=initial.mode:3&set=mesh.cell_size:0.5&sheet=full'));
	await page.evaluate(() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; });
	await page.click('#link');
	await becomes('which a button copies', () => page.evaluate(() => window.copied === link_to_opened()), Boolean);
	await page.reload();
	await shows('a reload keeps it', (text) => /mode +3/.test(text) && /cell size +0\.5/.test(text));
	await halt();
	await type(':open pull\r');
	result('what is opened in the program is another address', await comes('?scenario=pull&sheet=full'), await where());
	result('with its title', /^(?!Why is mode 5).* - matvib$/.test(await page.title()), await page.title());
	await page.goBack().catch(() => {});
	await shows('from which Back goes to the one before, as it was changed', (text) => /mode +3/.test(text) && /cell size +0\.5/.test(text));
}

async function size_of_type() {
	await open(one + '?scenario=mode5');
	await until(has('Space pause'));
	await halt();
	const size = () => page.evaluate(() => term.options.fontSize), first = await size();
	await page.keyboard.press('L');
	result('L raises the size of the type', await page.waitForFunction((first) => term.options.fontSize > 1.2 * first, {}, first).then(() => true, () => false), await size());
	await until(has('Space'));
	await shot('large');
	await page.keyboard.press('L');
	result('and gives it back', await page.waitForFunction((first) => term.options.fontSize === first, {}, first).then(() => true, () => false), await size());
	for (const [key, holds] of [['+', (now) => now > first], ['-', (now) => now === first], ['-', (now) => now < first], ['0', (now) => now === first]]) {
		await page.keyboard.down('Control'); await page.keyboard.press(key); await page.keyboard.up('Control');
		await becomes('Ctrl with ' + key + ' changes it', size, holds);
	}
	await page.click('#larger');
	await becomes('and A+', size, (now) => now > first);
	if (engine !== engines.Chromium) return;
	await open(one, {width: 1024, height: 768}, true);
	await until(has('Space pause'));
	const before = await size();
	await fingers([[400, 400], [500, 400]], [[300, 400], [600, 400]]);
	await becomes('two fingers change it', size, (now) => now > before);
}

// Fingers of Chromium that go from where to where, held still before until `still` has come; else for a twentieth of a second, by
// the time of the events, however long a loaded machine takes for them.
async function fingers(from, to, still) {
	const client = await page.createCDPSession(), points = (list) => list.map(([x, y], id) => ({x, y, id}));
	const timestamp = Date.now() / 1000, end = still ? {} : {timestamp: timestamp + .05};
	await client.send('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: points(from), timestamp});
	if (still) await still();
	for (let i = 1; i <= 10 && to; i++)
		await client.send('Input.dispatchTouchEvent', {type: 'touchMove', touchPoints: points(from.map(([x, y], k) => [x + (to[k][0] - x) * i / 10, y + (to[k][1] - y) * i / 10]))});
	await client.send('Input.dispatchTouchEvent', Object.assign({type: 'touchEnd', touchPoints: []}, end));
	await client.detach();
}

async function selecting() {
	await open(one + '?scenario=mode5');
	await until(has('Space pause'));
	await halt();
	const place = (column, row) => page.evaluate((column, row) => {
		const box = document.querySelector('.xterm-screen').getBoundingClientRect();
		return [box.left + (column + .5) * box.width / term.cols, box.top + (row + .5) * box.height / term.rows];
	}, column, row);
	const selection = () => page.evaluate(() => term.getSelection()), selected = () => sooner(selection, Boolean);
	const first = (await screen()).split('\n')[0];
	await page.keyboard.down('Shift');
	await page.mouse.move(...await place(0, 0));
	await page.mouse.down();
	await page.mouse.move(...await place(10, 0), {steps: 5});
	await page.mouse.move(...await place(20, 0), {steps: 5});
	await page.mouse.up();
	await page.keyboard.up('Shift');
	await becomes('dragging with Shift selects', selection, (text) => text.length >= 19 && first.includes(text.trim()));
	if (engine !== engines.Chromium) return;
	await open(endless, {width: 1024, height: 768}, true);
	await until(has('Space pause'));
	await tap_word('pause');
	await until(has('Space run'));
	const row = (await screen()).split('\n').findIndex((line) => line.includes('cell size')), column = (await screen()).split('\n')[row].indexOf('cell size');
	await fingers([await place(column + 1, row)], null, selected);
	await becomes('a long touch selects a word', selection, (text) => text === 'cell');
	await page.evaluate(() => term.clearSelection());
	await fingers([await place(column + 1, row)], [await place(column + 7, row)], selected);
	await becomes('and from there to where the finger goes', selection, (text) => text === 'cell siz');
	await page.waitForFunction(() => !element('selected').hidden).catch(() => {});
	result('which a button copies', /^copy cancel/.test(await text_of('#selected')) && await page.$eval('#selected', (part) => !part.hidden), await text_of('#selected'));
	await page.evaluate(() => { window.copied = ''; navigator.clipboard.writeText = async (text) => { window.copied = text; }; });
	await page.click('#selected button');
	await becomes('all of it', () => page.evaluate(() => window.copied), (text) => text === 'cell siz');
	await page.evaluate(() => term.element.addEventListener('touchstart', () => { // so busy that it hears of the end late
		for (const begin = performance.now(); performance.now() - begin < 800;);
	}));
	await fingers([await place(column + 1, row)], null);
	await page.evaluate(() => new Promise((done) => { setTimeout(done, LONG + 1); })); // behind what would select
	result('a short one selects nothing, however busy the page is', (await selection()) === '', await selection());
}

const paste = (text) => page.evaluate((text) => {
	const clip = new DataTransfer();
	clip.setData('text/plain', text);
	term.textarea.dispatchEvent(new ClipboardEvent('paste', {clipboardData: clip, dataType: 'text/plain', data: text, bubbles: true, cancelable: true}));
}, text);

// What a browser's keys are for stays so.
async function browser_keys() {
	await open(one);
	await until(has('Space pause'));
	await page.evaluate(() => {
		window.note_key = (event) => { window.taken = (window.taken || '') + (event.defaultPrevented ? '+' : '-') + event.key; event.preventDefault(); };
		addEventListener('keydown', note_key);
	});
	for (const key of ['r', 'f', 'p', 's', 'l']) { await page.keyboard.down('Control'); await page.keyboard.press(key); await page.keyboard.up('Control'); }
	for (const key of ['F3', 'F5', 'F11']) await page.keyboard.press(key);
	const taken = await page.evaluate(() => {
		removeEventListener('keydown', note_key);
		return window.taken.replace(/.Control/g, '');
	});
	result('Ctrl with R, F, P, S, L and F3, F5, F11 are the browser\'s', taken === '-r-f-p-s-l-F3-F5-F11', taken);
	await page.keyboard.down('Control'); await page.keyboard.press('c'); await page.keyboard.press('c'); await page.keyboard.up('Control');
	const copied = await page.evaluate(() => {
		term.select(0, 0, 20);
		const copy = new ClipboardEvent('copy', {clipboardData: new DataTransfer(), bubbles: true, cancelable: true});
		term.textarea.dispatchEvent(copy);
		const text = copy.clipboardData.getData('text/plain');
		term.clearSelection();
		return text;
	});
	result('a selection is copied', copied.trim().length > 3, copied);
	await type(':');
	const {time: answered} = await look_for((text) => text.split('\n').pop().startsWith(' :'));
	result('Ctrl+C does not end the program', answered < Infinity && !(await page.$eval('#end-sheet', (sheet) => sheet.open)));
	await paste('mesh.cell_size=0.25');
	await shows('what is pasted is typed', has('mesh.cell_size=0.25'));
	await page.keyboard.press('Escape');
	await paste('[scenario]\ntitle = Pasted as text\nproblem = bar\nmethod = mpm\n');
	await shows('a scenario that is pasted is opened', has('Pasted as text'));
	await page.evaluate(() => { press('\x1b'); press(':mesh'); press('\x1b'); press(':behind\r'); });
	await shows('a key right behind Esc is a key of its own', has('behind'));
	const focus = () => page.evaluate(() => document.activeElement.id || document.activeElement.className);
	await page.keyboard.press('F6');
	const left = await focus();
	await page.keyboard.press('F6');
	result('F6 leaves the program and comes back', left === 'chooser' && /xterm/.test(await focus()), left + ' ' + await focus());
	const marks = await page.evaluate(() => ['header', 'main', 'nav', 'h1', '#skip'].every((mark) => document.querySelector(mark)) && /F6/.test(term.textarea.getAttribute('aria-label')) &&
		/F6/.test(element('about-sheet').textContent));
	result('landmarks, a heading, a skip link, and F6 told', marks);
	await page.focus('#skip');
	await page.keyboard.press('Enter');
	result('the skip link, first of all, leads to the program', (await page.evaluate(() => document.querySelector('a, button, select, input').id)) === 'skip' && /xterm/.test(await focus()), await focus());
	result('what the screen shows can be read aloud', await page.$eval('.xterm-rows', (rows) => !rows.closest('[aria-hidden]') && /Pasted/.test(rows.textContent)));
	await page.keyboard.press('F6');
	for (let i = 0; i < 12 && (await focus()) !== 'words'; i++) await page.keyboard.press('Tab');
	await page.keyboard.press('Enter');
	await becomes('plain words are reached by the keyboard', focus, (id) => id === 'line');
}

// A frame that forbids forms, downloads and storage.
async function sandboxed() {
	await open(served + 'frame.html');
	let frame = null;
	for (let i = 0; i < patience / 50 && !(frame = page.frames().find((frame) => /matvib\.html/.test(frame.url()))); i++) await pause(50);
	const shown = await frame.waitForFunction(() => {
		if (typeof term === 'undefined') return false;
		const buffer = term.buffer.active;
		for (let i = 0; i < term.rows; i++) if (/Space pause/.test(buffer.getLine(buffer.viewportY + i).translateToString(true))) return true;
		return false;
	}).then(() => true, () => false);
	result('it opens in a frame that is sandboxed', shown);
	result('that takes no focus', await page.evaluate(() => document.activeElement === document.body));
	await becomes('that nothing is kept is told there', () => frame.$eval('#notice', (p) => p.textContent), (text) => /keeps nothing for this page \(SecurityError\)/.test(text));
	await frame.evaluate(() => element('files').click());
	await frame.evaluate(() => document.querySelector('#files-sheet [value=close]').click());
	result('whose sheets close without forms', await frame.evaluate(() => !element('files-sheet').open));
	await frame.evaluate(() => element('link').click());
	await becomes('a link is copied, or shown where that is forbidden', () => frame.$eval('#notice', (p) => p.textContent),
		(text) => /matvib\.html\?scenario=mode5|on the clipboard/.test(text));
	await frame.evaluate(() => save('x.csv', new Uint8Array(3)));
	result('a download that may be forbidden is told', /frame allows no downloads/.test(await frame.$eval('#notice', (p) => p.textContent)));
}

// Curves and maps as lines and pixels, over cells that keep what they hold.
async function lines() {
	const drawn = () => page.evaluate(() => {
		const canvas = vectors.canvas, bytes = canvas ? canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data : [];
		let count = 0;
		for (let i = 3; i < bytes.length; i += 4) count += bytes[i] > 0;
		return count;
	});
	for (const scenario of ['mode5', 'notched-beam-coarse']) {
		await open(one + '?scenario=' + scenario);
		await until(has('Space pause'));
		await sooner(() => page.evaluate(() => vectors.turn(true)).then(drawn), (count) => count > 2000); // a slow machine may have turned it off
		await halt();
		await page.evaluate(() => vectors.turn(true));
		await becomes(`${scenario}: the picture comes as lines`, () => page.evaluate(() => vectors.areas.map((area) => area.strokes.length + (area.map ? ' map' : ''))),
			(found) => found.some((area) => parseInt(area) > 0) && found.some((area) => / map/.test(area)) === (scenario !== 'mode5'));
		await becomes('which are drawn', drawn, (count) => count > 2000);
		await becomes('and solid ones in the legend', () => page.evaluate(() => {
			const samples = vectors.areas.filter(({rect}) => rect[2] === 2 && rect[3] === 1), pen = vectors.canvas.getContext('2d');
			const across = vectors.canvas.width / term.cols, down = vectors.canvas.height / term.rows;
			const inks = samples.map(({rect: [x, y]}) => new Set(new Uint32Array(pen.getImageData(Math.ceil(x * across), Math.round((y + .5) * down), Math.floor(2 * across) - 1, 1).data.buffer)));
			return samples.length > 0 && inks.every((some, i) => samples[i].strokes[0].line > 0 || (some.size === 1 && !some.has(0)));
		}), Boolean);
		if (scenario !== 'mode5') result('beside the legend, which is left', await page.evaluate(() => vectors.areas.some((area) => area.map && area.crossed.slice(0, area.rect[2]).every((cell) => cell === 0))));
		result('over cells that keep theirs', /[\u2801-\u28ff\u2580-\u2588]{3}/.test(await screen()));
		const seams = await page.evaluate(() => {
			const rows = Array.from({length: term.rows}, (_, y) => term.buffer.active.getLine(y).translateToString(false)), pen = vectors.canvas.getContext('2d');
			const y = rows.findLastIndex((row) => row.includes('██')), x = y < 0 ? 0 : rows[y].lastIndexOf('██'), across = vectors.canvas.width / term.cols, down = vectors.canvas.height / term.rows;
			const inks = [...pen.getImageData(Math.round(x * across), Math.round(y * down), Math.round(2 * across) - 1, Math.floor(down / 2)).data].map((value, i) => [i % 4, value].join(' '));
			return y < 0 || new Set(inks).size !== 4;
		});
		result('blocks have no seams', !seams);
		await shot('lines-' + scenario);
		await page.keyboard.press('F9');
		await becomes('F9 shows the cells', drawn, (count) => count === 0);
		await page.keyboard.press('F9');
		await becomes('and the lines again', drawn, (count) => count > 2000);
		await page.evaluate(() => {
			const draw = vectors.draw;
			window.drawings = {lines: 0, cells: 0};
			vectors.draw = function() { drawings.lines++; draw.call(this); };
			term.onRender(() => drawings.cells++);
		});
		await page.keyboard.press('f');
		await sooner(() => page.evaluate(() => drawings.cells), Boolean);
		await pause(200); // for a second drawing
		const {lines, cells} = await page.evaluate(() => drawings);
		result('a picture is drawn once, with its cells', lines > 0 && lines <= cells, `${lines} drawings of ${cells} pictures`);
	}
	const costs = (said, dear) => page.evaluate((said, dear) => {
		notice(said);
		vectors.turn(true, false);
		vectors.costs = Array.from({length: DRAWINGS - 1}, (_, i) => (i < dear ? 100 : 1));
		vectors.draw();
		return vectors.on + ' ' + element('notice').textContent;
	}, said, dear);
	result('a few dear pictures leave the lines', /^true $/.test(await costs('', 15)));
	const dear = [await costs('', 30), await costs('to be read', 30)];
	result('where they cost too much they are characters, and it is said', /^false Lines are drawn as characters/.test(dear[0]), dear[0]);
	result('but not over what is to be read', dear[1] === 'false to be read', dear[1]);
	await open(one + '?scenario=two-discs');
	await until(has('Space pause'));
	await halt();
	await page.evaluate(() => vectors.turn(true));
	await becomes('two bodies have the colours of their names', () => page.evaluate(() => {
		const map = vectors.areas.map((area) => area.map).find(Boolean), found = new Set();
		const letters = new Set(map ? [...map.styles.replace(/[\d.]/g, '')].map((letter) => vectors.colour(letter.charCodeAt(0) - 64)) : []);
		const bytes = map ? vectors.image(map).getContext('2d').getImageData(0, 0, map.columns, map.rows).data : [];
		for (let i = 0; i < bytes.length; i += 4) if (bytes[i + 3]) found.add('rgb(' + bytes.slice(i, i + 3).join() + ')');
		return [[...letters].sort(), [...found].sort()];
	}), (bodies) => bodies[0].length === 2 && bodies[0].join() === bodies[1].join());
	await becomes('without holes', () => page.evaluate(() => {
		const {map} = vectors.areas.find((area) => area.map), {columns, rows} = map, bytes = vectors.image(map).getContext('2d').getImageData(0, 0, columns, rows).data;
		let holes = 0, filled = 0;
		for (let i = 1; i < columns * rows - 1; i++) {
			const [before, here, after] = [-1, 0, 1].map((step) => bytes[4 * (i + step) + 3] > 0);
			holes += before && !here && after;
			filled += here;
		}
		return [filled, holes];
	}), ([filled, holes]) => filled > 1000 && holes === 0);
	await open(one + '?scenario=mode5&set=time.end:3', {width: 1366, height: 768}); // particles of its curve are discs
	await until(has('Space again'));
	await page.evaluate(() => vectors.turn(true));
	await becomes('a disc that is drawn has its character hidden, in the row beside it too', () => page.evaluate(() => vectors.areas.map((area) => {
		const {rect: [left, top, columns, rows], marks} = area, free = vectors.free(area, new Set());
		const seen = free.filter((inside, i) => !inside && term.buffer.active.getLine(top + Math.floor(i / columns)).getCell(left + i % columns).getCode() === DISC);
		return marks.some(({glyph}) => glyph === DISC) && rows > 4 ? seen.length : 0;
	}).join(' ') + ' of ' + vectors.areas.flatMap(({marks}) => marks).filter(({glyph}) => glyph === DISC).length), (found) => /^0( 0)* of [4-9]\d$/.test(found));
	await open(endless + '&sheet=full');
	await until(has('Space pause'));
	await halt();
	await page.keyboard.press(']'); // the bar with its cells
	await until(has('Stage 1'));
	await page.evaluate(() => vectors.turn(true));
	await becomes('particles of the bar and nodes come as marks', () => page.evaluate(() => vectors.areas.flatMap((area) => area.marks.map(({glyph}) => String.fromCharCode(glyph))).join('')),
		(marks) => marks.split('·').length > 40 && marks.includes('●'));
	await shot('marks');
	await page.evaluate(() => term.select(0, 0, 5));
	await becomes('a selection is seen in the cells', drawn, (count) => count === 0);
}

async function telephone() {
	await open(one + '?scenario=mode5&set=time.end:5', {width: 412, height: 915}, true); // what is edited is computed again
	await until(has('Space'));
	await shot('phone');
	await becomes('one column: question, bar, plot, number, parameters', screen, (stacked) => stacked.search('Which cures') < stacked.search('particles at') &&
		stacked.search('particles at') < stacked.search('v_cm') && stacked.search('v_cm') < stacked.search('periods') && stacked.search('periods') < stacked.search('cell size  '));
	const wide = await page.evaluate(() => [...document.querySelectorAll('header, body')].filter((part) => part.scrollWidth > part.clientWidth).length);
	result('the header is in sight as a whole', wide === 0);
	const small = await page.evaluate(() => [...document.querySelectorAll('button, select')].map((target) => [target.textContent.slice(0, 10), target.getBoundingClientRect()])
		.filter(([, box]) => box.width > 0 && (box.height < 43.5 || box.width < 43.5)).map(([name, box]) => name + ' ' + box.width + 'x' + box.height));
	result('targets are 44 pixels', small.length === 0, small.join());
	await halt();
	await tap_button('Enter');
	await becomes('a field has a pad of numbers, and no key that would be typed into it', () => page.$$eval('#keys button', (buttons) => buttons.map((button) => button.textContent).join(' ')),
		(pad) => /^1 2 3 4 5 6 7 8 9 0 \. - \/ e ⌫ Enter Esc/.test(pad) && !/sheet|next/.test(pad));
	await shot('phone-pad');
	for (let i = 0; i < 4; i++) await tap_button('⌫');
	for (const key of ['0', '.', '2', 'Enter']) await tap_button(key);
	await shows('which enters a number', (text) => /Courant number +0\.2\b/.test(text));
	if (engine === engines.Chromium) {
		await tap_button('?');
		const {text: help} = await until((text) => !/Courant number/.test(text));
		await fingers([[200, 600]], [[200, 200]]);
		await shows('a swipe scrolls the help', (text) => text !== help && text.split('\n')[0] === help.split('\n')[0]);
		await tap_button('Esc');
		await until((text) => /Courant number/.test(text));
	}
	await page.setViewport({width: 915, height: 412, isMobile: true, hasTouch: true});
	await shows('another size when it is turned', (text) => text.split('\n').length < 30 && has('Space')(text));
	await shot('phone-turned');
	for (const scenario of ['notched-beam-coarse', 'branching-coarse']) {
		await open(one + '?scenario=' + scenario, {width: 844, height: 390}, true);
		await shows(`${scenario}: on its side a telephone has the number and what is asked`, (text) => /Space pause/.test(text) && /crit\./.test(text) && /t tries/.test(text));
		result('beside the map', await page.evaluate(() => vectors.areas.some(({map, rect}) => map && rect[2] >= 40 && rect[3] >= 8)), await screen());
		result('over the row of keys', await page.$eval('#keys', (keys) => !keys.hidden && keys.getBoundingClientRect().bottom <= innerHeight));
		await shot('phone-on-its-side-' + scenario);
	}
}

// On its side, with a field open: the header, whose homework it is, the row of the field and its keys stay in sight, over a soft keyboard too.
async function keyboard_on_its_side() {
	await open(one + '?lesson=homework-late&name=Ada&id=7', {width: 844, height: 390}, true);
	await until((text) => /1 of \d+|1\/\d+/.test(text));
	await tap_button('n next');
	await until((text) => /2 of \d+|2\/\d+/.test(text));
	await tap_button('n next');
	await until((text) => /3 of \d+|3\/\d+/.test(text) && text.includes('Enter: your answer') && !text.includes('computing'));
	const in_sight = () => page.evaluate(() => {
		const box = (found) => found.getBoundingClientRect(), cells = box(document.querySelector('.xterm-screen')), row = cells.height / term.rows;
		const top = cells.top + term.buffer.active.cursorY * row, {bottom} = box(document.querySelector('header')), keys = box(element('keys')), whose = box(element('whose'));
		const hidden = [...document.querySelectorAll('#keys button')].filter((button) => box(button).bottom > document.body.clientHeight + 1 || box(button).right > innerWidth + 1);
		return [box(document.querySelector('header')).top >= 0, whose.height > 0 && whose.bottom <= bottom + 1, /homework of Ada/.test(element('whose').textContent), top >= bottom - 1,
			top + row <= keys.top + 1, keys.bottom <= document.body.clientHeight + 1, hidden.length === 0, term.rows >= 12].map(Number).join('') + ' ' + term.rows + ' rows, ' + innerHeight;
	});
	const whole = (height) => (found) => found.startsWith('11111111 ') && found.endsWith(' ' + height);
	await tap_button('Enter');
	await page.waitForFunction(() => /^1234567890/.test(element('keys').textContent)).catch(() => {});
	await becomes('on its side the pad, the answer and whose homework it is are in sight', in_sight, whole(390));
	await shot('phone-pad-on-its-side');
	await tap_button('Esc');
	await until(has('Enter: your answer'));
	await page.evaluate(() => { // a program that draws late for a height that it is told
		const begun = worker;
		window.pads = 0;
		window.watches = new MutationObserver(() => { pads += element('keys').classList.contains('pad'); });
		watches.observe(element('keys'), {childList: true});
		begun.postMessage = (message) => { setTimeout(() => Worker.prototype.postMessage.call(begun, message), message.size ? 300 : 0); };
	});
	await type(':');
	await becomes('a line of words asks for the keyboard', () => page.evaluate(() => [term.textarea.inputMode, document.activeElement === term.textarea].join()), (found) => found === 'text,true');
	// the row of its keys is lower than the pad, and the program has what that leaves a frame later
	const rows = await sooner(() => page.evaluate(() => (fit.proposeDimensions().rows === term.rows ? term.rows : 0)), Boolean);
	const pads = await page.evaluate(() => new Promise((done) => { setTimeout(() => { watches.disconnect(); delete worker.postMessage; done(pads); }, 2000); }));
	result('whose keys stay while the program draws for their height', pads === 0, pads + ' pads of numbers came for it');
	await page.setViewport(Object.assign({width: 844, height: 190}, engine.fingers)); // as the keyboard leaves it
	await becomes('over which the line, its keys and whose homework it is are in sight', in_sight, whole(190));
	await shot('phone-keyboard-on-its-side');
	result('the program keeps its size', (await page.evaluate(() => term.rows)) === rows);
	await page.setViewport(Object.assign({width: 844, height: 390}, engine.fingers));
	await becomes('and all of it comes back', () => page.evaluate(() => [term.rows, element('screen').scrollTop, innerHeight].join()), (found) => found === rows + ',0,390');
	// a browser that lays its keyboard over the page
	await page.evaluate(() => {
		Object.defineProperty(visualViewport, 'height', {configurable: true, get: () => 190});
		visualViewport.dispatchEvent(new Event('resize'));
	});
	await becomes('the same where the keyboard lies over the page', in_sight, whole(390));
	await page.evaluate(() => localStorage.clear());
}

async function lesson_on_a_telephone() {
	await open(one + '?lesson=late', {width: 390, height: 844}, true);
	await until((text) => /1 of \d+|1\/\d+/.test(text));
	await tap_button('n next');
	await shows('a lesson on a narrow telephone has its text and its plot', (text) => /2\/11/.test(text) && /v_cm/.test(text));
	await shot('phone-lesson');
	await open(one + '?lesson=late', {width: 844, height: 390}, true);
	await until((text) => /1 of \d+|1\/\d+/.test(text));
	await tap_button('n next');
	await shows('and has them side by side when it lies on its side', (text) => /2\/11.*v_cm/.test(text) && /At t = 13\.1/.test(text));
}

async function answer_by_taps() {
	await open(one + '?lesson=homework-late&name=Ada&id=7', {width: 412, height: 915}, true);
	await until((text) => /1 of \d+|1\/\d+/.test(text));
	await tap_button('n next');
	await until((text) => /2 of \d+|2\/\d+/.test(text));
	await tap_button('n next');
	await until((text) => /3 of \d+|3\/\d+/.test(text) && text.includes('Enter: your answer') && !text.includes('computing'));
	await tap_button('Enter');
	const pad = await page.waitForFunction(() => /^1234567890/.test(document.getElementById('keys').textContent)).then(() => true, () => false);
	result('an answer has a pad of numbers', pad, await text_of('#keys'));
	for (const key of ['4', '2']) await tap_button(key);
	await shows('which enters it', (text) => /your answer +42/.test(text));
	await page.evaluate(() => element('hand-now').click());
	await is_open('end-sheet');
	result('at the end the keys are gone', await page.$eval('#keys', (keys) => getComputedStyle(keys).visibility === 'hidden'));
	await page.evaluate(() => localStorage.clear());
}

async function files_of_any_kind() {
	await open(one);
	await until(has('Space pause'));
	const drop = (name, text) => page.evaluate((name, text) => {
		const dropped = new DataTransfer();
		dropped.items.add(new File([text], name));
		document.dispatchEvent(new DragEvent('drop', {dataTransfer: dropped, bubbles: true, cancelable: true}));
	}, name, text);
	await drop('OWN.INI', '[scenario]\ntitle = In capitals\nproblem = bar\nmethod = mpm\n');
	await shows('a name in capitals is opened', has('In capitals'));
	await drop('own.txt', '[scenario]\ntitle = As a text\nproblem = bar\nmethod = mpm\n');
	await shows('and a text that holds a scenario', has('As a text'));
	await drop('OWN.LESSON', '@title A lesson of a teacher\n@about Own.\n\n@page One\n@do open mode5\nRead this.\n');
	await shows('a lesson is opened', has('Read this.'));
	await page.evaluate(() => open_one({scenario: 'mode5', sets: ['time.end=1e4']}));
	await until(has('Space pause'));
	fs.writeFileSync(path.join(scratch, 'sheet.script'), 'key Space\nkey f\n');
	spawnSync(process.env.MATVIB, ['mode1', '--script', 'sheet.script', '--record', 'own.session', '--force'], {cwd: scratch});
	await drop('Own.Session', fs.readFileSync(path.join(scratch, 'own.session'), 'utf8'));
	await shows('and a session is done again', has('Where mesh and bar agree'));
	await paste('@title A lesson that was copied\n@about Own.\n\n@page One\n@do open mode5\nRead that.\n');
	await shows('a lesson is opened by pasting it', has('Read that.'));
	await paste(fs.readFileSync(path.join(scratch, 'own.session'), 'utf8'));
	await shows('and so is a session', has('Where mesh and bar agree'));
	await paste('t,x\n0,0\n1,2\n');
	await becomes('and a table', notice_of, (text) => /^pasted\.csv is drawn over the curves/.test(text));
	await page.evaluate(() => {
		written.set('a.csv', encoder.encode('x,y\n1,2\n'));
		written.set('ä.svg', encoder.encode('<svg/>'));
		show_files();
		window.save = (name, bytes) => { window.saved = [name, ...new Uint8Array(bytes)]; };
		element('files').click();
		element('save-all').click();
	});
	const zip = path.join(scratch, 'all.zip'), [archive, ...bytes] = await sooner(() => page.evaluate(() => window.saved), Boolean);
	result('its name', archive === 'matvib-files.zip', archive);
	fs.writeFileSync(zip, Buffer.from(bytes));
	const listed = spawnSync('python3', ['-c', 'import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); print(z.testzip(), z.namelist(), z.read("a.csv"))', zip], {encoding: 'utf8'});
	result('all files are saved in one archive', listed.stdout.trim() === "None ['a.csv', 'ä.svg'] b'x,y\\n1,2\\n'", listed.stdout + listed.stderr);
}

// the page without a terminal, for who has it read aloud
async function plain_words() {
	await open(one + '?plain=1');
	const told = () => page.$eval('#told', (list) => list.textContent).catch(() => '');
	const tells = async (name, what) => {
		const found = await sooner(told, (text) => what.test(text));
		result(name, what.test(found), found);
	};
	const enter = async (line) => { await page.focus('#line'); await type(line + '\r'); };
	await tells('plain words tell what there is', /matvib in plain words/);
	result('with no terminal, and the field waits', await page.evaluate(() => document.getElementById('screen').hidden && document.activeElement.id === 'line'));
	await shot('plain');
	await enter(']');
	await tells('a line is a key', /stage 1 of 7 is done/);
	await enter('initial.mode=3');
	await tells('or a command', /\(initial\.mode\): 3/);
	await enter('until t 1');
	await tells('a run goes on to where it was told', /t 1\.0\d*, step/);
	await enter(':export words');
	result('a file is offered there too', (await written('words-series.csv')) !== null, await told());
	await enter('mesh.cell_size=0.002');
	await enter('until end');
	await page.waitForFunction(() => /> until end/.test(element('told').textContent) && plain.rest !== '> ').catch(() => {});
	const stopped = await sooner(() => page.click('#stop').then(told), (text) => /> until end.*step \d+ of \d+, paused/.test(text));
	result('a long computation is stopped', /> until end.*step \d+ of \d+, paused/.test(stopped), stopped);
	await page.click('#stop', {clickCount: 2});
	await page.evaluate(() => worker.postMessage({interrupt: true}));
	await enter('tell number');
	await tells('who stops twice does not end the program', /> tell number./);
	await page.waitForFunction(() => document.activeElement.id === 'line').catch(() => {});
	await page.keyboard.press('ArrowUp');
	await becomes('lines come back', () => page.$eval('#line', (field) => field.value), (line) => line === 'tell number');
	result('the link says so', /[?&]plain=1/.test(await page.evaluate(() => link_to_opened())));
	await page.click('#words');
	await shows('and the screen comes back', has('Space pause'));
}

// output waits for a terminal that stands still, and no key is lost
async function slow_terminal() {
	await open(endless);
	await until(has('Space pause'));
	await page.evaluate(() => {
		const write = term.write.bind(term), held = [];
		term.write = (bytes, done) => { held.push([bytes, done]); };
		window.held_back = () => held.reduce((sum, [bytes]) => sum + bytes.length, 0);
		window.release = () => {
			term.write = write;
			for (const [bytes, done] of held) write(bytes, done);
			return held_back();
		};
	});
	for (let i = 0; i < 60; i++) {
		const before = await page.evaluate(() => held_back());
		await page.keyboard.press('f'); // a whole screen each, until there is no room
		await page.waitForFunction((before) => held_back() > before, {timeout: 100}, before).catch(() => {});
	}
	await type(':mesh.cell_size=0.5\r');
	await page.waitForFunction(() => held_back() > 1000).catch(() => {});
	let [before, now] = [0, 1];
	while (now !== before && now < 131072) { // until it stands still
		before = now;
		now = await page.evaluate(() => new Promise((done) => { setTimeout(() => done(held_back()), 1000); }));
	}
	const bytes = await page.evaluate(() => release());
	result('a terminal that stands still is sent no more than it has room for', bytes > 1000 && bytes < 131072, `${bytes} bytes`);
	await shows('and no key is lost', (text) => /cell size +0\.5/.test(text));
	if (engine !== engines.Chromium) return;
	await open(endless);
	await until(has('Space pause'));
	await page.emulateCPUThrottling(6);
	await page.keyboard.press(' ');
	note(`a page six times as slow answers a key in ${await shows('a slow page answers', has('Space run'))} ms`);
	await page.emulateCPUThrottling(null);
}

async function computing() {
	await open(one + '?scenario=branching&sheet=full&set=time.end:1e-3'); // longer than anybody waits
	await shows('a plate of the papers\' size opens', (text) => has('Space')(text) && /spacing +0\.00025/.test(text));
	await halt();
	await type(':goto #20000\r');
	await until(has('stop here'));
	await page.keyboard.press('Escape');
	const time = await shows('Esc stops a long computation', (text) => !/stop here/.test(text));
	note(`Esc is answered in ${time} ms`);
}

const bad = '<img src=x onerror="document.title=1"><script>document.title=2</script>';
// nothing from outside became a part of the page, and it still answers
async function unharmed() {
	const found = await page.evaluate(() => ({
		title: document.title, made: document.querySelectorAll('img, iframe, object, main script, section script, dialog script, header script').length,
		ended: document.getElementById('end-sheet').open, said: document.getElementById('end-text').textContent + document.getElementById('notice').textContent,
	}));
	return / - matvib$/.test(found.title) && found.made === 0 ? found : null;
}

async function hostile_links() {
	const harmless = async (link) => {
		await open(one + link);
		const {time, text} = await look_for((text) => /Space (pause|again)/.test(text)); // a run may be over by then
		result(`a link with ${link.slice(0, 40)} does no harm`, (await unharmed()) && time < Infinity, text);
	};
	for (const link of ['?scenario=' + encodeURIComponent(bad), '?lesson=' + encodeURIComponent('../../etc/passwd'),
		'?scenario=mode5&set=' + encodeURIComponent('bar.length=1\x1b[2J') + '&set=--record', '?plain=' + encodeURIComponent(bad) + '&set=' + encodeURIComponent(bad) + '#' + bad]) await harmless(link);
	await open(one + '?scenario=mode5&set=no.such:1&set=mesh.cell_size:0.5');
	await shows('of a link with a parameter that is none the rest is opened', (text) => has('Space pause')(text) && /cell size +0\.5/.test(text));
	result('and which part is told', /Of the link this could not be used: no\.such: unknown key/.test(await notice_of()), await notice_of());
	await open(one + '?scenario=mode99&colour=red&set=abc');
	await until(has('Space pause'));
	result('what a link cannot ask for is told by its parts', /there is no scenario "mode99"/.test(await notice_of()) && /"colour" is unknown/.test(await notice_of()) &&
		/"set=abc" is not KEY:VALUE/.test(await notice_of()), await notice_of());
	for (const name of [bad, '--force', '\x1b[2J\n\r\0' + 'A'.repeat(500)]) {
		await open(one + '?lesson=homework-late&name=' + encodeURIComponent(name) + '&id=' + encodeURIComponent(name));
		const {text} = await look_for((text) => /1 of \d+|1\/\d+/.test(text));
		const found = await unharmed();
		result(`the name ${JSON.stringify(name.slice(0, 20))} does no harm`, found && !found.ended && /1 of \d+|1\/\d+/.test(text), text + found.said);
	}
	for (const link of ['?scenario=mode5&set=' + 'x'.repeat(900000), '?scenario=mode5' + '&set=mesh.cell_size=0.5'.repeat(20000)]) await harmless(link);
}

async function hostile_files() {
	const random = Buffer.alloc(1 << 20), control = Buffer.alloc(1 << 20);
	for (let i = 0, x = 1; i < random.length; i++) {
		x = x * 48271 % 2147483647;
		random[i] = x >> 8;
		control[i] = x % 33 === 32 ? 10 : x % 33;
	}
	const contents = {random, control, 'one-line': Buffer.alloc(1 << 20, 'x'), html: Buffer.from(bad.repeat(10000))};
	await open(one + '?scenario=mode5');
	for (const kind of ['ini', 'lesson', 'session', 'csv'])
		for (const [name, bytes] of Object.entries(contents)) {
			if (await page.$eval('#end-sheet', (sheet) => sheet.open)) await page.click('#again'); // the one before has ended the program
			await until((text) => has('Space')(text) || text.split('\n').pop().startsWith(' :')); // or is told in the line that asked for it
			const file = path.join(scratch, `${name}${name === 'html' ? '<img src=x onerror=alert()>' : ''}.${kind}`);
			fs.writeFileSync(file, bytes);
			await (await page.$('#bring')).uploadFile(file);
			const refused = new RegExp(`${name}\\S*\\.${kind}:(\\d+:)? `);
			await becomes(`a ${kind} of ${name} is refused in a line`, async () => {
				const found = await unharmed();
				return found && found.said + (await screen()).split('\n').slice(-6).join('\n');
			}, (said) => said && refused.test(said));
		}
	await open(one + '?scenario=mode5');
	await until(has('Space pause'));
	fs.writeFileSync(path.join(scratch, 'large.csv'), Buffer.alloc(21e6, '1,2\n'));
	await (await page.$('#bring')).uploadFile(path.join(scratch, 'large.csv'));
	await becomes('one of 21 MB is not taken in', notice_of, (text) => /large\.csv is too large/.test(text));
	await open(one + '?plain=1');
	fs.writeFileSync(path.join(scratch, 'own.ini'), `[scenario]\ntitle = ${bad}\nproblem = bar\nmethod = mpm\n`);
	await page.waitForFunction(() => /paused/.test(document.getElementById('told').textContent)).catch(() => {});
	await (await page.$('#bring')).uploadFile(path.join(scratch, 'own.ini'));
	await page.waitForFunction(() => /onerror/.test(document.getElementById('told').textContent)).catch(() => {});
	result('a title of HTML is text', (await unharmed()) && /<img/.test(await page.$eval('#told', (list) => list.textContent)));
}

async function hostile_storage() {
	await open(one);
	await page.evaluate((bad) => {
		localStorage.setItem('matvib/work/' + bad + '.session', bad);
		localStorage.setItem('matvib/work/mode5', '[scenario]\ntitle = not ours\nproblem = bar\nmethod = mpm\n');
		localStorage.setItem('matvib/work/large.session', 'x'.repeat(1500000));
		localStorage.setItem('matvib/state/' + bad, '\x1b[2J'.repeat(10000));
		localStorage.setItem('another page', bad);
		indexedDB.open('matvib', 7);
	}, bad);
	await open(one + '?scenario=mode5');
	await until(has('Space pause'));
	result('what another page left in the storage becomes no part of this one', (await unharmed()) && has('Why is mode 5 late')(await screen()), await screen());
	await page.evaluate(() => {
		document.getElementById('forget').click();
		document.querySelector('#forget-sheet [value=forget]').click();
	});
	await becomes('and "forget me" leaves what is not ours', () => page.evaluate(() => Object.keys(localStorage).filter((key) => key !== 'matvib/tab').join()), (keys) => keys === 'another page');
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
}


// a browser that keeps nothing, because it is full or because it is told to keep nothing
async function failing_storage() {
	const wrongs = {
		QuotaExceededError: () => { Storage.prototype.setItem = () => { throw new DOMException('', 'QuotaExceededError'); }; },
		SecurityError: () => { Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('', 'SecurityError'); }}); },
	};
	for (const [name, wrong] of Object.entries(wrongs)) {
		await open(one + '?lesson=homework-late&name=Ada', {}, false, wrong);
		await shows(`${name} of the storage: the homework opens`, (text) => /1 of \d+|1\/\d+/.test(text));
		await page.waitForFunction(() => !document.getElementById('notice').hidden).catch(() => {});
		result('that nothing is kept is told', (await notice_of()).includes('keeps nothing for this page (' + name + ')'), await notice_of());
		await type('nn');
		result('the session can be saved all the same', (await written('homework-late-Ada.session')) !== null && /homework of Ada/.test(await page.$eval('#whose', (span) => span.textContent)));
	}
}

// what no program should do: it dies in the middle of a homework
async function crash() {
	await open(one + '?lesson=homework-late&name=Eve');
	await until((text) => /1 of \d+|1\/\d+/.test(text));
	await type('n');
	result('a homework is under way', (await written('homework-late-Eve.session')) !== null);
	await page.evaluate(() => worker.postMessage({keys: 7}));
	await page.waitForFunction(() => document.getElementById('end-sheet').open).catch(() => {});
	result('a crash is told', /ended with an error \(134\)/.test(await page.$eval('#end-title', (title) => title.textContent)) &&
		/TypeError/.test(await page.$eval('#end-text', (text) => text.textContent)), await page.$eval('#end-text', (text) => text.textContent));
	result('what was recorded is offered', /homework-late-Eve\.session/.test(await page.$eval('#end-files', (list) => list.textContent)));
	result('but not to be handed in, for it has no end', !/teacher/.test(await text_of('#end-files')) && (await text_of('#again')) === 'go on with it');
	await page.click('#again');
	await shows('and it goes on', (text) => /2 of \d+|2\/\d+/.test(text));
	await page.evaluate(() => { program = new ArrayBuffer(8); open_one({scenario: 'mode1'}); });
	await page.waitForFunction(() => document.getElementById('end-sheet').open).catch(() => {});
	result('a program that is none is told too', /\(134\)/.test(await page.$eval('#end-title', (title) => title.textContent)), await screen());
	await page.evaluate(() => localStorage.clear());
}

async function end_of_the_program() {
	await open(one + '?scenario=mode5');
	await until(has('Space pause'));
	await type('q');
	await page.waitForFunction(() => document.getElementById('end-sheet').open).catch(() => {});
	result('the end of the program offers to begin again', await page.$eval('#end-sheet', (sheet) => sheet.open), await screen());
	const told = await page.evaluate(() => {
		show_end('', 'building: 11 %\r\x1b[K\x1b[Kmatvib: a line\r\n');
		return element('end-text').textContent;
	});
	result('what it said is told without its progress', told === 'matvib: a line\n', JSON.stringify(told));
	await page.click('#again');
	await shows('which does', has('Space pause'));
}

// what a browser of ten years ago has not
async function without_webassembly() {
	await open(one, {}, false, () => { delete window.WebAssembly; });
	await page.waitForFunction(() => !document.getElementById('notice').hidden).catch(() => {});
	result('a browser without WebAssembly is told so in a sentence', /^This browser is too old for this page: it has no WebAssembly\./.test(await notice_of()), await notice_of());
}

// The page's own policy: its scripts, by their hashes or from its folder, and nothing from elsewhere.
async function policy() {
	const read = (...parts) => fs.readFileSync(path.join(built, ...parts), 'utf8');
	const told = (text) => /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(text)[1].replace(/ +;/g, ';');
	const of = (script, style, more) => `default-src 'none'; script-src ${script} 'wasm-unsafe-eval'; style-src 'unsafe-inline'${style}; font-src data:; img-src data:;` +
		` ${more}; base-uri 'none'; form-action 'none'`;
	const all = read('matvib.html'), scripts = [...all.matchAll(/<script>([^]*?)<\/script>/g)].map(([, text]) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`);
	result('the policy of the one file', told(all) === of(scripts.join(' '), '', 'worker-src blob:'), told(all));
	result('the policy of the folder', told(read('web', 'index.html')) === of("'self'", " 'self'", "connect-src 'self'; worker-src 'self'"), told(read('web', 'index.html')));
	const outside = /(?:src|href)\s*=\s*["']?(?:https?:)?\/\/[^"'\s>]*|url\(\s*["']?(?!data:)[^)]*|@import[^;]*/;
	const names = ['matvib.html', ...fs.readdirSync(path.join(built, 'web')).filter((name) => /\.(html|css|js)$/.test(name)).map((name) => path.join('web', name))];
	const found = names.map((name) => outside.exec(read(name))).filter(Boolean);
	result('nothing names what would be loaded from elsewhere', names.length > 10 && found.length === 0, found.join('\n'));
	const packed = zlib.gzipSync(all, {level: 9}).length;
	result('the one file has at most 1.5 MB as a server packs it', packed <= 1.5e6, packed);
	asked.length = 0;
	await open(one);
	await until(has('Space pause'));
	await page.evaluate(async (elsewhere) => {
		window.refused = new Set();
		document.addEventListener('securitypolicyviolation', ({effectiveDirective}) => window.refused.add(effectiveDirective.replace(/-elem$/, '')));
		const add = (kind, parts) => document.body.append(Object.assign(document.createElement(kind), parts));
		add('img', {src: elsewhere + 'x.png'});
		add('iframe', {src: elsewhere + 'x.html'});
		add('link', {rel: 'stylesheet', href: elsewhere + 'x.css'});
		add('script', {textContent: 'document.title = "harmed"'});
		add('script', {src: elsewhere + 'x.js'});
		await fetch(elsewhere + 'x').catch(() => {});
	}, served);
	await becomes('the browser refuses what the policy does not allow', () => page.evaluate(() => [...window.refused].sort().join(' ')),
		(refused) => refused === 'connect-src frame-src img-src script-src style-src');
	result('and asks for none of it', asked.length === 0 && !/harmed/.test(await page.title()), asked.join(' '));
}

async function from_a_server() {
	await open(served + 'index.html?scenario=mode1');
	await shows('the folder works on a server without headers of its own', has('Space pause'));
	await page.evaluate(() => navigator.serviceWorker.ready);
	await page.reload();
	await until(has('Space pause'));
	away = true;
	await page.reload().catch(() => {});
	await shows('and without the server, once it was there', has('Space pause'));
	away = false;
	await page.evaluate(async () => { for (const one of await navigator.serviceWorker.getRegistrations()) await one.unregister(); });
	let go_on;
	held = new Promise((done) => { go_on = done; });
	await open(served + 'index.html?scenario=mode1');
	await becomes('while the program comes the page says how far it is', () => text_of('#loading-text'), (text) => /^Loading the program: ([3-6]\d) %$/.test(text));
	go_on();
	await shows('and opens when it is there', has('Space pause'));
	result('without that line', await page.$eval('#loading', (line) => line.hidden));
	held = null;
	await open(served + 'strict.html');
	await page.waitForFunction(() => !document.getElementById('notice').hidden).catch(() => {});
	result('a server whose policy forbids WebAssembly is named as the reason', /^The policy of this server .* forbids WebAssembly/.test(await notice_of()), await notice_of());
}

async function serve() {
	const types = {'.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm', '.css': 'text/css'};
	const server = http.createServer((request, answer) => {
		asked.push(request.url);
		const name = path.basename(new URL(request.url, 'http://x').pathname), where = name === 'matvib.html' ? path.join(built, name) : path.join(built, 'web', name);
		if (name === 'frame.html')
			return answer.writeHead(200, {'content-type': 'text/html'}).end('<iframe src="matvib.html" sandbox="allow-scripts" width="900" height="600"></iframe>');
		if (away) return request.socket.destroy();
		if (name === 'strict.html')
			return answer.writeHead(200, {'content-type': 'text/html', 'content-security-policy': "script-src 'self'"}).end(fs.readFileSync(path.join(built, 'web', 'index.html')));
		if (!fs.existsSync(where)) return answer.writeHead(404).end();
		const bytes = fs.readFileSync(where), half = Math.floor(bytes.length / 2);
		answer.writeHead(200, {'content-type': types[path.extname(name)] || 'application/octet-stream'});
		if (!held || name !== 'matvib.wasm') return answer.end(bytes);
		answer.write(bytes.subarray(0, half));
		held.then(() => answer.end(bytes.subarray(half)));
	}).listen(0, '127.0.0.1');
	await new Promise((done) => server.on('listening', done));
	served = `http://127.0.0.1:${server.address().port}/`;
	return server;
}

const cases = {homework_is_kept, lines, first_picture, first_picture_of_a_slow_machine, keys_and_size, edit_and_stages, export_of_a_run, dropped_scenario,
	dropped_series, homework, address, browser_keys, sandboxed, files_of_any_kind, plain_words, slow_terminal, computing, hostile_files, hostile_storage,
	failing_storage, crash, end_of_the_program, without_webassembly, policy, from_a_server, hostile_links, size_of_type, selecting,
	lesson_by_taps, sheets_by_taps, cell_by_taps, telephone, keyboard_on_its_side, lesson_on_a_telephone, answer_by_taps};

// One of the processes: it is told case after case.
async function try_cases(name) {
	engine = Object.assign(engines[name], {name});
	const server = await serve();
	process.on('message', async (wanted) => {
		if (wanted) {
			const begin = Date.now();
			await cases[wanted]().catch((error) => result(wanted, false, error.stack));
			if (wanted === 'hostile_links') { // Firefox under remote control falls over its own history of such addresses
				await browser.close().catch(() => {});
				browser = context = null;
			}
			if (process.env.MATVIB_TIMES) note(`${wanted}: ${((Date.now() - begin) / 1000).toFixed(1)} s`);
			if (context) await context.close().catch(() => {});
			context = page = null;
			return process.send('next');
		}
		if (browser) await browser.close().catch(() => {});
		server.close();
		fs.rmSync(scratch, {recursive: true, force: true, maxRetries: 5});
		process.disconnect();
	});
	process.send('next');
}

const SIDE_BY_SIDE = 2; // processes of a browser

// All of them, their results numbered, each with what is told about it.
function conduct() {
	let number = 0, broken = false, running = 0;
	const print = (line) => {
		broken = broken || line.startsWith('not ok');
		console.log(line.replace(/^(not )?ok/, (begin) => begin + ' ' + ++number));
	};
	const wanted = process.argv.slice(2);
	for (const [name, {path, package: needed}] of Object.entries(engines)) {
		if (!path) {
			print(`ok - the page in ${name} # SKIP ${needed} is not installed`);
			continue;
		}
		const left = Object.keys(cases).filter((one) => wanted.length === 0 || wanted.includes(one));
		for (let i = 0; i < SIDE_BY_SIDE; i++) {
			const child = fork(__filename, [], {stdio: ['ignore', 'pipe', 'inherit', 'ipc'], env: Object.assign({}, process.env, {MATVIB_ENGINE: name})});
			let told = '', under_way = 'the start';
			running++;
			child.stdout.setEncoding('utf8').on('data', (text) => { told += text; });
			child.on('message', () => {
				told.split('\n').filter(Boolean).forEach(print);
				told = '';
				under_way = left.shift();
				child.send(under_way || null);
			});
			child.on('close', () => {
				told.split('\n').filter(Boolean).forEach(print);
				if (under_way) print(`not ok - ${name}: ${under_way} ended its process`);
				if (--running > 0) return;
				console.log(`1..${number}`);
				process.exitCode = broken ? 1 : 0;
			});
		}
	}
	if (running === 0) console.log(`1..${number}`);
}

process.env.MATVIB_ENGINE ? try_cases(process.env.MATVIB_ENGINE) : conduct();
