// SPDX-License-Identifier: GPL-3.0-or-later
// The page around the terminal: what is opened, keys for fingers, files in and out, what is kept. Every text from
// outside, a link's, a file's or the program's, becomes text of an element and never HTML.
'use strict';

const BYTES_MOST = 20e6, KEPT_MOST = 2e6, WORDS_MOST = 40, LINES_MOST = 2000;
const BEAT = 2000; // milliseconds: how often a tab says that it keeps a homework
const element = (id) => document.getElementById(id);
const notice = (text, ...parts) => {
	element('notice').replaceChildren(text, ...parts);
	element('notice').hidden = text === '';
};

// --- what is kept in the browser ---------------------------------------------------------------
// Files as latin-1 strings by 'matvib/work/NAME' (sessions; 'matvib/when/NAME': their time) and 'matvib/state/NAME', of a student
// 'matvib/state:STUDENT/NAME': what one has reached is not the next one's. 'matvib/tab' is who keeps a homework.
const state_kind = () => 'state' + (opened.whose ? ':' + opened.whose : '');
const store = {
	sound: true,
	key: (kind, name) => 'matvib/' + kind + '/' + name,
	trouble(why) {
		if (this.sound) notice('This browser keeps nothing for this page (' + why + '): save your files before you leave.');
		this.sound = false;
	},
	write(kind, name, bytes) {
		if (bytes.length > KEPT_MOST) return this.trouble(name + ' is too large');
		let text = '';
		for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
		try {
			localStorage.setItem(this.key(kind, name), text);
		} catch (error) {
			this.trouble(error.name);
		}
	},
	remove(kind, name) {
		try {
			localStorage.removeItem(this.key(kind, name));
		} catch (error) {
			this.trouble(error.name);
		}
	},
	text(kind, name) {
		try {
			return localStorage.getItem(this.key(kind, name)) || '';
		} catch (error) {
			return '';
		}
	},
	all(kind) {
		const files = [];
		try {
			for (let i = 0; i < localStorage.length; i++) {
				const key = localStorage.key(i), begin = this.key(kind, '');
				if (!key.startsWith(begin)) continue;
				const name = clean(key.slice(begin.length)), text = localStorage.getItem(key);
				if (name !== key.slice(begin.length) || (kind === 'work' && !name.endsWith('.session'))) continue;
				if (name && text.length <= KEPT_MOST && !/[^\0-\xff]/.test(text))
					files.push({name, bytes: Uint8Array.from(text, (letter) => letter.charCodeAt(0))});
			}
		} catch (error) {
			this.trouble(error.name);
		}
		return files;
	},
	forget() {
		try {
			for (const key of Object.keys(localStorage)) if (key.startsWith('matvib/')) localStorage.removeItem(key);
		} catch (error) {
			this.trouble(error.name);
		}
	},
};

// A name for a file in the program's folder; '': none is left of it. Letters of every script stay, composed as the program has them.
function clean(name) {
	return name.normalize('NFC').replace(/^.*[/\\]/, '').replace(/[^\p{L}\p{M}\p{N}._-]/gu, '_').replace(/^[.-]+/, '').slice(0, 100);
}

// One tab at a time keeps a homework. The mark is a tab's own while its time is young.
const tab = {
	own: String(Math.random()).slice(2),
	timer: 0,
	take() {
		try {
			const [who, when] = (localStorage.getItem('matvib/tab') || '').split(' ');
			if (who && who !== this.own && Date.now() - Number(when) < 3 * BEAT && Number(when) <= Date.now()) return false;
			const beat = () => localStorage.setItem('matvib/tab', this.own + ' ' + Date.now());
			beat();
			clearInterval(this.timer);
			this.timer = setInterval(beat, BEAT);
		} catch (error) {
			store.trouble(error.name);
		}
		return true;
	},
	leave() {
		clearInterval(this.timer);
		try {
			if ((localStorage.getItem('matvib/tab') || '').startsWith(this.own)) localStorage.removeItem('matvib/tab');
		} catch (error) {
			store.trouble(error.name);
		}
	},
};
// A page that is hidden may never be seen again: what has been written is asked for before.
for (const [target, name] of [[window, 'pagehide'], [document, 'freeze'], [document, 'visibilitychange']])
	target.addEventListener(name, () => {
		if (worker) worker.postMessage({look: true});
		if (name === 'pagehide') tab.leave();
	});

// --- what is to be opened ----------------------------------------------------------------------
const data = JSON.parse(element('data').textContent);

// A link may choose what there is and set parameters, no more: no files, no other options. What it cannot do is said.
const is_builtin = (kind, name) => data[kind + 's'].some((row) => row.name === name);
const SET = /^([a-z0-9_.]{1,60})[:=]([^\x00-\x1f\x7f]{0,200})$/;
function words_of_link(search) {
	const wish = new URLSearchParams(search.slice(0, 20000)), sets = [], wrong = [];
	const plainly = (text) => text.replace(/[\x00-\x1f\x7f]/g, '').slice(0, 60);
	const text = (name) => plainly(wish.get(name) || '');
	const found = {sets, wrong, lesson: null, scenario: null, name: text('name'), id: text('id'), plain: wish.get('plain') === '1',
		sheet: ['plain', 'full'].includes(wish.get('sheet')) ? wish.get('sheet') : ''};
	for (const set of wish.getAll('set').slice(0, WORDS_MOST)) {
		const parts = SET.exec(set);
		parts ? sets.push(parts[1] + '=' + parts[2]) : wrong.push('"set=' + plainly(set) + '" is not KEY:VALUE');
	}
	for (const kind of ['lesson', 'scenario']) {
		const name = wish.get(kind);
		if (name && is_builtin(kind, name)) found[kind] = name;
		else if (name) wrong.push('there is no ' + kind + ' "' + plainly(name) + '"');
	}
	for (const key of new Set(wish.keys()))
		if (!['lesson', 'scenario', 'set', 'name', 'id', 'plain', 'sheet'].includes(key)) wrong.push('"' + plainly(key) + '" is unknown');
	return found;
}
function tell_wrong(wrong) {
	if (wrong.length > 0) notice('Of the link this could not be used: ' + wrong.slice(0, 5).join('; ') + '.');
}

const opened = {kind: 'scenario', name: 'mode5', sets: [], sheet: '', whose: ''};

const is_known = () => is_builtin(opened.kind, opened.name);

function link_to_opened() {
	const parts = [opened.kind + '=' + encodeURIComponent(opened.name)];
	for (const set of opened.sets) parts.push('set=' + encodeURIComponent(set.replace('=', ':')).replace(/%3A/g, ':').replace(/%2C/g, ','));
	if (opened.sheet) parts.push('sheet=' + opened.sheet);
	if (plain.on) parts.push('plain=1');
	return location.href.replace(/[?#].*$/, '') + '?' + parts.join('&');
}

// The address is what a reload opens; a name and an ID stay in it. Where a frame allows none of this the link button still does.
function show_address() {
	const here = data[opened.kind + 's'].find(({name}) => name === opened.name);
	document.title = (here ? here.title : opened.name) + ' - matvib';
	if (!is_known()) return;
	const wish = new URLSearchParams(location.search), sign = opened.kind + ' ' + opened.name;
	const who = ['name', 'id'].map((key) => (opened.kind === 'lesson' && wish.get('lesson') === opened.name && wish.get(key) ?
		'&' + key + '=' + encodeURIComponent(wish.get(key)) : '')).join('');
	const address = link_to_opened() + who;
	try {
		if (!history.state || history.state.sign === sign) history.replaceState({sign}, '', address);
		else history.pushState({sign}, '', address);
	} catch (error) {
		// a frame without an address of its own
	}
}

function fill_chooser() {
	const chooser = element('chooser');
	for (const [label, kind] of [['lessons', 'lesson'], ['scenarios', 'scenario']]) {
		const group = document.createElement('optgroup');
		group.label = label;
		for (const {name, title} of data[label]) {
			const option = document.createElement('option');
			option.value = kind + ' ' + name;
			option.textContent = name + ': ' + title;
			group.append(option);
		}
		chooser.append(group);
	}
	chooser.addEventListener('change', () => {
		const [kind, name] = chooser.value.split(' ');
		open_one({[kind]: name, sets: [], name: '', id: ''});
	});
}

// --- the terminal ------------------------------------------------------------------------------
const dark = matchMedia('(prefers-color-scheme: dark)');
const coarse = matchMedia('(pointer: coarse)');
const themes = {
	light: {background: '#ffffff', foreground: '#1b1f23', cursor: '#1b1f23', selectionBackground: '#b6d6ff'},
	dark: {background: '#101418', foreground: '#d8dee4', cursor: '#d8dee4', selectionBackground: '#39506b'},
};
const look = () => (dark.matches ? 'dark' : 'light');
const encoder = new TextEncoder();
const term = new Terminal({
	fontFamily: '"Cascadia Mono", monospace', fontSize: innerWidth < 600 ? 12 : 15, lineHeight: 1,
	theme: themes[look()], scrollback: 0, cursorBlink: false, allowProposedApi: true,
});
const fit = new FitAddon.FitAddon();
let worker = null, program = null;
let answers = false; // the program has said something, and takes keys

function send(bytes) {
	if (worker) worker.postMessage({keys: bytes});
}
const press = (text) => send(encoder.encode(text));

function resize() {
	if (plain.on) return;
	fit.fit();
	if (worker) worker.postMessage({size: [term.cols, term.rows]});
}

// --- lines as lines -----------------------------------------------------------------------------------
// What the program describes finer than cells (canvas_vector() in src/picture/canvas.h) is drawn on a canvas over the terminal: in cells that
// hold its dots or blocks, which are hidden there but stay to be selected, searched and read aloud. Cells with words stay free.
const FRAME = 2; // STYLE_FRAME
const COSTLY = 4, DRAWINGS = 40; // milliseconds a picture, on the mean of so many
const vectors = {
	on: true, areas: [], colours: [], asked: false, cost: 0, drawn: 0, canvas: null,
	take(text) {
		const [colours, ...commands] = text.split(';');
		this.colours = colours.slice(1).split(',').map(Number);
		this.areas = [];
		for (const command of commands) {
			const [head, ...points] = command.split(' '), numbers = head.slice(1).split(',').map(Number), area = this.areas[this.areas.length - 1];
			if (head[0] === 'A') this.areas.push({rect: numbers, strokes: [], map: null});
			else if (!area) continue;
			else if (head[0] === 'M') area.map = {columns: numbers[0], rows: numbers[1], styles: points[0] || ''};
			else area.strokes.push({kind: head[0], style: numbers[0], line: numbers[1], rank: numbers[2], points: points.map((point) => (point === '-' ? null : point.split(',').map((value) => value / 16)))});
		}
		for (const area of this.areas) area.strokes.sort((a, b) => a.rank - b.rank);
		this.ask();
		return true;
	},
	ask() {
		if (this.asked) return;
		this.asked = true;
		requestAnimationFrame(() => { this.asked = false; this.draw(); });
	},
	turn(on) {
		this.on = on;
		element('lines').setAttribute('aria-pressed', String(on));
		this.cost = this.drawn = 0;
		this.draw();
	},
	// of the 256 numbers of a terminal
	colour(style) {
		const number = this.colours[style];
		if (!(number >= 16)) return number >= 0 && number < 8 ? ['#000000', '#cd3131', '#0dbc79', '#e5e510', '#2472c8', '#bc3fbc', '#11a8cd', '#e5e5e5'][number] : term.options.theme.foreground;
		if (number >= 232) return 'rgb(' + Array(3).fill(8 + 10 * (number - 232)) + ')';
		return 'rgb(' + [36, 6, 1].map((part) => { const step = Math.floor((number - 16) / part) % 6; return step && 55 + 40 * step; }) + ')';
	},
	draw() {
		const screen = term.element && term.element.querySelector('.xterm-screen');
		if (!screen) return;
		if (!this.canvas) {
			this.canvas = document.createElement('canvas');
			this.canvas.id = 'vectors';
			this.canvas.setAttribute('aria-hidden', 'true');
			screen.append(this.canvas);
		}
		const begin = performance.now(), canvas = this.canvas, fine = devicePixelRatio || 1, pen = canvas.getContext('2d');
		const width = screen.clientWidth, height = screen.clientHeight;
		if (canvas.width !== Math.round(width * fine) || canvas.height !== Math.round(height * fine)) {
			canvas.width = Math.round(width * fine);
			canvas.height = Math.round(height * fine);
			Object.assign(canvas.style, {width: width + 'px', height: height + 'px'});
		}
		pen.clearRect(0, 0, canvas.width, canvas.height);
		if (!this.on || term.hasSelection()) return;
		const across = canvas.width / term.cols, down = canvas.height / term.rows;
		for (const area of this.areas) this.draw_area(pen, area, across, down);
		this.cost += performance.now() - begin;
		if (++this.drawn < DRAWINGS) return;
		if (this.cost / this.drawn > COSTLY) {
			this.turn(false);
			notice('Lines are drawn as characters: as lines a picture takes more than ' + COSTLY + ' ms here (F9 has them again).');
		}
		this.cost = this.drawn = 0;
	},
	// cells that something is drawn in or beside: a sample in a legend is not one of them
	crossed({strokes, map}, columns, rows) {
		const found = new Uint8Array(columns * rows);
		const mark = (x, y, reach) => {
			for (let j = Math.max(0, Math.floor(y) - reach); j <= Math.min(rows - 1, Math.floor(y) + reach); j++)
				for (let i = Math.max(0, Math.floor(x) - reach); i <= Math.min(columns - 1, Math.floor(x) + reach); i++) found[j * columns + i] = 1;
		};
		for (const {kind, points} of strokes) {
			if (kind === 'B') return found.fill(1);
			points.forEach((point, i) => {
				const before = kind === 'L' && points[i - 1], steps = before && point ? Math.min(1000, Math.ceil(2 * Math.hypot(point[0] - before[0], point[1] - before[1]))) : 0;
				for (let k = 0; k < steps; k++) mark(before[0] + (point[0] - before[0]) * k / steps, before[1] + (point[1] - before[1]) * k / steps, 1);
				if (point) mark(point[0], point[1], 1);
			});
		}
		if (!map) return found;
		const pixels = this.image(map).getContext('2d').getImageData(0, 0, map.columns, map.rows).data, across = map.columns / columns, down = map.rows / rows;
		for (let i = 0; i < map.columns * map.rows; i++)
			if (pixels[4 * i + 3] > 0) found[Math.floor(Math.floor(i / map.columns) / down) * columns + Math.floor(i % map.columns / across)] = 1;
		return found;
	},
	// cells of the area: 1 those with dots or blocks, 2 blank ones beside them, into which a line may lean
	free(left, top, columns, rows, crossed, rules) {
		const buffer = term.buffer.active, found = new Uint8Array(columns * rows), blank = new Uint8Array(columns * rows);
		for (let y = 0; y < rows; y++) {
			const line = buffer.getLine(buffer.viewportY + top + y);
			for (let x = 0; line && x < columns; x++) {
				const cell = line.getCell(left + x), code = cell ? cell.getCode() : -1;
				found[y * columns + x] = crossed[y * columns + x] && ((code >= 0x2800 && code < 0x2900) || (code >= 0x2580 && code <= 0x2593));
				if (code === 0x2500) rules.add(y); // a line across, which curves have broken
				blank[y * columns + x] = code === 0 || code === 32;
			}
		}
		const near = (x, y) => x >= 0 && y >= 0 && x < columns && y < rows && found[y * columns + x] === 1;
		for (let y = 0; y < rows; y++)
			for (let x = 0; x < columns; x++)
				if (blank[y * columns + x] && (near(x - 1, y) || near(x + 1, y) || near(x, y - 1) || near(x, y + 1))) found[y * columns + x] = 2;
		return found;
	},
	draw_area(pen, area, across, down) {
		const {rect: [left, top, columns, rows], strokes, map} = area;
		if (strokes.length === 0 && !map) return;
		area.crossed = area.crossed || this.crossed(area, columns, rows);
		const rules = new Set(), free = this.free(left, top, columns, rows, area.crossed, rules), edge = (place, cell) => Math.round(place * cell);
		pen.save();
		pen.beginPath();
		for (let y = 0; y < rows; y++)
			for (let x = 0, from = -1; x <= columns; x++) {
				const inside = x < columns && free[y * columns + x];
				if (inside && from < 0) from = x;
				if (!inside && from >= 0) {
					const x0 = edge(left + from, across), y0 = edge(top + y, down);
					pen.rect(x0, y0, edge(left + x, across) - x0, edge(top + y + 1, down) - y0);
					from = -1;
				}
			}
		pen.clip();
		pen.fillStyle = term.options.theme.background;
		pen.fillRect(edge(left, across), edge(top, down), Math.ceil(columns * across) + 1, Math.ceil(rows * down) + 1);
		if (map) this.draw_map(pen, map, edge(left, across), edge(top, down), edge(left + columns, across), edge(top + rows, down));
		const thin = Math.max(1.2, across / 7);
		pen.fillStyle = this.colour(FRAME);
		for (const y of rules) pen.fillRect(edge(left, across), edge(top + y + .5, down), columns * across, Math.max(1, Math.round(thin / 2)));
		for (const stroke of strokes) {
			pen.strokeStyle = pen.fillStyle = this.colour(stroke.style);
			pen.lineWidth = stroke.rank >= 4 ? 1.5 * thin : thin;
			pen.lineJoin = 'round';
			pen.setLineDash([[], [pen.lineWidth, 2.5 * pen.lineWidth], [6 * thin, 4 * thin]][stroke.kind === 'L' ? stroke.line : 0] || []);
			const place = ([x, y]) => [(left + x) * across, (top + y) * down];
			pen.beginPath();
			let begun = false;
			if (stroke.kind === 'B') {
				const pairs = stroke.points.filter(Boolean).map(place);
				[...pairs.filter((_, i) => i % 2 === 0), ...pairs.filter((_, i) => i % 2 === 1).reverse()].forEach((point, i) => (i ? pen.lineTo(...point) : pen.moveTo(...point)));
				pen.globalAlpha = [.85, .6, .4, .25][stroke.line & 3];
				pen.fill();
				pen.globalAlpha = 1;
				continue;
			}
			for (const point of stroke.points) {
				if (!point) begun = false;
				else if (stroke.kind === 'D') {
					const [x, y] = place(point);
					pen.moveTo(x + 1.4 * thin, y);
					pen.arc(x, y, 1.4 * thin, 0, 7);
				} else if (begun) pen.lineTo(...place(point));
				else pen.moveTo(...place(point)), begun = true;
			}
			stroke.kind === 'D' ? pen.fill() : pen.stroke();
		}
		pen.restore();
	},
	draw_map(pen, map, x0, y0, x1, y1) {
		pen.imageSmoothingEnabled = false;
		pen.drawImage(this.image(map), x0, y0, x1 - x0, y1 - y0);
	},
	image(map) {
		if (!map.image) {
			const {columns, rows} = map, image = new ImageData(columns, rows), probe = document.createElement('canvas').getContext('2d');
			const inks = {};
			let at = 0;
			for (const [, letter, times] of map.styles.matchAll(/([@-e.])(\d*)/g))
				for (let i = Number(times) || 1; i > 0 && at < columns * rows; i--, at++) {
					if (letter === '.') continue;
					if (!(letter in inks)) {
						probe.fillStyle = this.colour(letter.charCodeAt(0) - 64);
						inks[letter] = parseInt(probe.fillStyle.slice(1), 16);
					}
					const colour = inks[letter];
					image.data.set([colour >> 16, colour >> 8 & 255, colour & 255, 255], 4 * at);
				}
			map.image = Object.assign(document.createElement('canvas'), {width: columns, height: rows});
			map.image.getContext('2d').putImageData(image, 0, 0);
		}
		return map.image;
	},
};

// --- plain words in place of the terminal -----------------------------------------------------------
const plain = {
	on: false,
	rest: '', // of a line that has not ended
	waits: false, // for a line
	decoder: null,
	lines: [], // that were entered
	at: 0,     // which of them is in the field
	turn(on) {
		this.on = on;
		element('words').setAttribute('aria-pressed', String(on));
		element('plain').hidden = !on;
		element('screen').hidden = on;
		show_fingers();
	},
	begin() {
		this.rest = '';
		this.waits = false;
		this.decoder = new TextDecoder();
		element('told').replaceChildren();
	},
	tell(text, kind = '') {
		const told = element('told'), line = document.createElement('div');
		line.className = kind;
		line.textContent = text;
		told.append(line);
		while (told.childElementCount > LINES_MOST) told.firstChild.remove();
		told.scrollTop = told.scrollHeight;
	},
	take(bytes) {
		const lines = (this.rest + this.decoder.decode(bytes, {stream: true})).split('\n');
		this.rest = lines.pop();
		this.waits = this.rest === '> ';
		for (const line of lines) this.tell(line);
	},
	enter(line) {
		this.tell('> ' + line, 'line');
		this.rest = '';
		this.waits = false;
		if (line && line !== this.lines[this.lines.length - 1]) this.lines.push(line);
		this.at = this.lines.length;
		press(line + '\n');
	},
	recall(step) {
		this.at = Math.max(0, Math.min(this.lines.length, this.at + step));
		element('line').value = this.lines[this.at] || '';
	},
	listen() {
		// not a form's submission, which a frame may forbid
		const enter = () => {
			this.enter(element('line').value.replace(/[\x00-\x1f\x7f]/g, ' '));
			element('line').value = '';
		};
		element('enter').addEventListener('click', enter);
		element('line').addEventListener('keydown', (event) => {
			if (event.key === 'Enter' && !event.isComposing) enter();
			const step = {ArrowUp: -1, ArrowDown: 1}[event.key];
			if (!step) return;
			event.preventDefault();
			this.recall(step);
		});
		element('stop').addEventListener('click', () => {
			if (worker && !this.waits) worker.postMessage({interrupt: true});
			element('line').focus();
		});
		element('words').addEventListener('click', () => {
			this.turn(!this.on);
			open_again();
		});
	},
};

// --- the key line, for fingers -------------------------------------------------------------------
const keys = {
	Space: ' ', Tab: '\t', Enter: '\r', Esc: '\x1b', PgUp: '\x1b[5~', PgDn: '\x1b[6~', Home: '\x1bOH', End: '\x1bOF',
	Del: '\x1b[3~', Back: '\x7f', '←': '\x1bOD', '→': '\x1bOC', '↑': '\x1bOA', '↓': '\x1bOB', '<-': '\x1bOD', '->': '\x1bOC', '^C': '\x03',
};
const bytes_of = (key) => keys[key] || (/^[!-~]$/.test(key) ? key : /^\^[A-Z]$/.test(key) ? String.fromCharCode(key.charCodeAt(1) - 64) : null);

// What the last row offers: [{keys: ['←', '→'], word, from, to}], columns from 0. A tap on the row itself is the program's,
// which knows the mouse.
function offers() {
	const buffer = term.buffer.active, line = buffer.getLine(buffer.viewportY + term.rows - 1);
	if (!line) return [];
	const found = [], text = line.translateToString(true);
	for (const part of text.matchAll(/\S+(?: \S+)*/g)) {
		const words = part[0].split(' '), some = [];
		while (words.length > 1 && bytes_of(words[0]) && some.length < 2) some.push(words.shift());
		if (some.length === 0 || words.length === 0) continue;
		found.push({keys: some, word: words.join(' '), from: part.index, to: part.index + part[0].length});
	}
	return found;
}

function key_button(label, text) {
	const button = document.createElement('button');
	button.type = 'button';
	button.textContent = label;
	// the terminal keeps the focus, so that a keyboard stays as it is
	button.addEventListener('pointerdown', (event) => event.preventDefault());
	button.addEventListener('click', () => press(text));
	return button;
}

function show_fingers() {
	element('keys').hidden = !coarse.matches || plain.on;
	element('keyboard').hidden = element('keys').hidden;
	set_keyboard(!coarse.matches);
	offered = '';
	show_keys();
}

// A field is underlined where its cursor stands: in the last row it takes words, else a number.
function typing() {
	const {cursorX, cursorY, viewportY} = term.buffer.active, line = term.buffer.active.getLine(viewportY + cursorY);
	if (!line || ![cursorX, cursorX - 1].some((x) => x >= 0 && line.getCell(x) && line.getCell(x).isUnderline())) return '';
	return cursorY === term.rows - 1 ? 'words' : 'number';
}

let offered = '', asked_for = '';
function show_keys() {
	if (element('keys').hidden) return;
	const field = typing(), lesson = opened.kind === 'lesson', now = field ? [] : offers(), sign = JSON.stringify([field, lesson, now]);
	if (sign === offered) return;
	offered = sign;
	const buttons = [], shown = new Set();
	const add = (key, label) => {
		if (shown.has(key)) return;
		shown.add(key);
		buttons.push(key_button(label, bytes_of(key)));
	};
	// what else the row has would be typed into the field
	if (field === 'number') for (const key of ['1', '2', '3', '4', '5', '6', '7', '8', '9', '0', '.', '-', '/', 'e']) add(key, key);
	if (field) for (const [key, label] of [['Back', '⌫'], ['Enter', 'Enter'], ['Esc', 'Esc'], ['←', '←'], ['→', '→'], ['↑', '↑'], ['↓', '↓'], ['Tab', 'Tab']]) add(key, label);
	if (field !== asked_for) {
		if (field === 'words' || asked_for === 'words') set_keyboard(field === 'words');
		if (field === 'words') term.focus();
		asked_for = field;
	}
	element('keys').classList.toggle('pad', field === 'number');
	if (field) return element('keys').replaceChildren(...buttons);
	if (lesson) {
		add('n', 'n next');
		add('b', 'b back');
	}
	for (const {keys: some, word} of now) for (const key of some) add(key, key + ' ' + word);
	for (const key of ['←', '→', '↑', '↓', 'Enter', 'Esc', 'Tab', 'Space', '?']) add(key, key);
	add('f', 'f sheet');
	element('keys').replaceChildren(...buttons);
}

// --- files ---------------------------------------------------------------------------------------
const written = new Map(); // name: bytes

// What a session says of itself: whether it has its end, whose it is and of which lesson.
function about_session(name) {
	const text = new TextDecoder().decode(written.get(name)), line = (word) => (new RegExp('^' + word + ' (.*)$', 'm').exec(text) || [, ''])[1];
	return {name, whole: /\nend .*\ncheck [0-9a-f]+\n$/.test(text), student: line('student'), id: line('id'), lesson: line('lesson')};
}
const sessions = () => [...written.keys()].filter((name) => name.endsWith('.session')).map(about_session);
function time_of(name) {
	const when = new Date(Number(store.text('when', name)));
	if (!(when > 0)) return '';
	const clock = when.toTimeString().slice(0, 5);
	return ' (' + (Date.now() - when < 20 * 3600e3 ? clock : when.toLocaleDateString() + ' ' + clock) + ')';
}
const go_on_words = ({name, student}) => 'go on with ' + (student ? student + "'s" : name) + time_of(name);

function word_button(label, act) {
	const button = document.createElement('button');
	button.type = 'button';
	button.textContent = label;
	button.addEventListener('click', act);
	return button;
}

// What a session lacks that was cut off, its end, it gets by being done again, and then it goes on.
function go_on(name) {
	if (!tab.take()) return notice('Another tab of this browser keeps a homework: close it first.');
	const base = name.replace(/(-go\d+)?\.session$/, '');
	let number = 1;
	while (written.has(base + '-go' + number + '.session')) number++;
	const {student, lesson} = about_session(name);
	Object.assign(opened, {kind: 'lesson', name: lesson, whose: student, sets: [], recording: base + '-go' + number + '.session', instead_of: name});
	begin(['--replay', name, '--fast', '--record', opened.recording]);
	show_address();
}

// A frame without an origin may forbid what the page asks for, and does not say so.
const boxed = self.origin === 'null' && location.protocol !== 'file:';
function save(name, bytes) {
	const anchor = document.createElement('a');
	anchor.href = URL.createObjectURL(new Blob([bytes], {type: 'application/octet-stream'}));
	anchor.download = name.replace(/\//g, '_');
	anchor.click();
	setTimeout(() => URL.revokeObjectURL(anchor.href), 60000);
	if (boxed) notice(name + ': where nothing was saved, this frame allows no downloads; open the page in a tab of its own.');
}
const save_button = (name, label) => word_button(label, () => save(name, written.get(name)));
// The system's own sheet, where it takes such a file: some take text alone.
function share_button(name) {
	for (const as of [name, name + '.txt']) {
		const files = [new File([written.get(name)], as, {type: 'text/plain'})];
		if (navigator.canShare && navigator.canShare({files})) return [word_button('share it', () => navigator.share({files}).catch(() => {}))];
	}
	return [];
}
function hand_in_row(name) {
	const done = document.createElement('span');
	return [word_button('save the file for your teacher: ' + name, () => {
		save(name, written.get(name));
		done.textContent = ' ' + name + ' is where this browser puts downloads: send that file to your teacher, by the course page or by mail.';
	}), ...share_button(name), done];
}

// All files in one archive, uncompressed: local headers and contents, then the directory (PKWARE's APPNOTE, 4.3).
function archive(files) {
	const table = Array.from({length: 256}, (_, n) => { for (let k = 0; k < 8; k++) n = n & 1 ? 0xedb88320 ^ n >>> 1 : n >>> 1; return n; });
	const parts = [], directory = [];
	let at = 0;
	const words = (...pairs) => {
		const bytes = [];
		for (const [size, value] of pairs) for (let i = 0; i < size; i++) bytes.push(value >>> 8 * i & 255);
		return Uint8Array.from(bytes);
	};
	for (const [path, bytes] of files) {
		const name = encoder.encode(path);
		let sum = -1;
		for (const byte of bytes) sum = table[(sum ^ byte) & 255] ^ sum >>> 8;
		const shared = [[2, 20], [2, 0x800], [2, 0], [2, 0], [2, 0x21], [4, ~sum], [4, bytes.length], [4, bytes.length], [2, name.length], [2, 0]];
		parts.push(words([4, 0x04034b50], ...shared), name, bytes);
		directory.push(words([4, 0x02014b50], [2, 20], ...shared, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]), name);
		at += 30 + name.length + bytes.length;
	}
	const size = directory.reduce((sum, part) => sum + part.length, 0), count = directory.length / 2;
	return new Blob([...parts, ...directory, words([4, 0x06054b50], [4, 0], [2, count], [2, count], [4, size], [4, at], [2, 0])]);
}
// What stands there already is left alone, for a finger may be on it: a homework is written with every key.
const stands = {};
function put(place, sign, parts) {
	if (stands[place] === sign) return;
	stands[place] = sign;
	element(place).replaceChildren(...parts());
}
function list_files(list, only) {
	const names = [...written.keys()].filter((name) => !only || only(name));
	put(list, JSON.stringify(names.map((name) => [name, written.get(name).length])), () => names.map((name) => {
		const item = document.createElement('li');
		if (/^homework.*\.session$/.test(name) && about_session(name).whole) item.append(...hand_in_row(name));
		else item.append(save_button(name, 'save ' + name), ' ' + written.get(name).length + ' bytes');
		return item;
	}));
}

function show_files() {
	const count = written.size;
	element('files').textContent = count > 0 ? 'files (' + count + ')' : 'files';
	element('save-all').hidden = count < 2;
	list_files('written');
	// what was written last is saved by one tap; the scenario beside a table lies under "files"
	const latest = [...written.keys()].filter((name) => !/\.session$|\.\w+\.ini$/.test(name)).pop();
	put('latest', String(latest), () => (latest ? [save_button(latest, 'save ' + latest)] : []));
	show_whose();
}

// Whose homework it is stays in sight; what was cut off is gone on with before it can be handed in.
function show_whose() {
	const all = sessions(), name = opened.recording || (all.length > 0 && all[all.length - 1].name);
	const last = all.find((session) => session.name === name), runs = Boolean(worker);
	const hers = !runs ? [] : opened.whose ? ['homework of ' + opened.whose + ' '] : opened.looks ? ['only looking: nothing is kept '] : [];
	put('whose', JSON.stringify([hers, runs, opened.recording, last && [last.name, last.whole], all.length, opened.looks]), () => {
		if (!last || (runs && opened.looks)) return hers;
		if (runs && opened.whose && !last.whole) return [...hers, word_button('hand in', () => element('hand-sheet').showModal())];
		const cut = all.filter((session) => !session.whole);
		if (last.whole) return [...hers, 'kept here: ', word_button('hand in ' + last.name, () => show_end('This homework is whole.', ''))];
		if (cut.length > 1) return [...hers, word_button('homework kept here (' + cut.length + ')', () => ask_go_on(''))];
		return [...hers, 'kept here: ', word_button(go_on_words(last), () => go_on(last.name))];
	});
}

function take_file({file, kept, bytes}) {
	if (kept && file === 'sheet') { // in the address, and no further: the next one has it as it is
		opened.sheet = new TextDecoder().decode(bytes).trim();
		return show_address();
	}
	if (kept) return store.write(state_kind(), file, bytes);
	written.delete(file); // the latest stands last
	written.set(file, bytes);
	if (file.endsWith('.session')) {
		store.write('work', file, bytes);
		store.write('when', file, encoder.encode(String(Date.now())));
		// the program has chosen its name
		if (opened.whose && !opened.recording) opened.recording = file;
	}
	const before = written.get(opened.instead_of);
	if (file === opened.recording && before && bytes.length >= before.length) {
		written.delete(opened.instead_of);
		store.remove('work', opened.instead_of);
		store.remove('when', opened.instead_of);
	}
	show_files();
}

// Which kind a file is: by the end of its name, of a text by what it holds.
function kind_of(name, bytes) {
	const end = /\.(ini|lesson|session|csv|txt)$/i.exec(name);
	if (!end) return null;
	const kind = end[1].toLowerCase();
	if (kind !== 'txt') return kind;
	const text = new TextDecoder().decode(bytes.subarray(0, 4000));
	return /^\[scenario\]/m.test(text) ? 'ini' : /^# matvib session/.test(text) ? 'session' : /^@page/m.test(text) ? 'lesson' : 'csv';
}

async function bring(files) {
	for (const file of files) {
		const given = clean(file.name);
		if (!given || !kind_of(given, new Uint8Array())) {
			notice('A scenario (.ini), lesson (.lesson), session (.session) or series (.csv, .txt) can be opened, not ' + file.name.slice(0, 80) + '.');
			continue;
		}
		if (file.size > BYTES_MOST) {
			notice(given + ' is too large (at most ' + BYTES_MOST / 1e6 + ' MB).');
			continue;
		}
		notice('');
		const bytes = new Uint8Array(await file.arrayBuffer()), kind = kind_of(given, bytes);
		const name = given.replace(/\.\w+$/, '.' + kind); // as the program knows its kind
		if (kind === 'lesson') open_one({given: {name, bytes}, words: ['lesson', name], solve: /^@solve/m.test(new TextDecoder().decode(bytes))});
		else if (kind === 'session') open_one({given: {name, bytes}, words: ['--replay', name]});
		else if (!worker) notice('Begin first; then ' + name + ' can be opened.');
		else {
			const fresh = !answers;
			while (worker && !answers) await new Promise((done) => setTimeout(done, 50));
			if (!worker) return;
			worker.postMessage({put: {name, bytes}});
			const enter = async (line, open) => {
				// out of whatever is being typed; on the screen time makes it a key of its own
				if (open) {
					press(plain.on ? 'Esc\n' : '\x1b');
					await new Promise((done) => setTimeout(done, 200));
				}
				plain.on ? plain.enter(line) : press(line + '\r');
			};
			await enter((kind === 'csv' ? ':overlay ' : ':open ') + name, !fresh);
			if (kind === 'csv') notice(name + ' is drawn over the curves. ', word_button('which code made its numbers?', () => {
				notice('');
				enter(':diagnose ' + name, true);
				focus_program();
			}));
		}
		focus_program();
	}
}

// What is pasted: files, or the text of one; anything else is typed.
function pasted(event) {
	const clip = event.clipboardData;
	if (!clip || element('plain').contains(event.target) || event.target.closest('dialog')) return;
	const text = clip.getData('text/plain');
	const name = /^\s*\[scenario\]/m.test(text) ? 'pasted.ini' : /^# matvib session/.test(text) ? 'pasted.session' : /^@page/m.test(text) ? 'pasted.lesson'
		: /^\w[\w.]*([,;\t]\w[\w.]*)+\r?\n[-+\d]/.test(text) ? 'pasted.csv' : '';
	const files = clip.files.length > 0 ? [...clip.files] : name ? [new File([text], name)] : [];
	if (files.length === 0) return;
	event.preventDefault();
	event.stopPropagation();
	bring(files);
}

// --- the program -----------------------------------------------------------------------------------
function stop() {
	if (!worker) return;
	worker.onmessage = null;
	worker.terminate();
	worker = null;
	tab.leave();
}

// What was kept is there before the program is.
function remember() {
	const work = store.all('work');
	work.sort((a, b) => Number(store.text('when', a.name)) - Number(store.text('when', b.name)));
	for (const {name, bytes} of work) if (!written.has(name)) written.set(name, bytes);
	return work;
}

function begin(words, {files = [], input = ''} = {}) {
	stop();
	if (plain.on && words[0] === '--replay') {
		plain.turn(false);
		notice('A session is shown on the screen: plain words take lines alone.');
	}
	term.reset();
	vectors.areas = [];
	term.options.theme = themes[look()]; // the program's colours are for one ground until it ends
	resize();
	answers = false;
	worker = new Worker(worker_address());
	worker.onmessage = ({data}) => {
		const here = worker;
		answers = answers || Boolean(data.out);
		if (data.out && plain.on) plain.take(data.out);
		else if (data.out) term.write(data.out, () => here.postMessage({drawn: data.out.length}));
		else if (data.file) take_file(data);
		else if ('ended' in data) end(data.ended, data.text);
	};
	worker.onerror = (event) => end(134, event.message || 'the program could not be begun');
	const work = remember();
	worker.postMessage({start: {
		words: words.concat('--theme', look(), plain.on ? '--plain' : []), plain: plain.on, columns: term.cols, rows: term.rows, program,
		files: work.concat(files), state: store.all(state_kind()).concat(opened.sheet ? [{name: 'sheet', bytes: encoder.encode(opened.sheet + '\n')}] : []),
		terminal: data.terminal, input: encoder.encode(input),
	}});
	show_files();
	element('end-sheet').close();
	if (plain.on) plain.begin();
	focus_program();
}

// A frame takes the keys of the page around it only when it is asked to.
function focus_program() {
	if (window !== window.top && !document.hasFocus()) return;
	plain.on ? element('line').focus() : term.focus();
}

function show_end(title, text) {
	element('end-title').textContent = title;
	element('end-text').textContent = text.replace(/[\x00-\x08\x0b-\x1f\x7f]/g, '').slice(-1500);
	list_files('end-files', (name) => name === opened.recording || (!opened.recording && name.endsWith('.session')));
	element('again').textContent = opened.recording && !about_session(opened.recording).whole ? 'go on with it' : 'start again';
	element('end-sheet').showModal();
}

function end(status, text) {
	stop();
	// of what was refused the rest is opened: the message names the key
	const refused = status === 2 && opened.sets.length > 0 && /--set: (.*)/.exec(text);
	if (refused) {
		const key = refused[1].split(':')[0], left = opened.sets.filter((set) => !set.startsWith(key + '='));
		opened.sets = left.length < opened.sets.length ? left : [];
		open_again();
		return notice('Of the link this could not be used: ' + refused[1].slice(0, 300) + '.');
	}
	opened.sets = status === 2 ? [] : opened.sets;
	const whole = written.has(opened.recording) && about_session(opened.recording).whole;
	show_whose();
	show_end(status !== 0 && status !== 129 ? 'The program ended with an error (' + status + ').' : whole && opened.whose ? 'Your homework is ready to be handed in.' : 'The program has ended.', text);
	element('again').focus();
}

// A button of a sheet is its answer; the sheet is left without one by Esc.
function ask_by(sheet) {
	return new Promise((resolve) => {
		sheet.onclose = () => resolve(sheet.returnValue);
		sheet.returnValue = '';
		sheet.showModal();
	});
}

async function ask_whose() {
	element('name').value = element('id').value = '';
	element('name').setCustomValidity('');
	return await ask_by(element('whose-sheet')) === 'begin' ? [clean_line(element('name').value), clean_line(element('id').value)] : ['', ''];
}
const clean_line = (text) => text.replace(/[\x00-\x1f\x7f]/g, ' ').trim();

// Each homework that was cut off has a row, where a link names a student the student's; null: there is none.
async function ask_go_on(lesson, name = '', id = '') {
	const cut = sessions().filter((session) => !session.whole && (!lesson || session.lesson === lesson) && (!name || session.student === name)).reverse();
	if (cut.length === 0) return null;
	const sheet = element('kept-sheet'), pick = (label, value) => {
		const item = document.createElement('li');
		item.append(word_button(label, () => sheet.close(value)));
		return item;
	};
	const own = name || cut[0].student;
	element('kept').replaceChildren(...cut.map((session) => pick(go_on_words(session) + (lesson ? '' : ', ' + session.lesson), 'go ' + session.name)),
		...(lesson && own ? [pick('start again' + (cut.length > 1 ? ' as ' + own : ''), 'again')] : []), ...(lesson ? [pick('it was somebody else', 'other')] : []));
	const answer = await ask_by(sheet);
	if (answer.startsWith('go ')) return {go: answer.slice(3)};
	if (answer === 'again') return {name: own, id: name ? id : cut[0].id};
	return answer === 'other' ? {name: '', id: ''} : {stay: true};
}

// What a person, a link or the chooser asks for.
async function open_one({scenario, lesson, sets = [], name = '', id = '', sheet = '', words, given, solve}) {
	const about = {kind: lesson || words && words[0] === 'lesson' ? 'lesson' : 'scenario', name: lesson || scenario || (given ? given.name : 'mode5'),
		sets, sheet, whose: '', looks: false, recording: null, instead_of: null};
	offered = '';
	const options = {files: given ? [given] : []};
	let all = words || (lesson ? ['lesson', lesson] : [scenario || 'mode5'].concat(...sets.map((set) => ['--set', set])));
	if (solve || (lesson && data.lessons.some((row) => row.name === lesson && row.solve))) {
		stop();
		remember();
		const kept = lesson ? await ask_go_on(lesson, clean_line(name), id) : null;
		if (kept && kept.go) return go_on(kept.go);
		if (kept && !kept.stay) [name, id] = [kept.name, kept.id];
		if (!name && !(kept && kept.stay)) [name, id] = await ask_whose();
		if (kept && kept.stay) name = '';
		if (name && !tab.take()) {
			notice('Another tab of this browser keeps a homework: close it first. Here you only look, nothing is kept.');
			name = '';
		}
		if (name) all = all.concat('--name', name, id ? ['--id', id] : []);
		else options.input = '\n'; // to the program's own question
		about.whose = name;
		about.looks = !name;
	}
	Object.assign(opened, about);
	if (!given) element('chooser').value = opened.kind + ' ' + opened.name;
	show_address();
	begin(all, options);
}

function open_again() {
	if (opened.recording && written.has(opened.recording) && !about_session(opened.recording).whole) return go_on(opened.recording);
	open_one({[opened.kind]: is_known() ? opened.name : undefined, sets: opened.sets, sheet: opened.sheet});
}

// --- the page as a whole ---------------------------------------------------------------------------
function worker_address() {
	const inlined = element('worker');
	if (!inlined) return 'worker.js';
	if (!worker_address.made)
		worker_address.made = URL.createObjectURL(new Blob([inlined.textContent], {type: 'text/javascript'}));
	return worker_address.made;
}

// Compiled once, for every start. From a server it is while it comes, and kept by the browser, where it is named as what it is.
async function load_program() {
	const inlined = element('program');
	if (!inlined) {
		const answer = await fetch('matvib.wasm');
		if (!answer.ok) throw new Error('matvib.wasm: ' + answer.status);
		let come = 0;
		const counted = answer.body.pipeThrough(new TransformStream({transform(chunk, out) {
			loading((come += chunk.length) / data.bytes);
			out.enqueue(chunk);
		}}));
		const counting = new Response(counted, {headers: answer.headers});
		return answer.headers.get('content-type') === 'application/wasm' ? WebAssembly.compileStreaming(counting) : WebAssembly.compile(await counting.arrayBuffer());
	}
	loading(.5);
	const packed = Uint8Array.from(atob(inlined.textContent), (letter) => letter.charCodeAt(0));
	return WebAssembly.compile(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}

function loading(share) {
	element('loading').hidden = share >= 2;
	element('loading-share').value = Math.min(1, share);
	element('loading-text').textContent = 'Loading the program: ' + Math.round(100 * Math.min(1, share)) + ' %';
}

function why_not(error) {
	if (/wasm-unsafe-eval|unsafe-eval|Content.Security.Policy/i.test(error.message))
		return 'The policy of this server (Content-Security-Policy) forbids WebAssembly: it has to allow script-src \'wasm-unsafe-eval\'. Saved to a disk, the file opens all the same.';
	return 'The page could not be begun: ' + error.message;
}

function set_keyboard(on) {
	term.textarea.inputMode = on ? 'text' : 'none';
	element('keyboard').setAttribute('aria-pressed', String(on));
}

// What a browser's own keys are for stays so; Ctrl+C copies what is selected, and else does what Esc does: it never ends the program.
function is_ours(event) {
	const control = event.ctrlKey || event.metaKey;
	if (event.type !== 'keydown') return true;
	if (['F3', 'F5', 'F6', 'F9', 'F11'].includes(event.key)) return false;
	if (!control || event.altKey) return true;
	if (event.key.toLowerCase() === 'c' && !event.shiftKey) {
		if (!term.hasSelection()) press('\x1b');
		return false;
	}
	if (['+', '=', '-', '0'].includes(event.key)) {
		event.preventDefault();
		type_size(event.key === '0' ? 0 : event.key === '-' ? -1 : 1);
		return false;
	}
	return !/^[crfpslvtnw]$/i.test(event.key);
}

// Steps of the type's size; 0: as it was at first.
const sizes = {first: 0, large: 1};
function type_size(step) {
	sizes.first = sizes.first || term.options.fontSize;
	term.options.fontSize = step === 0 ? sizes.first : Math.max(6, Math.min(48, Math.round(term.options.fontSize * (step > 0 ? 1.12 : 1 / 1.12) + step * .4)));
	resize();
}

// Two fingers change the type's size, one scrolls what is under it as a wheel does.
function listen_to_fingers(screen) {
	let apart = 0, at = 0;
	const distance = (touches) => Math.hypot(touches[0].clientX - touches[1].clientX, touches[0].clientY - touches[1].clientY);
	screen.addEventListener('touchstart', (event) => {
		apart = event.touches.length === 2 ? distance(event.touches) : 0;
		at = event.touches[0].clientY;
	}, {passive: true});
	screen.addEventListener('touchmove', (event) => {
		event.preventDefault();
		if (event.touches.length === 2 && apart > 0) {
			const now = distance(event.touches);
			if (Math.abs(now / apart - 1) < .12) return;
			type_size(now > apart ? 1 : -1);
			apart = now;
		} else if (event.touches.length === 1) {
			const {clientX, clientY} = event.touches[0], row = screen.clientHeight / term.rows;
			if (Math.abs(clientY - at) < row) return;
			term.element.querySelector('.xterm-screen').dispatchEvent(new WheelEvent('wheel', {deltaY: at > clientY ? 100 : -100, clientX, clientY, bubbles: true, cancelable: true}));
			at = clientY;
		}
	}, {passive: false});
}

function listen() {
	term.onData(press);
	term.onBinary((text) => send(Uint8Array.from(text, (letter) => letter.charCodeAt(0))));
	term.onRender(() => { show_keys(); vectors.ask(); });
	term.onSelectionChange(() => vectors.ask());
	term.parser.registerOscHandler(7770, (text) => vectors.take(text));
	element('lines').addEventListener('click', () => vectors.turn(!vectors.on));
	term.attachCustomKeyEventHandler(is_ours);
	term.textarea.setAttribute('aria-label', 'the screen of matvib; F6 leaves it and comes back');
	// out of the terminal and back by one key (WCAG 2.1.2)
	addEventListener('keydown', (event) => {
		if (event.key === 'F9') vectors.turn(!vectors.on);
		if (event.key !== 'F6' || document.querySelector('dialog[open]')) return;
		event.preventDefault();
		document.activeElement === term.textarea || document.activeElement === element('line') ? element('chooser').focus() : focus_program();
	});
	element('skip').addEventListener('click', (event) => { event.preventDefault(); focus_program(); });
	addEventListener('paste', pasted, true);
	addEventListener('popstate', () => open_link());
	new ResizeObserver(resize).observe(element('screen'));
	coarse.addEventListener('change', show_fingers);
	plain.listen();
	listen_to_fingers(element('screen'));
	element('keyboard').addEventListener('click', () => {
		set_keyboard(term.textarea.inputMode === 'none');
		term.textarea.blur();
		term.focus();
	});
	element('more').addEventListener('click', () => {
		const open = document.body.classList.toggle('more');
		element('more').setAttribute('aria-expanded', String(open));
	});
	element('smaller').addEventListener('click', () => type_size(-1));
	element('larger').addEventListener('click', () => type_size(1));
	element('files').addEventListener('click', () => { list_files('written'); element('files-sheet').showModal(); });
	element('save-all').addEventListener('click', async () => save('matvib-files.zip', await archive(written).arrayBuffer()));
	element('about').addEventListener('click', () => element('about-sheet').showModal());
	// forms may be forbidden where scripts are not: buttons close their sheets themselves
	for (const button of document.querySelectorAll('dialog [value]'))
		button.addEventListener('click', () => {
			if (button.value === 'begin' && !clean_line(element('name').value)) {
				element('name').focus();
				return void (element('name-needed').hidden = false);
			}
			element('name-needed').hidden = true;
			button.closest('dialog').close(button.value);
		});
	for (const field of ['name', 'id'])
		element(field).addEventListener('keydown', (event) => { if (event.key === 'Enter') document.querySelector('#whose-sheet [value=begin]').click(); });
	for (const sheet of document.querySelectorAll('dialog')) sheet.addEventListener('close', focus_program);
	element('link').addEventListener('click', async () => {
		if (!is_known()) return notice(opened.name + ' came from a file: no link leads to it.');
		try {
			await navigator.clipboard.writeText(link_to_opened());
			notice('The link to this is on the clipboard.');
		} catch (error) {
			notice(link_to_opened());
		}
	});
	element('bring').addEventListener('change', () => {
		element('files-sheet').close();
		bring([...element('bring').files]);
		element('bring').value = ''; // the same file may come again
	});
	element('forget').addEventListener('click', async () => {
		const kept = sessions().filter((session) => !session.whole).length;
		element('forget-text').textContent = kept === 0 ? 'All that this page keeps in this browser is removed.'
			: 'All that this page keeps in this browser is removed, and with it ' + (kept === 1 ? 'a homework that is' : kept + ' homeworks that are') + ' not handed in.';
		if (await ask_by(element('forget-sheet')) !== 'forget') return;
		stop();
		store.forget();
		written.clear();
		element('files-sheet').close();
		open_one({scenario: 'mode5'});
		notice('What this page kept in this browser is removed.');
	});
	element('hand-now').addEventListener('click', () => {
		element('hand-sheet').close();
		if (worker) worker.postMessage({leave: true});
	});
	element('again').addEventListener('click', open_again);
	const screen = element('screen');
	addEventListener('dragover', (event) => { event.preventDefault(); screen.classList.add('over'); });
	addEventListener('dragleave', () => screen.classList.remove('over'));
	addEventListener('drop', (event) => {
		event.preventDefault();
		screen.classList.remove('over');
		bring(event.dataTransfer.files);
	});
}

async function open_link() {
	const wish = words_of_link(location.search);
	await open_one(wish.scenario || wish.lesson ? wish : {scenario: 'mode5', sets: wish.sets, sheet: wish.sheet});
	tell_wrong(wish.wrong);
}

async function main() {
	if (typeof WebAssembly !== 'object' || typeof DecompressionStream !== 'function')
		return give_up('This browser is too old for this page: it has no WebAssembly. A newer Firefox, Chrome, Edge or Safari has.');
	loading(0);
	element('licences').textContent = data.licences;
	fill_chooser();
	await Promise.all([document.fonts.load('15px "Cascadia Mono"', 'matvib'), document.fonts.load('15px "Cascadia Mono"', '⣿'),
		document.fonts.load('15px "Cascadia Mono"', '│')]);
	term.loadAddon(fit);
	term.open(element('screen'));
	listen();
	program = await load_program();
	loading(2);
	plain.turn(words_of_link(location.search).plain);
	await open_link();
	if ('serviceWorker' in navigator && data.served && isSecureContext) navigator.serviceWorker.register('offline.js').catch(() => {});
}

function give_up(why) {
	element('loading').hidden = true;
	notice(why);
}

main().catch((error) => give_up(why_not(error)));
