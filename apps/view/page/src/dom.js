// SPDX-License-Identifier: Apache-2.0
/// Small helpers for elements.

export const $ = id => document.getElementById(id);

/// An element with properties, attributes (keys with "-" or `role`), children.
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

let hide = 0;
/// A short message that goes by itself.
export function toast(words) {
    const t = $('toast');
    t.textContent = words;
    t.hidden = false;
    clearTimeout(hide);
    hide = setTimeout(() => { t.hidden = true; }, 4200);
}

/// "1:02.5" of seconds.
export function clock(t) {
    if (!Number.isFinite(t)) return '–';
    const sign = t < 0 ? '−' : '', tenths = Math.floor(Math.abs(t) * 10 + 1e-6);
    return `${sign}${Math.floor(tenths / 600)}:${String(Math.floor(tenths / 10) % 60).padStart(2, '0')}.${tenths % 10}`;
}

/// Kept in the browser; what cannot be kept is forgotten.
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
