// SPDX-License-Identifier: GPL-3.0-or-later
// The address of the page: what a link opens, and the link to what is open.
'use strict';

const WORDS_MOST = 40;

// A link may choose what there is and set parameters, no more: no files, no other options. What it cannot do is said.
const is_builtin = (kind, name) => data[kind + 's'].some((row) => row.name === name);
const SET = /^([a-z][\w.-]{0,59})[:=]([^\x00-\x1f\x7f]{0,200})$/;

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
	if (found.lesson && (wish.has('scenario') || wish.has('set'))) wrong.push('a lesson has no scenario and no "set" beside it');
	if (found.lesson) sets.length = 0;
	if (wish.getAll('set').length > WORDS_MOST) wrong.push('more than ' + WORDS_MOST + ' parameters');
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
function show_address(same = false) {
	const here = data[opened.kind + 's'].find(({name}) => name === opened.name);
	document.title = (here ? here.title : opened.name) + ' - matvib';
	if (!is_known()) return;
	element('chooser').value = opened.kind + ' ' + opened.name;
	const wish = new URLSearchParams(location.search), sign = opened.kind + ' ' + opened.name;
	const who = ['name', 'id'].map((key) => (opened.kind === 'lesson' && wish.get('lesson') === opened.name && wish.get(key) ?
		'&' + key + '=' + encodeURIComponent(wish.get(key)) : '')).join('');
	const address = link_to_opened() + who;
	try {
		if (same || !history.state || history.state.sign === sign) history.replaceState({sign}, '', address);
		else history.pushState({sign}, '', address);
	} catch (error) {
		// a frame without an address of its own
	}
}

// What was opened and changed in the program itself; of a lesson that is the lesson's. Browsers let an address change
// a few times a second.
const FOLLOWS = 300; // milliseconds
let followed = null, following = 0; // null: what is told is the program's before this one

function follow({large, answered, name, sets}) {
	if (followed === null) return;
	enlarge(large);
	if (opened.answered !== answered) {
		opened.answered = answered;
		keep_answered();
	}
	const now = JSON.stringify([name, sets]), first = followed === '';
	if (opened.kind === 'lesson' || now === followed) return;
	followed = now;
	Object.assign(opened, {name, sets});
	clearTimeout(following);
	// what opens in its coarse form is the same one
	following = setTimeout(() => show_address(first), first ? 0 : FOLLOWS);
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

async function open_link() {
	const wish = words_of_link(location.search);
	await open_one(wish.scenario || wish.lesson ? wish : {scenario: 'mode5', sets: wish.sets, sheet: wish.sheet});
	tell_wrong(wish.wrong);
}
