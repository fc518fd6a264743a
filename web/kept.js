// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept in the browser, and the homework in it: whose it is, how it goes on, how it is handed in.
'use strict';

const KEPT_MOST = 2e6; // bytes of a file
const BEAT = 2000; // milliseconds: how often a tab says that it keeps a homework

// Files as latin-1 strings: sessions by 'matvib/work/NAME' ('matvib/when/NAME': their time, 'matvib/answered/NAME': how many exercises
// have an answer), what was reached by 'matvib/state/NAME' and, of a student, 'matvib/state:STUDENT/NAME': it is not the next one's.
// 'matvib/tab' is who keeps a homework.
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

function keep_answered() {
	if (opened.recording) store.write('answered', opened.recording, encoder.encode(String(opened.answered)));
}

// A page that is hidden may never be seen again: what has been written is asked for before.
for (const [target, name] of [[window, 'pagehide'], [document, 'freeze'], [document, 'visibilitychange']])
	target.addEventListener(name, () => {
		if (worker) worker.postMessage({look: true});
		if (name === 'pagehide') tab.leave();
	});

const written = new Map(); // name: bytes

// What a session says of itself: whether it has its end, whose it is and of which lesson.
function about_session(name) {
	const text = new TextDecoder().decode(written.get(name)), line = (word) => (new RegExp('^' + word + ' (.*)$', 'm').exec(text) || [, ''])[1];
	return {name, whole: /\nend .*\ncheck [0-9a-f]+\n$/.test(text), student: line('student'), id: line('id'), lesson: line('lesson')};
}

const sessions = () => [...written.keys()].filter((name) => name.endsWith('.session')).map(about_session);

// How far it is and from when, as far as that is known.
function state_of(name) {
	const when = new Date(Number(store.text('when', name))), answered = Number(store.text('answered', name)), known = [];
	if (answered > 0) known.push(answered === 1 ? '1 answer' : answered + ' answers');
	if (when > 0) known.push((Date.now() - when < 20 * 3600e3 ? '' : when.toLocaleDateString() + ' ') + when.toTimeString().slice(0, 5));
	return known.length > 0 ? ' (' + known.join(', ') + ')' : '';
}

const go_on_words = ({name, student}) => 'go on with ' + (student ? student + "'s" : name) + state_of(name);

// What a session lacks that was cut off, its end, it gets by being done again, and then it goes on.
function go_on(name) {
	if (!tab.take()) return notice('Another tab of this browser keeps a homework: close it first.');
	const base = name.replace(/(-go\d+)?\.session$/, '');
	let number = 1;
	while (written.has(base + '-go' + number + '.session')) number++;
	const {student, lesson} = about_session(name);
	Object.assign(opened, {kind: 'lesson', name: lesson, whose: student, sets: [], recording: base + '-go' + number + '.session', instead_of: name, answered: 0});
	begin(['--replay', name, '--fast', '--record', opened.recording]);
	show_address();
}

// What was kept is there before the program is.
function remember() {
	const work = store.all('work');
	work.sort((a, b) => Number(store.text('when', a.name)) - Number(store.text('when', b.name)));
	for (const {name, bytes} of work) if (!written.has(name)) written.set(name, bytes);
	return work;
}

function hand_in_row(name) {
	const done = document.createElement('span');
	return [word_button('save the file for your teacher: ' + name, () => {
		save(name, written.get(name));
		done.textContent = ' ' + name + ' is where this browser puts downloads: send that file to your teacher, by the course page or by mail.';
	}), ...share_button(name), done];
}

// Whose homework it is stays in sight; what was cut off is gone on with before it can be handed in.
function show_whose() {
	const all = sessions(), name = opened.recording || (all.length > 0 && all[all.length - 1].name);
	const last = all.find((session) => session.name === name), runs = Boolean(worker);
	const whose = !runs ? [] : opened.whose ? ['homework of ' + opened.whose + ' '] : opened.looks ? ['only looking: nothing is kept '] : [];
	put('whose', JSON.stringify([whose, runs, opened.recording, last && [last.name, last.whole], all.length, opened.looks]), () => {
		if (!last || (runs && opened.looks)) return whose;
		if (runs && opened.whose && !last.whole) return [...whose, word_button('hand in', () => element('hand-sheet').showModal())];
		const cut = all.filter((session) => !session.whole);
		if (last.whole) return [...whose, 'kept here: ', word_button('hand in ' + last.name, () => show_end('This homework is whole.', ''))];
		if (cut.length > 1) return [...whose, word_button('homework kept here (' + cut.length + ')', async () => {
			const {go} = await ask_go_on('') || {};
			if (go) go_on(go);
		})];
		return [...whose, 'kept here: ', word_button(go_on_words(last), () => go_on(last.name))];
	});
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
