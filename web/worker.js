// SPDX-License-Identifier: GPL-3.0-or-later
// The program in its worker; the page speaks to it by messages alone. host.js and matvib.js stand before this.
'use strict';

const HERE = '/here', STATE = '/home/web_user/.local/state/matvib';
const REST = 1000; // milliseconds between two looks at the files
let host = null, made = null, scanning = null, scanned = 0;
let told = ''; // the end of what was said outside of the screen
const seen = new Map();

// A file changes: at once, but not more often than REST, for a session is written with every key.
function changed() {
	if (scanning !== null) return;
	const left = scanned + REST - performance.now();
	if (left <= 0) scan();
	else scanning = setTimeout(scan, left);
}

// Files that are new or others than before go to the page.
function scan() {
	clearTimeout(scanning);
	scanning = null;
	scanned = performance.now();
	const FS = made.FS;
	const look = (folder, kept) => {
		if (!FS.analyzePath(folder).exists) return;
		// of files written together the first, to which the others belong, goes last: it is the one to be offered
		for (const name of FS.readdir(folder).reverse()) {
			if (name === '.' || name === '..') continue;
			const path = folder + '/' + name, stat = FS.stat(path);
			if (FS.isDir(stat.mode)) {
				look(path, kept);
				continue;
			}
			const now = stat.size + ':' + stat.mtime.getTime();
			if (!FS.isFile(stat.mode) || seen.get(path) === now || /(^|\/)\.[^/]*$|\.\d+-\d+\.part$/.test(path)) continue; // nor one that is still written
			seen.set(path, now);
			const bytes = FS.readFile(path);
			const short = path.slice((kept ? STATE : HERE).length + 1);
			postMessage({file: short, kept, bytes}, [bytes.buffer]);
		}
	};
	look(HERE, false);
	look(STATE, true);
}

function put(folder, files) {
	const FS = made.FS;
	for (const {name, bytes} of files) {
		FS.writeFile(folder + '/' + name, bytes);
		const stat = FS.stat(folder + '/' + name);
		seen.set(folder + '/' + name, stat.size + ':' + stat.mtime.getTime());
	}
}

function ended(status, why) {
	try {
		scan();
	} catch (error) {
		// what crashed may have left anything
	}
	postMessage({ended: status, text: why ? told + why : told});
}

function start(message) {
	host = new Host((bytes) => postMessage({out: bytes, rows: host.draws_for}, [bytes.buffer]),
		changed,
		(error) => ended(134, String(error)));
	host.columns = message.columns;
	host.rows = host.draws_for = message.rows;
	host.waits = !message.plain;
	if (message.input) host.input.push(...message.input);
	const decoder = new TextDecoder();
	const settings = {
		host, arguments: message.words, thisProgram: 'matvib',
		instantiateWasm: (imports, taken) => {
			WebAssembly.instantiate(message.program, imports).then(taken).catch((error) => ended(134, String(error)));
			return {};
		},
		print: () => {}, printErr: (text) => { told = (told + text + '\n').slice(-2000); },
		preRun: [(program) => {
			made = program;
			const FS = made.FS;
			host.install(made, (bytes) => { told = (told + decoder.decode(bytes, {stream: true})).slice(-2000); });
			Object.assign(made.ENV, {HOME: '/home/web_user', LC_ALL: 'C.UTF-8', LANG: 'C.UTF-8',
				TERM: 'matvib-256', MATVIB_VECTORS: '1', TERMINFO: message.terminal});
			FS.mkdir(HERE);
			FS.mkdirTree(STATE);
			put(HERE, message.files);
			put(STATE, message.state);
			FS.chdir(HERE);
		}],
		onExit: (status) => ended(status, ''),
		onAbort: (what) => ended(134, String(what)),
	};
	createMatvib(settings).catch((error) => ended(134, String(error)));
}

// The program as the one file holds it, compiled for every start.
const PIECE = 65536; // letters of base64, by fours
async function unpack(letters) {
	const stream = new DecompressionStream('gzip'), whole = new Response(stream.readable).arrayBuffer(), writer = stream.writable.getWriter();
	const all = await letters.text();
	for (let at = 0; at < all.length; at += PIECE) {
		const text = atob(all.slice(at, at + PIECE)), bytes = new Uint8Array(text.length);
		for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i); // many times faster than Uint8Array.from()
		writer.write(bytes);
	}
	writer.close();
	postMessage({program: await WebAssembly.compile(await whole)});
}

self.addEventListener('unhandledrejection', (event) => ended(134, String(event.reason)));
self.addEventListener('error', (event) => ended(134, String(event.message)));
onmessage = ({data}) => {
	if (data.start) start(data.start);
	else if (data.unpack) unpack(data.unpack).catch((error) => ended(134, error.message));
	else if (data.keys) host.keys(data.keys);
	else if (data.size) host.size(data.size[0], data.size[1]);
	else if (data.drawn) host.drawn(data.drawn);
	else if (data.put) put(HERE, [data.put]);
	else if (data.interrupt) host.interrupt();
	else if (data.leave) host.hang_up();
	else if (data.look && made) scan(); // the page may be taken away at any moment
};
