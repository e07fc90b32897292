// SPDX-License-Identifier: Apache-2.0
/// Small helpers for elements.

export const $ = id => document.getElementById(id);

/// Create an element with properties, attributes (keys with "-" or `role`), children.
export function el(tag, props = {}, ...children) {
    const e = document.createElement(tag);
    for (const [key, value] of Object.entries(props)) {
        if (value === undefined || value === null) continue;
        if (key.startsWith('on')) e.addEventListener(key.slice(2), value);
        else if (key.includes('-') || key === 'role' || key === 'for') e.setAttribute(key, value);
        else e[key] = value;
    }
    e.append(...children.filter(c => c !== null && c !== undefined));
    return e;
}

const kSvg = 'http://www.w3.org/2000/svg';
/// Create an element of a drawing with attributes and children.
export function svg(tag, props = {}, ...children) {
    const e = document.createElementNS(kSvg, tag);
    for (const [key, value] of Object.entries(props)) e.setAttribute(key, value);
    e.append(...children);
    return e;
}

let hide = 0;
/// Show a short message that disappears by itself.
export function toast(words) {
    const t = $('toast');
    t.textContent = words;
    t.hidden = false;
    clearTimeout(hide);
    hide = setTimeout(() => { t.hidden = true; }, 4200);
}

/// Format seconds as "1:02.5".
export function clock(t) {
    if (!Number.isFinite(t)) return '–';
    const sign = t < 0 ? '−' : '', tenths = Math.floor(Math.abs(t) * 10 + 1e-6);
    return `${sign}${Math.floor(tenths / 600)}:${String(Math.floor(tenths / 10) % 60).padStart(2, '0')}.${tenths % 10}`;
}

/// Store values in the browser; a failure is ignored.
export const memory = {
    get(key, or) {
        try {
            return JSON.parse(localStorage.getItem(`hawser.${key}`)) ?? or;
        } catch {
            return or;
        }
    },
    set(key, value) {
        try {
            localStorage.setItem(`hawser.${key}`, JSON.stringify(value));
        } catch { /* private windows */ }
    },
};
