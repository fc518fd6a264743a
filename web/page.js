// SPDX-License-Identifier: GPL-3.0-or-later
// The page around the terminal: what is opened, keys for fingers, files in and out, what is kept. Every text from
// outside, a link's, a file's or the program's, becomes text of an element and never HTML.
'use strict';

const BYTES_MOST = 20e6, KEPT_MOST = 2e6, WORDS_MOST = 40, LINES_MOST = 2000;
const BEAT = 2000; // milliseconds: how often a tab says that it keeps a homework
const element = (id) => document.getElementById(id);
const notice = (text) => {
	element('notice').textContent = text;
	element('notice').hidden = text === '';
};

// --- what is kept in the browser ---------------------------------------------------------------
// Files as latin-1 strings by 'matvib/state/NAME' and 'matvib/work/NAME'; 'matvib/tab' is who keeps a homework.
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
	all(kind) {
		const files = [];
		try {
			for (let i = 0; i < localStorage.length; i++) {
				const key = localStorage.key(i), begin = this.key(kind, '');
				if (!key.startsWith(begin)) continue;
				const name = clean(key.slice(begin.length)), text = localStorage.getItem(key);
				if (kind === 'work' && !name.endsWith('.session')) continue;
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

// A name for a file in the program's folder; '': none is left of it.
function clean(name) {
	return name.replace(/^.*[/\\]/, '').replace(/[^A-Za-z0-9._-]/g, '_').replace(/^[.-]+/, '').slice(0, 100);
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
addEventListener('pagehide', () => tab.leave());

// --- what is to be opened ----------------------------------------------------------------------
const data = JSON.parse(element('data').textContent);

// A link may choose what there is and set parameters, no more: no files, no other options.
function words_of_link(search) {
	const wish = new URLSearchParams(search.slice(0, 20000)), sets = [];
	for (const set of wish.getAll('set').slice(0, WORDS_MOST))
		if (/^[a-z0-9_.]{1,60}=[^\x00-\x1f\x7f]{1,200}$/.test(set)) sets.push(set);
	const scenario = wish.get('scenario'), lesson = wish.get('lesson');
	const text = (name) => (wish.get(name) || '').replace(/[\x00-\x1f\x7f]/g, '').slice(0, 60);
	return {
		lesson: data.lessons.some(({name}) => name === lesson) ? lesson : null,
		scenario: data.scenarios.some(({name}) => name === scenario) ? scenario : null,
		sets, name: text('name'), id: text('id'), plain: wish.get('plain') === '1',
		unknown: (lesson && !data.lessons.some(({name}) => name === lesson)) ||
			(scenario && !data.scenarios.some(({name}) => name === scenario)),
	};
}

const opened = {kind: 'scenario', name: 'mode5', sets: []};

const is_known = () => data[opened.kind + 's'].some(({name}) => name === opened.name);

function link_to_opened() {
	const wish = new URLSearchParams();
	wish.set(opened.kind, opened.name);
	for (const set of opened.sets) wish.append('set', set);
	if (plain.on) wish.set('plain', '1');
	return location.href.replace(/[?#].*$/, '') + '?' + wish;
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
	fontFamily: '"Cascadia Mono", monospace', fontSize: innerWidth < 600 ? 12 : 15, lineHeight: 1.1,
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
		element('line').focus();
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
		element('line-form').addEventListener('submit', (event) => {
			event.preventDefault();
			this.enter(element('line').value.replace(/[\x00-\x1f\x7f]/g, ' '));
			element('line').value = '';
		});
		element('line').addEventListener('keydown', (event) => {
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
	Del: '\x1b[3~', '←': '\x1bOD', '→': '\x1bOC', '↑': '\x1bOA', '↓': '\x1bOB', '<-': '\x1bOD', '->': '\x1bOC', '^C': '\x03',
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

let offered = '';
function show_keys() {
	if (element('keys').hidden) return;
	const lesson = opened.kind === 'lesson', now = offers(), sign = JSON.stringify([lesson, now]);
	if (sign === offered) return;
	offered = sign;
	const buttons = [], shown = new Set();
	const add = (key, label) => {
		if (shown.has(key)) return;
		shown.add(key);
		buttons.push(key_button(label, bytes_of(key)));
	};
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

const is_whole = (bytes) => /\nend .*\ncheck [0-9a-f]+\n$/.test(new TextDecoder().decode(bytes));

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
	opened.kind = 'lesson';
	opened.recording = base + '-go' + number + '.session';
	opened.instead_of = name;
	begin(['--replay', name, '--fast', '--record', opened.recording]);
}

function save_button(name, label) {
	return word_button(label, () => {
		const anchor = document.createElement('a');
		anchor.href = URL.createObjectURL(new Blob([written.get(name)], {type: 'application/octet-stream'}));
		anchor.download = name.replace(/\//g, '_');
		anchor.click();
		setTimeout(() => URL.revokeObjectURL(anchor.href), 60000);
	});
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
		const label = /^homework.*\.session$/.test(name) ? 'hand in this file: ' : 'save ';
		item.append(save_button(name, label + name), ' ' + written.get(name).length + ' bytes');
		return item;
	}));
}

function show_files() {
	const count = written.size;
	element('files').textContent = count > 0 ? 'files (' + count + ')' : 'files';
	list_files('written');
	// what was written last is saved by one tap; the scenario beside a table lies under "files"
	const latest = [...written.keys()].filter((name) => !/\.session$|\.\w+\.ini$/.test(name)).pop();
	put('latest', String(latest), () => (latest ? [save_button(latest, 'save ' + latest)] : []));
	const name = [...written.keys()].filter((name) => name.endsWith('.session')).pop(), runs = Boolean(worker);
	const whole = name && is_whole(written.get(name));
	const hers = runs && opened.whose ? ['homework of ' + opened.whose + ' '] : [];
	put('whose', JSON.stringify([hers, runs, opened.recording, name, whole]), () => {
		if (!name) return hers;
		if (runs && (opened.whose || opened.recording) && !whole) return [...hers, word_button('hand in', () => worker.postMessage({leave: true}))];
		return [...hers, 'kept here: ', whole ? save_button(name, 'hand in ' + name) : word_button('go on with ' + name, () => go_on(name))];
	});
}

function take_file({file, kept, bytes}) {
	if (kept) return store.write('state', file, bytes);
	written.delete(file); // the latest stands last
	written.set(file, bytes);
	if (file.endsWith('.session')) store.write('work', file, bytes);
	const before = written.get(opened.instead_of);
	if (file === opened.recording && before && bytes.length >= before.length) {
		written.delete(opened.instead_of);
		store.remove('work', opened.instead_of);
	}
	show_files();
}

async function bring(files) {
	for (const file of files) {
		const name = clean(file.name);
		if (!name || !/\.(ini|lesson|session|csv)$/.test(name)) {
			notice('A scenario (.ini), lesson (.lesson), session (.session) or series (.csv) can be opened, not ' + file.name.slice(0, 80) + '.');
			continue;
		}
		if (file.size > BYTES_MOST) {
			notice(name + ' is too large (at most ' + BYTES_MOST / 1e6 + ' MB).');
			continue;
		}
		notice('');
		const bytes = new Uint8Array(await file.arrayBuffer());
		if (name.endsWith('.lesson')) open_one({given: {name, bytes}, words: ['lesson', name], solve: /^@solve/m.test(new TextDecoder().decode(bytes))});
		else if (name.endsWith('.session')) open_one({given: {name, bytes}, words: ['--replay', name]});
		else if (!worker) notice('Begin first; then ' + name + ' can be opened.');
		else {
			const fresh = !answers;
			while (worker && !answers) await new Promise((done) => setTimeout(done, 50));
			if (!worker) return;
			worker.postMessage({put: {name, bytes}});
			const series = name.endsWith('.csv'), line = (series ? ':overlay ' : ':open ') + name;
			// out of whatever is being typed; on the screen time makes it a key of its own
			if (!fresh) {
				press(plain.on ? 'Esc\n' : '\x1b');
				await new Promise((done) => setTimeout(done, 200));
			}
			plain.on ? plain.enter(line) : press(line + '\r');
			if (series) notice('Type :diagnose ' + name + ' to hear which code made its numbers.');
		}
		plain.on ? element('line').focus() : term.focus();
	}
}

// --- the program -----------------------------------------------------------------------------------
function stop() {
	if (!worker) return;
	worker.onmessage = null;
	worker.terminate();
	worker = null;
	tab.leave();
}

function begin(words, {files = [], input = ''} = {}) {
	stop();
	if (plain.on && words[0] === '--replay') {
		plain.turn(false);
		notice('A session is shown on the screen: plain words take lines alone.');
	}
	term.reset();
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
	const work = store.all('work');
	for (const {name, bytes} of work) written.set(name, bytes);
	worker.postMessage({start: {
		words: words.concat('--theme', look(), plain.on ? '--plain' : []), plain: plain.on, columns: term.cols, rows: term.rows, program,
		files: work.concat(files), state: store.all('state'), terminal: data.terminal, input: encoder.encode(input),
	}});
	show_files();
	element('end-sheet').close();
	plain.on ? plain.begin() : term.focus();
}

function end(status, text) {
	stop();
	if (status === 2) opened.sets = []; // what was refused is not tried again
	element('end-title').textContent = status === 0 || status === 129 ? 'The program has ended.' : 'The program ended with an error (' + status + ').';
	element('end-text').textContent = text.replace(/[\x00-\x08\x0b-\x1f\x7f]/g, '').slice(-1500);
	list_files('end-files', (name) => name.endsWith('.session'));
	element('end-sheet').showModal();
	element('again').focus();
}

function ask_whose() {
	return new Promise((resolve) => {
		const sheet = element('whose-sheet');
		sheet.onclose = () => resolve(sheet.returnValue === 'begin' ? [element('name').value.trim(), element('id').value.trim()] : ['', '']);
		sheet.returnValue = '';
		element('name').value = element('id').value = '';
		sheet.showModal();
	});
}

// What a person, a link or the chooser asks for.
async function open_one({scenario, lesson, sets = [], name = '', id = '', words, given, solve}) {
	opened.kind = lesson || words && words[0] === 'lesson' ? 'lesson' : 'scenario';
	opened.name = lesson || scenario || (given ? given.name : 'mode5');
	opened.sets = sets;
	opened.whose = '';
	opened.recording = opened.instead_of = null;
	offered = '';
	const options = {files: given ? [given] : []};
	let all = words || (lesson ? ['lesson', lesson] : [scenario || 'mode5'].concat(...sets.map((set) => ['--set', set])));
	if (solve || (lesson && data.lessons.some((row) => row.name === lesson && row.solve))) {
		stop();
		if (!name) [name, id] = await ask_whose();
		if (name && !tab.take()) {
			notice('Another tab of this browser keeps a homework: close it first. Here you only look, nothing is kept.');
			name = '';
		}
		if (name) all = all.concat('--name', name, id ? ['--id', id] : []);
		else options.input = '\n'; // to the program's own question
		opened.whose = name;
	}
	if (!given) element('chooser').value = opened.kind + ' ' + opened.name;
	begin(all, options);
}

function open_again() {
	open_one({[opened.kind]: is_known() ? opened.name : undefined, sets: opened.sets});
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
		return answer.headers.get('content-type') === 'application/wasm' ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
	}
	const packed = Uint8Array.from(atob(inlined.textContent), (letter) => letter.charCodeAt(0));
	return WebAssembly.compile(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}

function set_keyboard(on) {
	term.textarea.inputMode = on ? 'text' : 'none';
	element('keyboard').setAttribute('aria-pressed', String(on));
}

function listen() {
	term.onData(press);
	term.onBinary((text) => send(Uint8Array.from(text, (letter) => letter.charCodeAt(0))));
	term.onRender(() => show_keys());
	new ResizeObserver(resize).observe(element('screen'));
	coarse.addEventListener('change', show_fingers);
	plain.listen();
	element('keyboard').addEventListener('click', () => {
		set_keyboard(term.textarea.inputMode === 'none');
		term.textarea.blur();
		term.focus();
	});
	element('files').addEventListener('click', () => { list_files('written'); element('files-sheet').showModal(); });
	element('about').addEventListener('click', () => element('about-sheet').showModal());
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
	element('forget').addEventListener('click', () => {
		store.forget();
		written.clear();
		element('files-sheet').close();
		open_one({scenario: 'mode5'});
		notice('What this page kept in this browser is removed.');
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

async function main() {
	if (typeof WebAssembly !== 'object' || typeof DecompressionStream !== 'function')
		return notice('This browser is too old for this page: it has no WebAssembly. A newer Firefox, Chrome, Edge or Safari has.');
	element('licences').textContent = data.licences;
	fill_chooser();
	await Promise.all([document.fonts.load('15px "Cascadia Mono"', 'matvib'), document.fonts.load('15px "Cascadia Mono"', '⣿'),
		document.fonts.load('15px "Cascadia Mono"', '│')]);
	term.loadAddon(fit);
	term.open(element('screen'));
	listen();
	program = await load_program();
	const wish = words_of_link(location.search);
	plain.turn(wish.plain);
	if (wish.unknown) notice('The link names a scenario or lesson that this page has not: here is mode5 instead.');
	await open_one(wish.scenario || wish.lesson ? wish : {scenario: 'mode5', sets: wish.sets});
}

main().catch((error) => notice('The page could not be begun: ' + error.message));
