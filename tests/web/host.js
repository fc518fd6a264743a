// SPDX-License-Identifier: GPL-3.0-or-later
// When the page's host wakes a program that sleeps: node tests/web/host.js web/host.js; status 1 where it is wrong.
const {Host} = require(require('path').resolve(process.argv[2]));
const READABLE = 1, STOPPED = 16;
const turn = () => new Promise((done) => setTimeout(done, 20));
const say = (sound, name) => {
	if (sound) return;
	console.error(`not so: ${name}`);
	process.exitCode = 1;
};

(async () => {
	let woken;
	const wake = (bits) => { woken = bits; };
	const asleep = (host, milliseconds) => { woken = null; host.sleep(milliseconds, true, false, wake); };

	let host = new Host(() => {});
	host.ended = true;
	asleep(host, -1);       // leaves a message: there is something to read
	host.ended = false;
	host.keys([65]);
	say(woken === READABLE, 'a key wakes who waits for one');
	host.input.length = 0;
	asleep(host, -1);
	await turn();
	say(woken === null, 'the message of a sleep that a key has ended does not wake the next one');
	host.keys([66]);
	say(woken === READABLE, 'but the next key does');

	host = new Host(() => {});
	asleep(host, -1);
	host.interrupt();
	host.keys([65]);
	say(woken === READABLE, 'a stop while a line is waited for stops nothing');
	host.input.length = 0;
	asleep(host, 10000);
	host.interrupt();
	say(woken === STOPPED, 'a stop ends the wait of who works');
	host.interrupt();
	say(host.ready(-1, true, false) === -1 && !host.stopped, 'a stop that came too late is forgotten before the next line');
	host.interrupt();
	host.slept = performance.now();
	say(host.ready(0, false, false) === STOPPED, 'and is told to who asks while working');
})();
