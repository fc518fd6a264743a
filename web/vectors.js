// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as lines. What the program describes finer than cells (canvas_vector() in src/picture/canvas.h) is drawn on a canvas over
// the terminal: in cells that hold its dots or blocks, which are hidden there but stay to be selected, searched and read aloud.
// Cells with words stay free.
'use strict';

const FRAME = 2; // STYLE_FRAME

const RULE = 0x2502, UPRIGHT = 0x7c, POINT = 0xb7, CROSS = 0x2b, DISC = 0x25cf, RING = 0x25cb, SQUARE = 0x25a0, SHAPES = [RULE, CROSS, DISC, RING, SQUARE];
const RADIUS = .42; // of a disc, in cells
const MAP_MOST = 4e6; // pixels
const COSTLY = 4, DRAWINGS = 41; // milliseconds a picture: the median of so many, for the browser may do other things during some

const vectors = {
	on: true, chosen: false, areas: [], colours: [], asked: false, costs: [], canvas: null,
	take(text) {
		const [colours, ...commands] = text.split(';');
		this.colours = colours.slice(1).split(',').map(Number);
		this.areas = [];
		const told = {large: false, answered: 0, name: '', sets: []};
		for (const command of commands) {
			const [head, ...points] = command.split(' '), numbers = head.slice(1).split(',').map(Number), area = this.areas[this.areas.length - 1];
			if (head[0] === 'A') this.areas.push({rect: numbers, strokes: [], marks: [], map: null});
			else if (head[0] === 'T') [told.large, told.answered] = [numbers[0] === 1, numbers[1]];
			else if (head[0] === 'N') told.name = command.slice(1);
			else if (head[0] === 'K') told.sets.push(command.slice(1));
			else if (!area) continue;
			else if (head[0] === 'M') area.map = numbers[0] > 0 && numbers[1] > 0 && numbers[0] * numbers[1] <= MAP_MOST ? {columns: numbers[0], rows: numbers[1], styles: points[0] || ''} : null;
			else if (head[0] === 'S') points[0] && [UPRIGHT, POINT, ...SHAPES].includes(numbers[1]) && area.marks.push({style: numbers[0], glyph: numbers[1], at: points[0].split(',').map((value) => value / 16)});
			else area.strokes.push({kind: head[0], style: numbers[0], line: numbers[1], rank: numbers[2], points: points.map((point) => (point === '-' ? null : point.split(',').map((value) => value / 16)))});
		}
		for (const area of this.areas) area.strokes.sort((a, b) => a.rank - b.rank);
		queueMicrotask(() => this.ask()); // the terminal, which is still parsing, asks for its frame before
		follow(told);
		return true;
	},
	// at the next frame, where the terminal does not render in it and draws these lines with its cells
	ask() {
		if (this.asked) return;
		this.asked = true;
		requestAnimationFrame(() => this.asked && this.draw());
	},
	turn(on, chosen = true) { // what a person has chosen stays
		Object.assign(this, {on, chosen, costs: []});
		element('lines').setAttribute('aria-pressed', String(on));
		this.draw();
	},
	colour(style) { return this.ink(this.colours[style]); },
	// of the 256 numbers of a terminal
	ink(number) {
		if (!(number >= 16)) return number >= 0 && number < 8 ? ['#000000', '#cd3131', '#0dbc79', '#e5e510', '#2472c8', '#bc3fbc', '#11a8cd', '#e5e5e5'][number] : term.options.theme.foreground;
		if (number >= 232) return 'rgb(' + Array(3).fill(8 + 10 * (number - 232)) + ')';
		return 'rgb(' + [36, 6, 1].map((part) => { const step = Math.floor((number - 16) / part) % 6; return step && 55 + 40 * step; }) + ')';
	},
	draw() {
		this.asked = false;
		const screen = term.element && term.element.querySelector('.xterm-screen');
		if (!screen || this.colours.length === 0) return; // nothing has been told yet
		if (!this.canvas) {
			this.canvas = document.createElement('canvas');
			this.canvas.id = 'vectors';
			this.canvas.setAttribute('aria-hidden', 'true');
			screen.append(this.canvas);
		}
		const width = screen.clientWidth, height = screen.clientHeight; // lays out what was rendered
		const begin = performance.now(), canvas = this.canvas, fine = devicePixelRatio || 1, pen = canvas.getContext('2d');
		if (canvas.width !== Math.round(width * fine) || canvas.height !== Math.round(height * fine)) {
			canvas.width = Math.round(width * fine);
			canvas.height = Math.round(height * fine);
			Object.assign(canvas.style, {width: width + 'px', height: height + 'px'});
		}
		pen.clearRect(0, 0, canvas.width, canvas.height);
		if (!this.on || term.hasSelection()) return;
		const across = canvas.width / term.cols, down = canvas.height / term.rows;
		this.draw_blocks(pen, across, down);
		for (const area of this.areas) this.draw_area(pen, area, across, down);
		if (this.chosen || this.costs.push(performance.now() - begin) < DRAWINGS) return;
		const median = this.costs.sort((a, b) => a - b)[DRAWINGS >> 1];
		this.costs = [];
		if (median > COSTLY) {
			this.turn(false, false);
			const why = 'Lines are drawn as characters: as lines a picture takes more than ' + COSTLY + ' ms here (F9 has them again).';
			if (element('notice').hidden) notice(why); // what a person has still to read stays
			setTimeout(() => { if (element('notice').textContent === why) notice(''); }, 10000);
		}
	},
	// cells that something is drawn in or beside: a sample in a legend is not one of them
	crossed({strokes, map}, columns, rows) {
		const found = new Uint8Array(columns * rows);
		const mark = (x, y, reach) => {
			for (let j = Math.max(0, Math.floor(y) - reach); j <= Math.min(rows - 1, Math.floor(y) + reach); j++)
				for (let i = Math.max(0, Math.floor(x) - reach); i <= Math.min(columns - 1, Math.floor(x) + reach); i++) found[j * columns + i] = 1;
		};
		for (const {kind, points} of strokes) {
			if (kind === 'B') return found.fill(1);
			points.forEach((point, i) => {
				const before = kind === 'L' && points[i - 1], steps = before && point ? Math.min(1000, Math.ceil(2 * Math.hypot(point[0] - before[0], point[1] - before[1]))) : 0;
				for (let k = 0; k < steps; k++) mark(before[0] + (point[0] - before[0]) * k / steps, before[1] + (point[1] - before[1]) * k / steps, 1);
				if (point) mark(point[0], point[1], 1);
			});
		}
		if (!map) return found;
		const pixels = this.image(map).getContext('2d').getImageData(0, 0, map.columns, map.rows).data, across = map.columns / columns, down = map.rows / rows;
		for (let i = 0; i < map.columns * map.rows; i++)
			if (pixels[4 * i + 3] > 0) found[Math.floor(Math.floor(i / map.columns) / down) * columns + Math.floor(i % map.columns / across)] = 1;
		return found;
	},
	// cells of the area: 1 those with dots or blocks, 2 blank ones beside them, into which a line may lean
	free({rect: [left, top, columns, rows], marks, crossed}, rules) {
		// what a mark has in its cells; of a rule in all of its column. Its place is rounded, and a disc may lean into the next cell and row.
		const marked = new Map();
		for (const {glyph, at: [x, y]} of marks) {
			const reach = glyph !== RULE && SHAPES.includes(glyph) ? RADIUS : 1 / 16;
			const [from, to] = glyph === RULE ? [0, rows - 1] : [Math.max(0, Math.floor(y - reach / 2)), Math.min(rows - 1, Math.floor(y + reach / 2))];
			for (let i = Math.max(0, Math.floor(x - reach)); i <= Math.min(columns - 1, Math.floor(x + reach)); i++)
				for (let j = from; j <= to; j++)
					if (glyph === RULE || (i === Math.floor(x) && j === Math.floor(y)) || !marked.has(j * columns + i)) marked.set(j * columns + i, glyph);
		}
		const buffer = term.buffer.active, found = new Uint8Array(columns * rows), blank = new Uint8Array(columns * rows), wide = new Uint8Array(columns * rows);
		let cell; // one for all, for a new one each is dear
		for (let y = 0; y < rows; y++) {
			const line = buffer.getLine(buffer.viewportY + top + y);
			for (let x = 0; line && x < columns; x++) {
				cell = line.getCell(left + x, cell);
				const code = cell ? cell.getCode() : -1;
				const mark = marked.get(y * columns + x), drawn = (code >= 0x2800 && code < 0x2900) || (code >= 0x2580 && code <= 0x2593);
				found[y * columns + x] = (crossed[y * columns + x] || mark) && (drawn || (code === mark && SHAPES.includes(mark)));
				blank[y * columns + x] = (code === 0 || code === 32) && cell.isBgDefault(); // nothing lies over the picture
				wide[y * columns + x] = code > 0xff && !found[y * columns + x]; // a sign of another font may be wider than its cell
				if (code !== 0x2500) continue;
				rules.add(y); // a line across, which curves have broken
				found[y * columns + x] = 1;
			}
		}
		const at = (list, x, y) => (x >= 0 && y >= 0 && x < columns && y < rows ? list[y * columns + x] : 0), near = (x, y) => at(found, x, y) === 1;
		for (let y = 0; y < rows; y++)
			for (let x = 0; x < columns; x++)
				if (blank[y * columns + x] && !at(wide, x - 1, y) && !at(wide, x + 1, y) && (near(x - 1, y) || near(x + 1, y) || near(x, y - 1) || near(x, y + 1))) found[y * columns + x] = 2;
		return found;
	},
	// large digits and scales, in whose blocks a font leaves seams
	draw_blocks(pen, across, down) {
		const buffer = term.buffer.active;
		let cell;
		for (let y = 0; y < term.rows; y++) {
			const line = buffer.getLine(buffer.viewportY + y);
			if (!line || !/[\u2580\u2584\u2588]/.test(line.translateToString(true))) continue; // a call a cell is dear
			for (let x = 0; x < term.cols; x++) {
				cell = line.getCell(x, cell);
				const code = cell.getCode();
				if (![0x2580, 0x2584, 0x2588].includes(code) || cell.isInverse()) continue;
				const x0 = Math.round(x * across), y0 = Math.round((y + (code === 0x2584 ? .5 : 0)) * down), y1 = Math.round((y + (code === 0x2580 ? .5 : 1)) * down);
				pen.fillStyle = this.ink(cell.isFgPalette() ? cell.getFgColor() : -1);
				pen.fillRect(x0, y0, Math.round((x + 1) * across) - x0, y1 - y0);
			}
		}
	},
	draw_area(pen, area, across, down) {
		const {rect: [left, top, columns, rows], strokes, marks, map} = area;
		if (strokes.length === 0 && marks.length === 0 && !map) return;
		area.crossed = area.crossed || this.crossed(area, columns, rows);
		const rules = new Set(), free = this.free(area, rules), edge = (place, cell) => Math.round(place * cell);
		pen.save();
		pen.beginPath();
		for (let y = 0; y < rows; y++)
			for (let x = 0, from = -1; x <= columns; x++) {
				const inside = x < columns && free[y * columns + x];
				if (inside && from < 0) from = x;
				if (!inside && from >= 0) {
					const x0 = edge(left + from, across), y0 = edge(top + y, down);
					pen.rect(x0 - 1, y0, edge(left + x, across) - x0 + 2, edge(top + y + 1, down) - y0); // cells end between pixels
					from = -1;
				}
			}
		pen.clip();
		pen.fillStyle = term.options.theme.background;
		pen.fillRect(edge(left, across), edge(top, down), Math.ceil(columns * across) + 1, Math.ceil(rows * down) + 1);
		if (map) this.draw_map(pen, map, edge(left, across), edge(top, down), edge(left + columns, across), edge(top + rows, down));
		const thin = Math.max(1.2, across / 7);
		pen.fillStyle = this.colour(FRAME);
		for (const y of rules) pen.fillRect(edge(left, across), edge(top + y + .5, down), columns * across, Math.max(1, Math.round(thin / 2)));
		for (const stroke of strokes) {
			pen.strokeStyle = pen.fillStyle = this.colour(stroke.style);
			pen.lineWidth = stroke.rank >= 4 ? 1.5 * thin : thin;
			pen.lineJoin = 'round';
			pen.setLineDash([[], [pen.lineWidth, 2.5 * pen.lineWidth], [6 * thin, 4 * thin]][stroke.kind === 'L' ? stroke.line : 0] || []);
			const place = ([x, y]) => [(left + x) * across, (top + y) * down];
			pen.beginPath();
			let begun = false;
			if (stroke.kind === 'B') {
				const pairs = stroke.points.filter(Boolean).map(place);
				[...pairs.filter((_, i) => i % 2 === 0), ...pairs.filter((_, i) => i % 2 === 1).reverse()].forEach((point, i) => (i ? pen.lineTo(...point) : pen.moveTo(...point)));
				pen.globalAlpha = [.85, .6, .4, .25][stroke.line & 3];
				pen.fill();
				pen.globalAlpha = 1;
				continue;
			}
			for (const point of stroke.points) {
				if (!point) begun = false;
				else if (stroke.kind === 'D') {
					const [x, y] = place(point);
					pen.moveTo(x + 1.4 * thin, y);
					pen.arc(x, y, 1.4 * thin, 0, 7);
				} else if (begun) pen.lineTo(...place(point));
				else pen.moveTo(...place(point)), begun = true;
			}
			stroke.kind === 'D' ? pen.fill() : pen.stroke();
		}
		pen.setLineDash([]);
		pen.lineWidth = thin;
		for (const {style, glyph, at: [x, y]} of marks) {
			pen.strokeStyle = pen.fillStyle = this.colour(style);
			this.draw_mark(pen, glyph, (left + x) * across, (top + y) * down, {across, down, thin, y0: top * down, y1: (top + rows) * down, row: edge(top + Math.floor(y), down)});
		}
		pen.restore();
	},
	draw_mark(pen, glyph, x, y, {across, down, thin, y0, y1, row}) {
		const radius = RADIUS * across, from = glyph === RULE ? y0 : row, to = glyph === RULE ? y1 : row + down;
		pen.beginPath();
		if (glyph === RULE || glyph === UPRIGHT) {
			pen.moveTo(x, from);
			pen.lineTo(x, to);
			return pen.stroke();
		}
		if (glyph === CROSS)
			for (const [dx, dy] of [[radius, 0], [0, radius]]) {
				pen.moveTo(x - dx, y - dy);
				pen.lineTo(x + dx, y + dy);
			}
		else if (glyph === SQUARE) pen.rect(x - radius, y - radius, 2 * radius, 2 * radius);
		else pen.arc(x, y, glyph === POINT ? 1.4 * thin : radius, 0, 7);
		if (glyph === POINT) return pen.fill();
		// seen on every colour of a map
		const colour = pen.strokeStyle;
		pen.strokeStyle = term.options.theme.background;
		pen.lineWidth = 3 * thin;
		pen.stroke();
		pen.strokeStyle = colour;
		pen.lineWidth = thin;
		if (glyph === RING) pen.fillStyle = term.options.theme.background;
		if (glyph !== CROSS) pen.fill();
		if (glyph === CROSS || glyph === RING) pen.stroke();
	},
	draw_map(pen, map, x0, y0, x1, y1) {
		pen.imageSmoothingEnabled = false;
		pen.drawImage(this.image(map), x0, y0, x1 - x0, y1 - y0);
	},
	image(map) {
		if (!map.image) {
			const {columns, rows} = map, image = new ImageData(columns, rows), probe = document.createElement('canvas').getContext('2d');
			const inks = {};
			let at = 0;
			for (const [, letter, times] of map.styles.matchAll(/([@-e.])(\d*)/g))
				for (let i = Number(times) || 1; i > 0 && at < columns * rows; i--, at++) {
					if (letter === '.') continue;
					if (!(letter in inks)) {
						probe.fillStyle = this.colour(letter.charCodeAt(0) - 64);
						inks[letter] = parseInt(probe.fillStyle.slice(1), 16);
					}
					const colour = inks[letter];
					image.data.set([colour >> 16, colour >> 8 & 255, colour & 255, 255], 4 * at);
				}
			map.image = Object.assign(document.createElement('canvas'), {width: columns, height: rows});
			map.image.getContext('2d').putImageData(image, 0, 0);
		}
		return map.image;
	},
};
