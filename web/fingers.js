// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers: the row of keys below the program, scrolling and the size of the type by touch.
'use strict';

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

// A field is underlined where its cursor stands: in the last row it takes words, but where the row above asks for a number.
function typing() {
	const {cursorX, cursorY, viewportY} = term.buffer.active, line = term.buffer.active.getLine(viewportY + cursorY);
	if (!line || ![cursorX, cursorX - 1].some((x) => x >= 0 && line.getCell(x) && line.getCell(x).isUnderline())) return '';
	return cursorY === term.rows - 1 && !/^ a number/.test(term.buffer.active.getLine(viewportY + cursorY - 1).translateToString()) ? 'words' : 'number';
}

let offered = '', asked_for = '';
let drawn_rows = 0; // for how many the program drew what is there

// A screen of another height tells nothing of the program: by its cursor the row of keys, and so the height, would go to and fro.
function show_keys() {
	if (element('keys').hidden || drawn_rows !== term.rows) return;
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

// What a finger has selected is copied by a button: a selection of the terminal is none of the browser's.
function offer_copy() {
	const leave = () => {
		term.clearSelection();
		element('selected').hidden = true;
	};
	element('selected').replaceChildren(word_button('copy', async () => {
		try {
			await navigator.clipboard.writeText(term.getSelection());
		} catch (error) {
			term.focus();
			document.execCommand('copy');
		}
		leave();
	}), ' ', word_button('cancel', leave));
	element('selected').hidden = false;
}

// Two fingers change the type's size, one scrolls what is under it as a wheel does; held still for LONG it selects a word, and from
// there to where it goes.
const LONG = 500; // milliseconds

function listen_to_fingers(screen) {
	let apart = 0, at = 0, timer = 0, from = null, began = 0;
	const cell_at = ({clientX, clientY}) => {
		const box = term.element.querySelector('.xterm-screen').getBoundingClientRect(), place = (share, count) => Math.max(0, Math.min(count - 1, Math.floor(share * count)));
		return place((clientY - box.top) / box.height, term.rows) * term.cols + place((clientX - box.left) / box.width, term.cols);
	};
	const select = (first, last) => term.select(first % term.cols, Math.floor(first / term.cols), last - first + 1);
	const word_at = (cell) => {
		const buffer = term.buffer.active, row = Math.floor(cell / term.cols), line = buffer.getLine(buffer.viewportY + row);
		const solid = (x) => x >= 0 && x < term.cols && /\S/.test(line.getCell(x).getChars());
		let first = cell % term.cols, last = first;
		while (solid(first - 1)) first--;
		while (solid(last + 1)) last++;
		return [row * term.cols + first, row * term.cols + last];
	};
	const distance = (touches) => Math.hypot(touches[0].clientX - touches[1].clientX, touches[0].clientY - touches[1].clientY);
	screen.addEventListener('touchstart', (event) => {
		apart = event.touches.length === 2 ? distance(event.touches) : 0;
		at = event.touches[0].clientY;
		began = event.timeStamp;
		clearTimeout(timer);
		from = null;
		element('selected').hidden = true;
		const touch = event.touches[0];
		if (event.touches.length === 1)
			timer = setTimeout(() => {
				from = word_at(cell_at(touch));
				select(...from);
			}, LONG);
	}, {passive: true});
	screen.addEventListener('touchend', (event) => {
		clearTimeout(timer);
		if (!from || event.touches.length > 0) return;
		from = null;
		if (event.timeStamp - began < LONG) return term.clearSelection(); // a short touch that a busy page hears of late
		event.preventDefault(); // no click follows
		offer_copy();
	}, {passive: false});
	screen.addEventListener('contextmenu', (event) => coarse.matches && event.preventDefault());
	screen.addEventListener('touchmove', (event) => {
		event.preventDefault();
		if (from) {
			const here = cell_at(event.touches[0]);
			return select(Math.min(from[0], here), Math.max(from[1], here));
		}
		if (event.touches.length === 2 && apart > 0) {
			const now = distance(event.touches);
			if (Math.abs(now / apart - 1) < .12) return;
			type_size(now > apart ? 1 : -1);
			apart = now;
		} else if (event.touches.length === 1) {
			const {clientX, clientY} = event.touches[0], row = screen.clientHeight / term.rows;
			if (Math.abs(clientY - at) < row) return;
			clearTimeout(timer);
			term.element.querySelector('.xterm-screen').dispatchEvent(new WheelEvent('wheel', {deltaY: at > clientY ? 100 : -100, clientX, clientY, bubbles: true, cancelable: true}));
			at = clientY;
		}
	}, {passive: false});
}
