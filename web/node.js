#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The page's program in Node: node.js FOLDER ARGUMENT...; FOLDER has matvib.js and matvib.wasm. Files that
// arguments name are handed in, and what the program writes is put here.
'use strict';
const fs = require('fs'), path = require('path');
const {Host} = require('./host.js');

const folder = process.argv[2], words = process.argv.slice(3);
const output = (number) => (bytes) => {
	for (let sent = 0; sent < bytes.length;) {
		try {
			sent += fs.writeSync(number, bytes, sent);
		} catch (error) {
			if (error.code !== 'EAGAIN') throw error;
		}
	}
	host.ahead = 0;
};
const host = new Host(output(1));
const given = new Map();

function hand_in(FS, name) {
	let made = '';
	for (const part of path.dirname(name).split('/').filter((part) => part && part !== '.')) {
		made += (made || path.isAbsolute(name) ? '/' : '') + part;
		if (!FS.analyzePath(made).exists) FS.mkdir(made);
	}
	if (!fs.existsSync(name) || !fs.statSync(name).isFile()) return;
	FS.writeFile(name, fs.readFileSync(name));
	given.set(name, FS.stat(name).mtime.getTime());
}

// Everything below a folder of the program's that it did not find there.
function hand_out(FS, folder, real) {
	for (const name of FS.readdir(folder)) {
		if (name === '.' || name === '..') continue;
		const from = folder + '/' + name, to = path.join(real, name), stat = FS.stat(from);
		if (FS.isDir(stat.mode)) {
			if (!fs.existsSync(to)) fs.mkdirSync(to);
			hand_out(FS, from, to);
		} else if (FS.isFile(stat.mode) && !given.has(path.relative('.', to)) && !given.has(to))
			fs.writeFileSync(to, FS.readFile(from));
	}
}

async function main() {
	host.input = process.stdin.isTTY ? [] : [...fs.readFileSync(0)];
	host.ended = true;
	const module = {
		host, arguments: words, thisProgram: 'matvib', noExitRuntime: false,
		wasmBinary: fs.readFileSync(path.join(folder, 'matvib.wasm')),
		preRun: [(module) => {
			const FS = module.FS;
			host.install(module, output(2));
			Object.assign(module.ENV, {HOME: '/home/web_user', LC_ALL: 'C.UTF-8', LANG: 'C.UTF-8'});
			for (const name of ['SOURCE_DATE_EPOCH', 'TERM', 'TERMINFO', 'MATVIB_SEED'])
				if (process.env[name]) module.ENV[name] = process.env[name];
			FS.mkdir('/here');
			FS.chdir('/here');
			for (const word of words) {
				const name = word.replace(/^--[a-z-]+=/, '');
				if (name && name.length < 4096 && !/^-/.test(name)) hand_in(FS, name);
			}
		}],
		onExit: (status) => {
			hand_out(module.FS, '/here', '.');
			process.exit(status);
		},
	};
	await require(path.join(path.resolve(folder), 'matvib.js'))(module);
}

main().catch((error) => {
	process.stderr.write('matvib: ' + (error && error.stack || error) + '\n');
	process.exit(134);
});
