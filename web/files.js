// SPDX-License-Identifier: GPL-3.0-or-later
// Files in and out: saved, shared, dropped, pasted.
'use strict';

const BYTES_MOST = 20e6; // of a file that is brought in

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

// A button that is there already is left alone, for a finger may be on it: a homework is written with every key.
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
		if (opened.whose && !opened.recording) {
			opened.recording = file;
			keep_answered(); // which may have been told before
		}
	}
	const before = written.get(opened.instead_of);
	if (file === opened.recording && before && bytes.length >= before.length) {
		written.delete(opened.instead_of);
		for (const kind of ['work', 'when', 'answered']) store.remove(kind, opened.instead_of);
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
			const enter = (line, open) => {
				if (open) press(plain.on ? 'Esc\n' : '\x1b'); // out of whatever is being typed
				plain.on ? plain.enter(line) : press(line + '\r');
			};
			enter((kind === 'csv' ? ':overlay ' : ':open ') + name, !fresh);
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
