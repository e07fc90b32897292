// SPDX-License-Identifier: Apache-2.0
// Spray at the bow: threshold, drops of a bow that meets the surface fast, their fall.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Matrix4} from 'three';
import {kDrops, Spray, sprayStrength} from '../src/spray.js';

const ship = () => ({role: 'ship', slot: 0, def: {kind: 'rigid'}, half: [16, 5, 3], water: -0.5, matrix: new Matrix4()});
const flat = z => () => z;

test('spray begins at half of the velocity of slamming and is full at 1.2 of it', () => {
    const slam = 0.0935 * Math.sqrt(9.81 * 80);               // 2.62 m/s
    assert.deepEqual([0.4, 0.5].map(k => sprayStrength(k * slam, 80)), [0, 0]);
    assert.ok(Math.abs(sprayStrength(0.85 * slam, 80) - 0.5) < 1e-9);
    assert.equal(sprayStrength(1.3 * slam, 80), 1);
    assert.ok(sprayStrength(1.5, 32) > sprayStrength(1.5, 80));   // a short ship is wetter
});

/// Let the surface rise at the bow with a velocity for a second.
function rise(velocity, seconds = 1) {
    const spray = new Spray();
    spray.setScene([ship()]);
    for (let k = 0; k <= 60 * seconds; ++k) spray.take(10 + k / 60, flat(velocity * k / 60 - 0.5));
    return spray;
}

test('a bow that meets the surface fast throws drops up at both sides of the stem; a slow one none', () => {
    assert.equal(rise(0.5).count, 0);
    const spray = rise(2.5), p = spray.position.array;
    assert.ok(spray.count > 100 && spray.mesh.visible, `${spray.count}`);
    let port = 0, high = 0;
    for (let i = 0; i < spray.count; ++i) {
        assert.ok(p[3 * i] > 8 && p[3 * i] < 18 && Math.abs(p[3 * i + 1]) < 12, `${p.slice(3 * i, 3 * i + 3)}`);
        port += p[3 * i + 1] > 0 ? 1 : 0;
        high = Math.max(high, p[3 * i + 2]);
    }
    assert.ok(port > 0.3 * spray.count && port < 0.7 * spray.count && high > 2 && high < 8, `${port} ${high}`);
});

test('drops fall back and are removed; the number is limited; a restore clears them', () => {
    const spray = rise(2.5), n = spray.count;
    for (let k = 1; k <= 180; ++k) spray.take(11 + k / 60, flat(2));
    assert.ok(n > 0 && spray.count === 0 && !spray.mesh.visible);
    assert.ok(rise(40, 4).count <= kDrops);
    const other = rise(2.5);
    other.take(3, flat(0));
    assert.equal(other.count, 0);
});

test('the wind takes drops along', () => {
    const mean = wind => {
        const spray = rise(2.5);
        for (let k = 1; k <= 24; ++k) spray.take(11 + k / 60, flat(2), wind);
        const p = spray.position.array;
        let sum = 0;
        for (let i = 0; i < spray.count; ++i) sum += p[3 * i + 1];
        return sum / spray.count;
    };
    assert.ok(mean([0, 20]) > mean([0, 0]) + 0.5);
});
