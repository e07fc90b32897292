// SPDX-License-Identifier: Apache-2.0
/// Keys of the whole page. Inside text fields and lists the keys are theirs.
import {$, memory} from './dom.js';
import {kModes} from './camera.js';

export function bindKeys(app) {
    const held = new Set();
    const free = e => !e.ctrlKey && !e.altKey && !e.metaKey && !e.target.closest?.('input[type="text"], select, textarea');
    const near = e => e.target.closest?.('input[type="range"]');
    const keys = {
        ' ': e => { if (!e.target.closest?.('button, summary, input')) return app.play(), true; },
        '.': () => app.step(), '[': () => app.levers.next(-1), ']': () => app.levers.next(1), 0: () => app.levers.neutral(),
        c: () => app.command('camera'), b: () => app.nextSubject(), p: () => app.mayControl && app.drag.mode(!app.drag.on),
        s: () => app.save(`at ${$('time').textContent}`), r: () => app.restoreLast(), g: () => app.panel('plots'), i: () => app.dials(), a: () => app.alarms.all(), k: () => app.screenshot(), m: () => app.menu(), d: () => app.debriefing.toggle(), h: () => app.clean(),
        '?': () => app.panel('keys'),
        n: () => {
            app.stage.show.names = app.boxes.names.checked = !app.stage.show.names;
            memory.set('show', app.stage.show);
        },
        Escape: () => {
            app.clean(false);
            app.menu(false);
            app.drag.end();
            app.drag.mode(false);
            for (const id of ['layers', 'restore', 'keys']) app.setPanel(id, false);
        },
    };
    kModes.forEach((mode, i) => { keys[i + 1] = () => app.camera(mode); });
    addEventListener('keydown', e => {
        if (!free(e) || e.defaultPrevented) return;
        if (['ArrowUp', 'ArrowDown'].includes(e.key) && !near(e)) {
            app.levers.nudge(e.key === 'ArrowUp' ? 1 : -1, e.key);
            held.add(e.key);
            e.preventDefault();
            return;
        }
        if (['ArrowLeft', 'ArrowRight'].includes(e.key) && !near(e)) {
            if (e.target.closest?.('[role="radiogroup"]')) return arrowsInCameras(app, e);
            if (app.scene?.mode === 'recording') {
                const t = app.timeline.neighbour(app.frame?.time ?? 0, e.key === 'ArrowRight' ? 1 : -1);
                if (t !== undefined) app.timeline.want(t);
            }
            return;
        }
        const f = keys[e.key.length === 1 ? e.key.toLowerCase() : e.key];
        if (f && !(e.repeat && e.key !== '.') && !(near(e) && e.key === '0')) {
            const ours = f(e);
            if (e.key !== ' ' || ours) e.preventDefault();
        }
    });
    addEventListener('keyup', e => {
        if (held.delete(e.key)) app.levers.levers.forEach((_, at) => app.levers.letGo(at, e.key));
    });
    addEventListener('blur', () => app.levers.levers.forEach(l => l.held.clear()));
}

function arrowsInCameras(app, e) {
    const to = app.nextCamera(e.key === 'ArrowRight' ? 1 : -1);
    $('cameras').querySelector(`[data-mode="${to}"]`).focus();
    e.preventDefault();
}
