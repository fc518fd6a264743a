// SPDX-License-Identifier: GPL-3.0-or-later
// The program: the first of the page's scripts, so that it is unpacked and compiled while the others are read and the terminal is made.
'use strict';

const element = (id) => document.getElementById(id);
const data = JSON.parse(element('data').textContent);
let spare = null; // the worker that has compiled the program, for its first start

function worker_address() {
	const inlined = element('worker');
	if (!inlined) return 'worker.js';
	if (!worker_address.made)
		worker_address.made = URL.createObjectURL(new Blob([inlined.textContent], {type: 'text/javascript'}));
	return worker_address.made;
}

// Compiled once, for every start. From a server it is while it comes, and kept by the browser, where it is named as what it is.
async function load_program() {
	const pieces = Array.from(document.getElementsByClassName('program'), (piece) => piece.textContent);
	if (pieces.length === 0) {
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
	return new Promise((done, fail) => {
		spare = new Worker(worker_address());
		spare.onmessage = ({data}) => (data.program ? done(data.program) : fail(new Error(data.text)));
		spare.onerror = (event) => fail(new Error(event.message || 'its worker could not be begun'));
		spare.postMessage({unpack: new Blob(pieces)}); // not copied once more, as texts are
	});
}

function loading(share) {
	element('loading').hidden = share >= 2;
	element('loading-share').value = Math.min(1, share);
	element('loading-text').textContent = 'Loading the program: ' + Math.round(100 * Math.min(1, share)) + ' %';
}

loading(0);
const program_comes = load_program();
program_comes.catch(() => {}); // is told where it is waited for
