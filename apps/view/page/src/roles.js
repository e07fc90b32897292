// SPDX-License-Identifier: Apache-2.0
/// Choose the appearance of a body with only a box in the scene. It depends on its size, on whether
/// it floats and, for fittings, on the last word of its name.

const last = name => name.slice(name.lastIndexOf('/') + 1).toLowerCase();

/// Return ship, barge, semi, box, cylinder, ball, anchor, hook, boom, lattice, none.
/// body: {name, kind, half: [x, y, z] or null, afloat}.
export function roleOf(body) {
    // The hull of a template has the name of its copy: "barge/hull".
    const own = last(body.name), cut = body.name.lastIndexOf('/'), word = own === 'hull' && cut > 0 ? last(body.name.slice(0, cut)) + own : own;
    if (body.kind === 'scalar') return 'none';
    if (body.kind === 'lump') return 'ball';
    if (!body.half) return 'none';
    const [hx, hy, hz] = body.half, long = hx / Math.max(hy, 1e-9);
    if (/derrick|lattice|mast/.test(word) && hz > 1.5 * Math.max(hx, hy)) return 'lattice';
    if (/anchor/.test(word)) return 'anchor';
    if (/hook|block/.test(word)) return 'hook';
    if (/^(boom|jib)/.test(word)) return 'boom';
    if (/rod|barrel|roller|drum|tower|pulley|sheave|cylinder|disk|wheel/.test(word)) return 'cylinder';
    if (/barge|pontoon/.test(word) && hx > 3) return 'barge';
    if (/rig|semi|platform/.test(word) && hx > 15 && hz > 5) return 'semi';
    if (body.afloat || /hull|ship|vessel|tug|ahts|boat/.test(word)) {
        if (hx > 5 && long >= 2.2) return 'ship';
        if (hx > 15 && hz > 0.2 * hx) return 'semi';
        if (hx > 3 && hz < 0.5 * hx) return 'barge';
    }
    return 'box';
}

/// Return the axis of a cylinder from its box: the other two sizes are most alike.
export function longAxis([x, y, z]) {
    const unlike = {x: Math.abs(y - z), y: Math.abs(x - z), z: Math.abs(x - y)};
    return Object.keys(unlike).reduce((a, b) => unlike[b] < unlike[a] - 1e-9 ? b : a, 'z');
}

/// Return the radius of a ball of steel of a mass [kg], 5 cm at least [m].
export const ballRadius = mass => Math.max(0.05, Number(Math.cbrt((mass || 0) * 3 / (4 * Math.PI * 7850)).toPrecision(3)));

/// Return the working deck in the body's frame: height of the top of the largest flat box among its
/// shapes, and its forward end, as a fraction of the half length; null: none.
export function workingDeck(shapes, half) {
    let best = null;
    for (const s of shapes ?? []) {
        if (s.kind !== 'box' || !s.half_size) continue;
        const [x, y, z] = s.half_size, flat = z < 0.35 * Math.min(x, y);
        if (!flat || x < 0.15 * half[0] || y < 0.4 * half[1] || z > 0.5 * half[2]) continue;
        if (!best || x * y > best.area)
            best = {area: x * y, z: s.position[2] + z, front: (s.position[0] + x) / half[0]};
    }
    return best && Math.abs(best.z) < 1.2 * half[2] ? best : null;
}

const kCapitals = new Set(['ahts', 'dp', 'psv', 'osv', 'ahc', 'aops', 'mops', 'rov']);

/// Format a name in words of the trade: "ahts1/work_drum" → "AHTS 1 work drum". Numbers stand apart,
/// abbreviations in capitals; parts of the program ("feed") are left out.
export function readable(name) {
    const words = name.replaceAll(/[/._]/g, ' ').replaceAll(/([a-z])(\d)/gi, '$1 $2').split(' ').filter(w => w && w !== 'feed');
    const text = words.map(w => kCapitals.has(w.toLowerCase()) ? w.toUpperCase() : w).join(' ');
    return text.charAt(0).toUpperCase() + text.slice(1);
}
