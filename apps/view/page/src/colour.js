// SPDX-License-Identifier: Apache-2.0
/// Colours of the page: the map from utilisation (tension over breaking load) to a colour.
///
/// The map runs from pale blue over yellow and orange to dark red. Its order survives the three
/// common kinds of colour blindness: blue against yellow is visible without red or green, and
/// from yellow on it darkens steadily. test/colour_test.mjs simulates all three (G. M. Machado,
/// M. M. Oliveira, L. A. F. Fernandes, "A physiologically-based model for simulation of color
/// vision deficiency", IEEE TVCG 15, 2009) and measures the distances that remain.

/// [fraction of the range, r, g, b], sRGB 0 to 255.
export const STOPS = [
    [0.0, 58, 118, 196],
    [0.2, 120, 186, 224],
    [0.4, 244, 232, 150],
    [0.6, 246, 170, 52],
    [0.8, 214, 78, 20],
    [1.0, 122, 4, 8],
];

/// Palettes for the tension of wires, with equal positions of their stops. All keep their order under
/// the three kinds of colour blindness; `light` also without any colour vision.
export const kPalettes = {
    standard: {label: 'Blue to red', stops: STOPS},
    orange: {label: 'Blue to orange', stops: [[0.0, 18, 78, 150], [0.2, 84, 160, 210], [0.4, 214, 228, 240], [0.6, 252, 196, 130], [0.8, 236, 110, 20], [1.0, 120, 40, 4]]},
    light: {label: 'Light to dark', stops: [[0.0, 255, 255, 224], [0.2, 255, 206, 80], [0.4, 228, 112, 6], [0.6, 170, 48, 2], [0.8, 98, 16, 4], [1.0, 34, 4, 3]]},
};

/// Colour of broken wires, and of wires with unknown strength.
export const GREY = [150, 156, 162];

/// sRGB 0 to 255 of a utilisation 0 to 1, clamped; not a number: grey.
export function tensionColour(share, stops = STOPS) {
    if (!Number.isFinite(share)) return GREY.slice();
    const x = Math.min(1, Math.max(0, share));
    let i = 1;
    while (i < stops.length - 1 && x > stops[i][0]) ++i;
    const [a, ...from] = stops[i - 1], [b, ...to] = stops[i];
    const t = (x - a) / (b - a);
    return from.map((v, k) => Math.round(v + t * (to[k] - v)));
}

const linear = v => {
    const s = v / 255;
    return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
};

/// Linear RGB 0 to 1 for the renderer.
export const toLinear = rgb => rgb.map(linear);

/// A table of linear RGB floats: utilisation 0 to 1 in `size` steps, then one entry of grey.
export function colourTable(size) {
    const out = new Float32Array(3 * (size + 1));
    for (let i = 0; i < size; ++i) out.set(toLinear(tensionColour(i / (size - 1))), 3 * i);
    out.set(toLinear(GREY), 3 * size);
    return out;
}

/// CSS gradient of the map, left to right.
export const gradient = (stops = STOPS) => 'linear-gradient(to right, ' +
    stops.map(([x, r, g, b]) => `rgb(${r} ${g} ${b}) ${100 * x}%`).join(', ') + ')';

/// Relative luminance (WCAG 2.1) of sRGB 0 to 255.
export const luminance = rgb => {
    const [r, g, b] = toLinear(rgb);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};

/// Contrast ratio of two colours (WCAG 2.1), 1 to 21.
export function contrast(a, b) {
    const x = luminance(a), y = luminance(b);
    return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
}
