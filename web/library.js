// SPDX-License-Identifier: GPL-3.0-or-later
// What the program asks of its host (src/base/wait_web.c, and the size of the terminal by ioctl). The host
// itself, Module.host, is web/host.js.
mergeInto(LibraryManager.library, {
	web_wait__deps: ['$Asyncify', 'exit'],
	web_wait: function(milliseconds, reads, writes) {
		// when it wakes the program comes through here once more, and is given what it was woken with
		if (Asyncify.state === Asyncify.State.Normal) {
			var what = Module.host.ready(milliseconds, reads, writes);
			if (what >= 0) return what;
			// a main() that has slept ends here: emscripten leaves its result to who asks
			Asyncify.asyncPromiseHandlers = {
				resolve: function(status) {
					try {
						_exit(status);
					} catch (error) {
						Module.host.over(error);
					}
				},
				reject: function(error) { Module.host.over(error); },
			};
		}
		return Asyncify.handleSleep(function(wake) {
			Module.host.sleep(milliseconds, reads, writes, wake);
		});
	},

	__syscall_ioctl__deps: ['$FS', '$SYSCALLS'],
	__syscall_ioctl: function(fd, op, varargs) {
		var stream = SYSCALLS.getStreamFromFD(fd);
		if (!stream.tty) return -{{{ cDefine('ENOTTY') }}};
		SYSCALLS.varargs = varargs;
		if (op === {{{ cDefine('TIOCGWINSZ') }}}) {
			var size = SYSCALLS.get();
			{{{ makeSetValue('size', 0, 'Module.host.rows', 'i16') }}};
			{{{ makeSetValue('size', 2, 'Module.host.columns', 'i16') }}};
		}
		return 0; // a page's terminal has no modes: every key comes as it is
	},
});
