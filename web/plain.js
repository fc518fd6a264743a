// SPDX-License-Identifier: GPL-3.0-or-later
// Plain words in place of the terminal.
'use strict';

const LINES_MOST = 2000;

const plain = {
	on: false,
	rest: '', // of a line that has not ended; '> ' while the program waits for one
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
		for (const line of lines) this.tell(line);
	},
	enter(line) {
		this.tell('> ' + line, 'line');
		this.rest = '';
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
			if (worker) worker.postMessage({interrupt: true});
			element('line').focus();
		});
		element('words').addEventListener('click', () => {
			this.turn(!this.on);
			open_again();
		});
	},
};
