// SPDX-License-Identifier: GPL-3.0-or-later
// The host of the program in JavaScript, the same in a page's worker and in Node: a terminal as a device, sleep,
// and the files that appear. It knows nothing of the page.
'use strict';

const READABLE = 1, WRITABLE = 2, RESIZED = 4, GONE = 8, STOPPED = 16;
const AHEAD = 65536; // bytes of output that wait for the terminal before the program is refused more
const SLICE = 8;     // milliseconds without a look at what has come
const EAGAIN = 6;    // as emscripten numbers them

class Host {
	// send(bytes): to the terminal; changed(): files may have changed; crashed(error)
	constructor(send, changed, crashed) {
		this.send = send;
		this.crashed = crashed || ((error) => { throw error; });
		this.changed = changed || (() => {});
		this.rows = 24;
		this.columns = 80;
		this.draws_for = 0;   // for how many rows the program draws: those that it was last told of
		this.input = [];
		this.ended = false;   // no more input will come
		this.resized = false;
		this.gone = false;
		this.stopped = false;
		this.waits = true;    // output for the terminal; lines of words do not
		this.ahead = 0;
		this.refused = false;
		this.touched = false;
		this.wake = null;
		this.slept = 0;
		this.channel = new MessageChannel();
		this.nap = 0; // which sleep it is: one that has been ended leaves its message behind
		this.channel.port1.onmessage = ({data}) => { if (data === this.nap) this.settle(true); };
		if (this.channel.port1.unref) this.channel.port1.unref();
	}

	// What is true now, as bits.
	what(reads, writes) {
		let bits = 0;
		if (reads && (this.input.length > 0 || this.ended)) bits |= READABLE;
		if (writes && this.ahead < AHEAD) bits |= WRITABLE;
		if (this.resized) bits |= RESIZED;
		if (this.gone) bits |= GONE;
		if (this.stopped) bits |= STOPPED;
		return bits;
	}

	told(bits) {
		if (bits & RESIZED) {
			this.resized = false;
			this.draws_for = this.rows;
		}
		if (bits & GONE) this.gone = false;
		if (bits & STOPPED) this.stopped = false;
		this.refused = false;
		return bits;
	}

	// An answer at once, or -1: the program is to sleep. A program that computes sleeps now and then for a
	// moment, for only then does anything come.
	ready(milliseconds, reads, writes) {
		if (milliseconds < 0 && reads) this.stopped = false; // who waits for a line does nothing that could be stopped
		if (performance.now() - this.slept > SLICE) return -1;
		const bits = this.what(reads, writes);
		return bits !== 0 || milliseconds === 0 ? this.told(bits) : -1;
	}

	sleep(milliseconds, reads, writes, wake) {
		if (this.touched) {
			this.touched = false;
			this.changed();
		}
		const timed = milliseconds > 0;
		this.nap++;
		this.waiting = {reads, writes, wake, timer: null, lasts: milliseconds < 0 && reads};
		if (timed) this.waiting.timer = setTimeout(() => this.settle(true), milliseconds);
		if (milliseconds === 0 || this.what(reads, writes) !== 0) this.channel.port2.postMessage(this.nap);
	}

	// Wakes the program when something has come, or in any case.
	settle(always) {
		const waiting = this.waiting;
		if (!waiting) return;
		const bits = this.what(waiting.reads, waiting.writes);
		if (bits === 0 && !always) return;
		this.waiting = null;
		if (waiting.timer !== null) clearTimeout(waiting.timer);
		this.slept = performance.now();
		waiting.wake(this.told(bits));
	}

	keys(bytes) {
		for (const byte of bytes) this.input.push(byte);
		this.settle(false);
	}

	size(columns, rows) {
		if (columns === this.columns && rows === this.rows) return;
		this.columns = columns;
		this.rows = rows;
		this.resized = true;
		this.settle(false);
	}

	// So many bytes have been drawn.
	drawn(count) {
		this.ahead -= count;
		this.settle(false);
	}

	// The program has left, or crashed; the former has been told by onExit.
	over(error) {
		if (!error || error.name !== 'ExitStatus') this.crashed(error);
	}

	hang_up() {
		this.gone = true;
		this.settle(false);
	}

	// ^C of a terminal that hands over lines
	interrupt() {
		this.stopped = !(this.waiting && this.waiting.lasts);
		this.settle(false);
	}

	// The terminal in place of emscripten's; `errors` are bytes to standard error.
	install(module, errors) {
		const FS = module.FS, host = this;
		const terminal = (send) => ({
			open(stream) { stream.tty = host; stream.seekable = false; },
			close() {},
			flush() {},
			read(stream, buffer, offset, length) {
				if (host.input.length === 0) {
					if (host.ended) return 0;
					throw new FS.ErrnoError(EAGAIN);
				}
				// a line at most, as a terminal hands them over
				const some = host.input.splice(0, Math.min(length, host.input.indexOf(10) + 1 || length));
				buffer.set(some, offset);
				return some.length;
			},
			write(stream, buffer, offset, length) {
				// refused once until it waits: a program that leaves is let go
				if (send === host.send && host.ahead >= AHEAD && !host.refused) {
					host.refused = true;
					throw new FS.ErrnoError(EAGAIN);
				}
				host.ahead += send === host.send && host.waits ? length : 0;
				send(new Uint8Array(buffer.buffer, buffer.byteOffset + offset, length).slice());
				return length;
			},
		});
		[['/dev/tty', 64, this.send], ['/dev/tty1', 65, errors || this.send]].forEach(([name, major, send]) => {
			const device = FS.makedev(major, 0);
			FS.registerDevice(device, terminal(send));
			FS.unlink(name);
			FS.mkdev(name, device);
		});
		for (const name of ['write', 'close', 'rename', 'unlink']) {
			const before = FS[name];
			FS[name] = function(stream) {
				host.touched = host.touched || name !== 'write' || !stream.tty;
				return before.apply(FS, arguments);
			};
		}
	}
}

if (typeof module !== 'undefined') module.exports = {Host};
