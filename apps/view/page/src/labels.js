// SPDX-License-Identifier: Apache-2.0
/// Names in the picture: as text of the page, so that they are sharp and can be found.
import {Vector3} from 'three';
import {readable} from './roles.js';

const kMost = 28;
const rank = {ship: 5, semi: 5, barge: 4, anchor: 3, hook: 2, lattice: 1, box: 1, ball: 1};

export class Labels {
    constructor(layer) {
        this.layer = layer;
        this.items = [];
        this.at = new Vector3();
    }

    setScene(bodies, wires) {
        this.layer.replaceChildren();
        const worth = bodies.filter(b => rank[b.role] && b.slot >= 0).sort((a, b) => rank[b.role] - rank[a.role] || b.size - a.size);
        this.items = worth.slice(0, kMost).map(body => this.item({body, text: readable(body.name.replace(/\/hull$/, ''))}));
        let n = 0;
        wires.forEach((w, index) => {
            if (w.kind !== 'line' && w.kind !== 'rod' && n++ < kMost) this.items.push(this.item({wire: index, text: readable(w.name)}));
        });
    }

    item(what) {
        const element = document.createElement('span');
        element.className = what.body ? 'name' : 'name wire';
        element.textContent = what.text;
        element.style.display = 'none';
        this.layer.append(element);
        return {...what, element, width: 8 * what.text.length + 14, shown: false};
    }

    update(stage, on) {
        const taken = [], frame = stage.frame;
        const first = [0];
        frame?.counts.forEach((n, i) => first.push(first[i] + n));
        for (const item of this.items) {
            let place = null;
            if (on && frame && !(stage.aboard && item.body && item.body === stage.subjectBody)) {
                const at = this.anchor(item, stage, frame, first), far = at && at.distanceTo(stage.camera.position);
                const near = item.body ? item.body.size * 90 : 420;
                if (at && far < Math.min(near, 4000) && far > 2) place = stage.project(at.clone());
            }
            if (place && place.x > 0 && place.y > 0 && place.x < stage.width && place.y < stage.height) {
                const box = [place.x - item.width / 2, place.y - 22, place.x + item.width / 2, place.y + 2];
                if (taken.some(b => box[0] < b[2] && box[2] > b[0] && box[1] < b[3] && box[3] > b[1])) place = null;
                else taken.push(box);
            } else place = null;
            this.put(item, place);
        }
    }

    anchor(item, stage, frame, first) {
        if (item.body) {
            const b = item.body;
            return this.at.copy(b.position).setZ(b.position.z + (b.role === 'ship' ? 2.6 : 1.15) * (b.half?.[2] ?? 0.5) + 0.5);
        }
        const n = frame.counts[item.wire];
        if (n < 2) return null;
        const k = 3 * (first[item.wire] + Math.floor(n / 2));
        return this.at.fromArray(frame.wirePoints, k);
    }

    put(item, place) {
        const s = item.element.style, shown = place !== null;
        if (shown !== item.shown) {
            s.display = shown ? '' : 'none';
            item.shown = shown;
        }
        if (shown) s.transform = `translate(${place.x.toFixed(1)}px, ${place.y.toFixed(1)}px) translate(-50%, -100%)`;
    }
}
