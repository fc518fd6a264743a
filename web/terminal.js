// SPDX-License-Identifier: GPL-3.0-or-later
// The terminal: its look, its size, its keys without those of the browser. Each script of the page has one subject, and what they
// share, `term` among it, is global. Text from outside, of a link, a file or the program, becomes text of an element and never HTML.
'use strict';

const notice = (text, ...parts) => {
	element('notice').replaceChildren(text, ...parts);
	element('notice').hidden = text === '';
};

const clean_line = (text) => text.replace(/[\x00-\x1f\x7f]/g, ' ').trim();

function word_button(label, act) {
	const button = document.createElement('button');
	button.type = 'button';
	button.textContent = label;
	button.addEventListener('click', act);
	return button;
}

const encoder = new TextEncoder();
const dark = matchMedia('(prefers-color-scheme: dark)');
const coarse = matchMedia('(pointer: coarse)');

const themes = {
	light: {background: '#ffffff', foreground: '#1b1f23', cursor: '#1b1f23', selectionBackground: '#b6d6ff'},
	dark: {background: '#101418', foreground: '#d8dee4', cursor: '#d8dee4', selectionBackground: '#39506b'},
};

const look = () => (dark.matches ? 'dark' : 'light');

const term = new Terminal({
	fontFamily: '"Cascadia Mono", monospace', lineHeight: 1,
	theme: themes[look()], scrollback: 0, cursorBlink: false, allowProposedApi: true,
});

const fit = new FitAddon();
let worker = null, program = null;
let answers = false; // the program has said something, and takes keys

function send(bytes) {
	if (worker) worker.postMessage({keys: bytes});
}

// Esc with a sequence that is not a key's behind it: alone the program would wait for more, and take the next key for Alt's.
const press = (text) => send(encoder.encode(text === '\x1b' ? '\x1b\x1b[u' : text));

// The size of the type: at first and when a telephone is turned (`width` changes), whether it is
// a person's own, and as it was before L.
const COLUMNS_LEAST = 56, ROWS_LEAST = 16; // with fewer columns a lesson shows its text or its plot
const ROWS_KEPT = 12; // with fewer there is no room for a question and its answer
const TYPE_LEAST = 10; // as far as one can read it on a telephone
const sizes = {width: 0, own: false, before: 0};

function fit_type() {
	sizes.width = innerWidth;
	term.options.fontSize = innerWidth < 600 ? 12 : 15;
	fit.fit();
	while ((term.cols < COLUMNS_LEAST || term.rows < ROWS_LEAST) && term.options.fontSize > TYPE_LEAST) {
		term.options.fontSize--;
		fit.fit();
	}
}

// Where a soft keyboard leaves too few rows the program keeps its size, and the row of its cursor is in sight.
function resize() {
	if (plain.on) return;
	const screen = element('screen'), room = fit.proposeDimensions();
	if (coarse.matches && innerWidth === sizes.width && room && room.rows < ROWS_KEPT && term.rows >= ROWS_KEPT) {
		screen.scrollTop = (term.buffer.active.cursorY + 1) * term.element.querySelector('.xterm-screen').clientHeight / term.rows - screen.clientHeight;
		return;
	}
	screen.scrollTop = 0;
	innerWidth === sizes.width || sizes.own || sizes.before ? fit.fit() : fit_type();
	if (worker) worker.postMessage({size: [term.cols, term.rows]});
}

// The terminal lays every new letter out to know its width, which is most of the work of a first picture: a canvas only measures it.
function measure_letters() {
	const widths = term._core?._renderService?._renderer?.value?._widthCache, pen = document.createElement('canvas').getContext('2d');
	if (!widths || !widths._measure) return;
	const known = new Map();
	// of the page's own font letters have one width, and so have lines and dots
	const like = (letters) => (/^[!-~]$/.test(letters) ? 'W' : /^[\u2500-\u257f]$/.test(letters) ? '│' : /^[\u2801-\u28ff]$/.test(letters) ? '⣿' : letters);
	widths._measure = (letters, look) => { // 1: bold, 2: slanted
		const font = (look & 2 ? 'italic ' : '') + (look & 1 ? 'bold ' : '') + term.options.fontSize + 'px ' + term.options.fontFamily, one = like(letters), key = one + font;
		if (!known.has(key)) {
			pen.font = font;
			known.set(key, pen.measureText(one).width);
		}
		return known.get(key);
	};
}

// A frame takes the keys of the page around it only when it is asked to.
function focus_program() {
	if (window !== window.top && !document.hasFocus()) return;
	plain.on ? element('line').focus() : term.focus();
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
function type_size(step) {
	sizes.own = step !== 0;
	if (!sizes.own) fit_type();
	else term.options.fontSize = Math.max(6, Math.min(48, Math.round(term.options.fontSize * (step > 0 ? 1.12 : 1 / 1.12) + step * .4)));
	resize();
}

// With L: larger by ENLARGED, as far as the usual screen of 80 by 24 has room.
const ENLARGED = 1.4;

function enlarge(large) {
	if (large === (sizes.before > 0)) return;
	const now = term.options.fontSize, room = Math.min(ENLARGED, Math.max(1, Math.min(term.cols / 80, term.rows / 24)));
	term.options.fontSize = large ? Math.floor(now * room) : sizes.before;
	sizes.before = large ? now : 0;
	resize();
}
