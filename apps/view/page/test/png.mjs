// SPDX-License-Identifier: Apache-2.0
// Small PNG files for docs/: colours reduced to a palette by median cut.
import {Buffer} from 'node:buffer';
import {writeFileSync} from 'node:fs';
import * as zlib from 'node:zlib';

const bits = 6, side = 1 << bits;   // of the histogram, for each channel
const cell = (r, g, b) => (r >> 8 - bits) << 2 * bits | (g >> 8 - bits) << bits | b >> 8 - bits;

/// Return boxes of colours of about equal importance: the box with the largest sum of squared deviations
/// along one channel is cut at its mean until there are `most`.
function medianCut(cells, most) {
    const measure = box => {
        let n = 0;
        const sum = [0, 0, 0], square = [0, 0, 0];
        for (const c of box.cells) {
            n += c.n;
            for (let k = 0; k < 3; ++k) {
                sum[k] += c.n * c.rgb[k];
                square[k] += c.n * c.rgb[k] ** 2;
            }
        }
        box.mean = sum.map(s => s / n);
        const spread = square.map((s, k) => s - sum[k] ** 2 / n);
        box.channel = spread.indexOf(Math.max(...spread));
        box.spread = box.cells.length > 1 ? spread[box.channel] : 0;
        return box;
    };
    const boxes = [measure({cells})];
    while (boxes.length < most) {
        const box = boxes.reduce((a, b) => b.spread > a.spread ? b : a);
        if (!(box.spread > 0)) break;
        const low = box.cells.filter(c => c.rgb[box.channel] <= box.mean[box.channel]), high = box.cells.filter(c => c.rgb[box.channel] > box.mean[box.channel]);
        if (!low.length || !high.length) { box.spread = 0; continue; }
        boxes.splice(boxes.indexOf(box), 1, measure({cells: low}), measure({cells: high}));
    }
    return boxes;
}

function chunk(type, data) {
    const out = Buffer.alloc(12 + data.length);
    out.writeUInt32BE(data.length);
    out.write(type, 4, 'latin1');
    data.copy(out, 8);
    out.writeUInt32BE(crc(out.subarray(4, 8 + data.length)), 8 + data.length);
    return out;
}

const kTable = Uint32Array.from({length: 256}, (_, n) => {
    for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ n >>> 1 : n >>> 1;
    return n >>> 0;
});
function crc(data) {
    if (zlib.crc32) return zlib.crc32(data);
    let c = 0xffffffff;
    for (const byte of data) c = kTable[(c ^ byte) & 255] ^ c >>> 8;
    return (c ^ 0xffffffff) >>> 0;
}

/// Return a PNG with a palette. @param rgba  Bytes of the pixels, rows from above.
export function palettePng(width, height, rgba, colours = 256) {
    const count = new Map();
    for (let i = 0; i < rgba.length; i += 4) {
        const key = cell(rgba[i], rgba[i + 1], rgba[i + 2]), c = count.get(key);
        if (c) { ++c.n; c.sum[0] += rgba[i]; c.sum[1] += rgba[i + 1]; c.sum[2] += rgba[i + 2]; }
        else count.set(key, {n: 1, sum: [rgba[i], rgba[i + 1], rgba[i + 2]]});
    }
    for (const c of count.values()) c.rgb = c.sum.map(s => s / c.n);
    const boxes = medianCut([...count.values()], colours), index = new Uint8Array(side ** 3), palette = Buffer.alloc(3 * boxes.length);
    boxes.forEach((box, i) => {
        for (const c of box.cells) c.index = i;
        box.mean.forEach((v, k) => { palette[3 * i + k] = Math.round(v); });
    });
    for (const [key, c] of count) index[key] = c.index;
    const rows = Buffer.alloc(height * (width + 1));
    for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x) {
            const i = 4 * (y * width + x);
            rows[y * (width + 1) + 1 + x] = index[cell(rgba[i], rgba[i + 1], rgba[i + 2])];
        }
    const head = Buffer.alloc(13);
    head.writeUInt32BE(width, 0);
    head.writeUInt32BE(height, 4);
    head.set([8, 3, 0, 0, 0], 8);
    return Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk('IHDR', head), chunk('PLTE', palette), chunk('IDAT', zlib.deflateSync(rows, {level: 9})), chunk('IEND', Buffer.alloc(0))]);
}

/// Take a screenshot of a page and write it with a palette, which needs a third of the bytes.
export async function palettePicture(page, path, {width, height}) {
    const pixels = await page.evaluate(async bytes => {
        // The page's security policy forbids fetch() of data.
        const png = Uint8Array.from(atob(bytes), one => one.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([png], {type: 'image/png'})), c = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        c.drawImage(bitmap, 0, 0);
        const d = c.getImageData(0, 0, bitmap.width, bitmap.height).data, parts = [];
        for (let i = 0; i < d.length; i += 32768) parts.push(String.fromCharCode(...d.subarray(i, i + 32768)));
        return btoa(parts.join(''));
    }, (await page.screenshot({timeout: 180000})).toString('base64'));
    writeFileSync(path, palettePng(width, height, Buffer.from(pixels, 'base64')));
}
