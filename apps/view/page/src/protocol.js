// SPDX-License-Identifier: Apache-2.0
/// Frames and messages of docs/live.md, version 1.

export const kVersion = 1;
const kMagic = 0x564c5748, kHeader = 128;
export const kPaused = 1, kRecording = 2, kFailed = 4, kDragging = 8;

/// Return a frame as views into its buffer, which it keeps. @throws Error with the fault of the frame.
export function decodeFrame(buffer) {
    if (!(buffer instanceof ArrayBuffer)) throw new Error('a frame is binary');
    if (buffer.byteLength < kHeader) throw new Error(`a frame of ${buffer.byteLength} bytes has no header`);
    const d = new DataView(buffer), u = at => d.getUint32(at, true);
    if (u(0) !== kMagic) throw new Error('a frame does not begin with HWLV');
    if (d.getUint16(4, true) !== kVersion) throw new Error(`a frame of version ${d.getUint16(4, true)}; this page knows ${kVersion}`);
    if (u(8) !== buffer.byteLength) throw new Error(`a frame says ${u(8)} bytes and has ${buffer.byteLength}`);
    const [R, L, S, W, P, T, C, J, O, I, Q] = Array.from({length: 11}, (_, i) => u(48 + 4 * i));
    const floats = 7 * R + 3 * L + S + W + 3 * P + T + 6 * C + 3 * J + O + I + Q;
    if (kHeader + 4 * floats !== buffer.byteLength)
        throw new Error(`a frame's sections take ${kHeader + 4 * floats} bytes of ${buffer.byteLength}`);
    const flags = d.getUint16(6, true), bits = u(96);
    let at = kHeader;
    const take = (n, Type = Float32Array) => {
        const view = new Type(buffer, at, n);
        at += 4 * n;
        return view;
    };
    const frame = {
        flags, epoch: u(12), number: u(16), leftOut: u(20),
        steps: Number(d.getBigInt64(24, true)), time: d.getFloat64(32, true), clock: d.getFloat64(40, true),
        contactsLeftOut: u(92), certified: (bits & 1) !== 0, budgetEnded: (bits & 2) !== 0,
        late: (bits & 4) !== 0, cause: bits >> 8 & 255, iterationsEnded: d.getInt32(100, true),
        cuts: d.getBigUint64(104, true), coarser: d.getInt32(112, true), hasty: u(116) !== 0,
        contactCount: C, jointCount: J, pieces: T, points: P,
        rigid: take(7 * R), lumps: take(3 * L), scalars: take(S), counts: take(W, Uint32Array),
        wirePoints: take(3 * P), tensions: take(T), contacts: take(6 * C), joints: take(3 * J),
        outputs: take(O), inputs: take(I), stats: take(Q),
    };
    let points = 0, pieces = 0;
    for (const n of frame.counts) {
        points += n;
        pieces += Math.max(0, n - 1);
    }
    if (points !== P || pieces !== T) throw new Error("a frame's wires do not add up");
    return frame;
}

/// Return the largest tension of each wire [N]; NaN: removed. −1: every piece is broken.
export function largestTensions(frame, out = new Float32Array(frame.counts.length)) {
    let piece = 0;
    frame.counts.forEach((n, i) => {
        let most = n ? -1 : NaN;
        for (let k = 0; k + 1 < n; ++k) most = Math.max(most, frame.tensions[piece++]);
        out[i] = most;
    });
    return out;
}

/// Return the work that a budget skipped in a step, in words; empty: none.
export function leftOutWords(frame) {
    const words = [], plural = (n, what) => `${n} ${what}${n === 1 ? '' : 's'}`;
    if (frame.iterationsEnded > 0) words.push(`ended after ${plural(frame.iterationsEnded, 'Newton iteration')}`);
    let cuts = 0;
    for (let c = frame.cuts; c > 0n; c >>= 1n) cuts += Number(c & 1n);
    if (cuts) words.push(`${plural(cuts, 'interface')} between groups cut`);
    if (frame.coarser > 0) words.push(`wires ${plural(frame.coarser, 'level')} coarser`);
    if (frame.hasty) words.push('ended with the factorisation at hand');
    if (!words.length && frame.budgetEnded) words.push('ended the solve early');
    return words.join(', ');
}

/// Return the role's token from the fragment of the address: "#token=…"; "" if there is no valid one.
export const tokenOf = hash => /[#&]token=([0-9a-f]{32})\b/i.exec(hash ?? '')?.[1] ?? '';

/// Return the sea components of a scene as objects, with phases for points relative to `origin`, as in
/// frames.
export const seaComponents = (sea, origin = [0, 0, 0]) => (sea?.components ?? []).map(
    ([amplitude, wave_number, direction, frequency, phase]) => ({
        amplitude, wave_number, direction, frequency,
        phase: phase + wave_number * (origin[0] * Math.cos(direction) + origin[1] * Math.sin(direction)),
    }));

/// Return the level of still water [m] and the factor on all waves of a frame, from inputs and the tide.
/// If a frame does not contain them (recordings), return those of the scene.
export function seaState(scene, frame) {
    const read = (list, values, name) => values?.[list.findIndex(i => i.name === name)];
    const level = read(scene.inputs, frame?.inputs, 'sea.level') + read(scene.outputs, frame?.outputs, 'sea.tide');
    const factor = read(scene.inputs, frame?.inputs, 'sea.waves');
    return {
        level: Number.isFinite(level) ? level : scene.sea?.level ?? 0,
        factor: Number.isFinite(factor) ? factor : scene.sea?.waves_factor ?? 1,
    };
}
