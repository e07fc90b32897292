// SPDX-License-Identifier: Apache-2.0
/// Words of the page in English, German and Norwegian (bokmål), from one table. A key that is not in
/// the table is shown as it is: names and texts of scenes and exercises are in the language of their
/// author.
import {kWords} from './word_table.js';

export const kLanguages = {en: 'English', de: 'Deutsch', no: 'Norsk'};
const columns = Object.keys(kLanguages);
export const language = {code: 'en'};

/// Return the language of the page for a list of preferences: the first one that it has.
export function chooseLanguage(preferred) {
    for (const tag of preferred) {
        const code = String(tag).slice(0, 2).toLowerCase(), own = code === 'nb' || code === 'nn' ? 'no' : code;
        if (columns.includes(own)) return own;
    }
    return 'en';
}

/// Translate a key of the table.
export function t(key, code = language.code) {
    const row = kWords[key];
    return row ? row[columns.indexOf(code)] : key;
}

/// Translate texts, titles and labels of elements that are in the file of the page. Elements that
/// scripts fill are not touched: they translate their own words.
export function translatePage(root) {
    const walk = document.createTreeWalker(root, NodeFilter.SHOW_ELEMENT);
    for (let e = walk.currentNode; e; e = walk.nextNode()) {
        for (const name of ['title', 'aria-label', 'placeholder']) {
            const key = e.dataset?.[`key${name.replace('-', '')}`] ?? e.getAttribute?.(name);
            if (key && kWords[key]) {
                e.dataset[`key${name.replace('-', '')}`] = key;
                e.setAttribute(name, t(key));
            }
        }
        if (e.childNodes.length !== 1 || e.firstChild.nodeType !== 3) continue;
        const key = e.dataset?.keytext ?? e.textContent.trim();
        if (!kWords[key]) continue;
        e.dataset.keytext = key;
        e.textContent = t(key);
    }
    document.documentElement.lang = language.code;
}
