// SPDX-License-Identifier: GPL-3.0-or-later
// The service worker of the folder on a server: what the page is made of is kept, so that it opens without a network. A newer
// file comes from the network where there is one.
'use strict';
const KEPT = 'matvib-@version@', PARTS = ['./', 'index.html', 'matvib.css', @scripts@, 'worker.js', 'matvib.wasm'];
addEventListener('install', (event) => event.waitUntil(caches.open(KEPT).then((kept) => kept.addAll(PARTS.slice(1)))));
addEventListener('activate', (event) => event.waitUntil(caches.keys().then((names) =>
	Promise.all(names.filter((name) => name.startsWith('matvib-') && name !== KEPT).map((name) => caches.delete(name))))));
addEventListener('fetch', (event) => {
	const address = new URL(event.request.url), name = address.pathname.replace(/^.*\//, '') || 'index.html';
	if (address.origin !== location.origin || !PARTS.includes(name)) return;
	event.respondWith(fetch(event.request).catch(() => caches.open(KEPT).then((kept) => kept.match(name))));
});
