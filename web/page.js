// SPDX-License-Identifier: GPL-3.0-or-later
// The program in its worker, and the page as a whole: what is begun, how it ends, buttons and sheets.
'use strict';

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
	if (answers) term.reset(); // else nothing was written
	vectors.areas = [];
	term.options.theme = themes[look()]; // the program's colours are for one ground until it ends
	resize();
	answers = false;
	followed = null;
	clearTimeout(following);
	const begun = worker = spare || new Worker(worker_address());
	spare = null;
	// what the program before has still to say comes before this
	term.write('', () => { if (worker === begun) followed = ''; });
	worker.onmessage = ({data}) => {
		const here = worker;
		answers = answers || Boolean(data.out);
		if (data.out && plain.on) plain.take(data.out);
		else if (data.out)
			term.write(data.out, () => {
				drawn_rows = data.rows;
				here.postMessage({drawn: data.out.length});
			});
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

function show_end(title, text) {
	element('end-title').textContent = title;
	// the earlier texts of a line of progress are not shown
	element('end-text').textContent = text.replace(/\x1b\[[\d;]*[A-Za-z]/g, '').replace(/[^\n]*\r(?!\n)/g, '').replace(/[\x00-\x08\x0b-\x1f\x7f]/g, '').slice(-1500);
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

// What a person, a link or the chooser asks for.
async function open_one({scenario, lesson, sets = [], name = '', id = '', sheet = '', words, given, solve}) {
	const about = {kind: lesson || words && words[0] === 'lesson' ? 'lesson' : 'scenario', name: lesson || scenario || (given ? given.name : 'mode5'),
		sets, sheet, whose: '', looks: false, recording: null, instead_of: null, answered: 0};
	offered = '';
	if (!given) element('chooser').value = about.kind + ' ' + about.name;
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
	show_address();
	begin(all, options);
}

function open_again() {
	if (opened.recording && written.has(opened.recording) && !about_session(opened.recording).whole) return go_on(opened.recording);
	open_one({[opened.kind]: is_known() ? opened.name : undefined, sets: opened.sets, sheet: opened.sheet});
}

function why_not(error) {
	if (/unsafe-eval|Content.Security.Policy|CSP/i.test(error.message))
		return 'The policy of this server (Content-Security-Policy) forbids WebAssembly: it has to allow script-src \'wasm-unsafe-eval\'. Saved to a disk, the file opens all the same.';
	return 'The page could not be begun: ' + error.message;
}

function listen() {
	term.onData(press);
	term.onBinary((text) => send(Uint8Array.from(text, (letter) => letter.charCodeAt(0))));
	term.onRender(() => { show_keys(); vectors.draw(); });
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
	// a browser that lays its keyboard over the page: the page is what is left above it
	for (const name of ['resize', 'scroll'])
		visualViewport.addEventListener(name, () => {
			const {height, scale} = visualViewport;
			if (scale > 1.01) return;
			document.body.style.height = height < innerHeight - 1 ? height + 'px' : '';
			scrollTo(0, 0);
		});
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

async function main() {
	if (typeof WebAssembly !== 'object' || typeof DecompressionStream !== 'function')
		return give_up('This browser is too old for this page: it has no WebAssembly. A newer Firefox, Chrome, Edge or Safari has.');
	element('licences').textContent = data.licences;
	fill_chooser();
	await Promise.all([document.fonts.load('15px "Cascadia Mono"', 'matvib'), document.fonts.load('15px "Cascadia Mono"', '⣿'),
		document.fonts.load('15px "Cascadia Mono"', '│')]);
	term.loadAddon(fit);
	term.open(element('screen'));
	measure_letters();
	term.element.querySelector('.xterm-rows').removeAttribute('aria-hidden'); // they are read aloud where somebody asks for them
	show_fingers();
	fit_type();
	listen();
	program = await program_comes;
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
