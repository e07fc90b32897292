// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {colourTable, contrast, GREY, kPalettes, luminance, STOPS, tensionColour, toLinear} from '../src/colour.js';

// Machado, Oliveira, Fernandes 2009, severity 1.0, on linear RGB (table 1 of their supplement).
const kBlind = {
    protan: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    deutan: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    tritan: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    none: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
};

function lab(linear) {   // CIE 1976, D65
    const [r, g, b] = linear.map(v => Math.min(1, Math.max(0, v)));
    const xyz = [(0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047, 0.2126 * r + 0.7152 * g + 0.0722 * b, (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883];
    const f = xyz.map(t => t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116);
    return [116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])];
}

const seen = (rgb, m) => lab(m.map(row => row.reduce((s, v, i) => s + v * toLinear(rgb)[i], 0)));
const far = (a, b) => Math.hypot(...a.map((v, i) => v - b[i]));

test('the map has its stops, is clamped, and what is no number is grey', () => {
    for (const [x, ...rgb] of STOPS) assert.deepEqual(tensionColour(x), rgb);
    assert.deepEqual(tensionColour(-3), STOPS[0].slice(1));
    assert.deepEqual(tensionColour(7), STOPS.at(-1).slice(1));
    assert.deepEqual(tensionColour(NaN), GREY);
});

test('a higher tension is redder beside blue all the way', () => {
    let before = -Infinity;
    for (let i = 0; i <= 100; ++i) {
        const [r, , b] = tensionColour(i / 100), share = (r - b) / (r + b);
        assert.ok(share > before - 0.02, `at ${i} %: ${share} after ${before}`);
        before = Math.max(before, share);
    }
});

// 2.3 is a just noticeable difference of CIE 1976; a tenth of the range shall be four of them apart,
// and no two places that are a third of the range apart closer than eight, for whoever looks.
for (const [who, m] of Object.entries(kBlind)) for (const [name, {stops}] of Object.entries(kPalettes)) {
    test(`tenths of the range are told apart: ${name}, ${who}`, () => {
        const at = Array.from({length: 31}, (_, i) => seen(tensionColour(i / 30, stops), m));
        for (let i = 0; i + 3 < at.length; ++i) assert.ok(far(at[i], at[i + 3]) > 9.2, `${i / 30}: ${far(at[i], at[i + 3])}`);
        for (let i = 0; i < at.length; ++i)
            for (let k = i + 10; k < at.length; ++k) assert.ok(far(at[i], at[k]) > 18.4, `${i / 30} and ${k / 30}: ${far(at[i], at[k])}`);
    });
}

test('the palette from light to dark darkens all the way', () => {
    const light = Array.from({length: 31}, (_, i) => luminance(tensionColour(i / 30, kPalettes.light.stops)));
    for (let i = 1; i < light.length; ++i) assert.ok(light[i] < light[i - 1], `${i}`);
});

test('palettes have their stops at equal positions', () => {
    for (const {stops} of Object.values(kPalettes)) assert.deepEqual(stops.map(s => s[0]), STOPS.map(s => s[0]));
});

test('the table ends in grey', () => {
    const t = colourTable(16);
    assert.equal(t.length, 51);
    assert.deepEqual([...t.slice(48)], [...Float32Array.from(toLinear(GREY))]);
});

test('text has the contrast that WCAG 2.1 AA asks for', () => {
    assert.ok(Math.abs(contrast([255, 255, 255], [0, 0, 0]) - 21) < 1e-9);
    const glass = [11, 29, 42], dim = [182, 197, 208], ink = [243, 247, 250];
    for (const c of [dim, ink]) assert.ok(contrast(c, glass) >= 4.5);
    assert.ok(contrast([40, 24, 0], [246, 170, 52]) >= 4.5);    // primary button
    assert.ok(contrast([6, 32, 47], [124, 192, 232]) >= 4.5);   // pressed button
});
