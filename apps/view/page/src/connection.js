// SPDX-License-Identifier: Apache-2.0
/// The WebSocket: sends hello, keeps the newest frame, reconnects automatically.
import {decodeFrame, kVersion} from './protocol.js';

/// Return the waiting time before the n-th try [ms]: 0.4 s, doubled each time, 6 s at most.
export const retryDelay = n => Math.min(6000, 400 * 2 ** n);

/// True if this close code allows another try: the server did not reject the client.
export const mayRetry = code => code !== 1008;

export class Connection extends EventTarget {
    constructor(url, token, Socket = WebSocket) {
        super();
        Object.assign(this, {url, token, Socket, tries: 0, epoch: 0, frame: null, bytes: 0, frames: 0, nextId: 1});
        this.waiting = new Map();
        this.open();
    }

    tell(name, detail) {
        this.dispatchEvent(new CustomEvent(name, {detail}));
    }

    open() {
        this.tell('status', {state: 'connecting'});
        const socket = this.socket = new this.Socket(this.url);
        socket.binaryType = 'arraybuffer';
        socket.onopen = () => socket.send(JSON.stringify({type: 'hello', version: kVersion, token: this.token}));
        socket.onmessage = m => typeof m.data === 'string' ? this.text(m.data) : this.binary(m.data);
        socket.onclose = c => this.closed(c);
    }

    closed(c) {
        for (const done of this.waiting.values()) done({type: 'error', reason: 'the connection was lost'});
        this.waiting.clear();
        this.frame = null;
        if (!mayRetry(c.code)) {
            this.tell('status', {state: 'refused', reason: this.lastError ?? c.reason});
            return;
        }
        const wait = retryDelay(this.tries++);
        this.tell('status', {state: 'lost', wait, reason: this.goodbye || c.reason});
        this.timer = setTimeout(() => this.open(), wait);
    }

    /// Reconnect at once on request of the user.
    retry() {
        clearTimeout(this.timer);
        this.open();
    }

    text(data) {
        let m;
        try {
            m = JSON.parse(data);
        } catch {
            return;
        }
        if (m.type === 'scene') {
            this.epoch = m.epoch;
            this.frame = null;
            this.tries = 0;
            this.goodbye = null;
            this.tell('status', {state: 'open'});
        }
        if (m.type === 'bye') this.goodbye = m.reason;
        if (m.type === 'error') this.lastError = m.reason;
        const done = m.id !== undefined && this.waiting.get(m.id);
        if (done) {
            this.waiting.delete(m.id);
            done(m);
        }
        this.tell(m.type, m);
    }

    binary(data) {
        let frame;
        try {
            frame = decodeFrame(data);
        } catch (e) {
            this.tell('broken', e.message);
            return;
        }
        this.bytes += data.byteLength;
        ++this.frames;
        if (frame.epoch !== this.epoch) return;
        this.frame = frame;
        this.tell('frame', frame);
    }

    get isOpen() {
        return this.socket.readyState === 1;
    }

    /// Send a message. @return false if there is no connection.
    send(message) {
        if (!this.isOpen) return false;
        this.socket.send(JSON.stringify(message));
        return true;
    }

    /// Send a message and wait for the answer: {type: 'ok' | 'error' | 'picked', …}.
    ask(message) {
        const id = this.nextId++;
        return new Promise(done => {
            if (!this.send({...message, id})) return done({type: 'error', reason: 'there is no connection'});
            this.waiting.set(id, done);
        });
    }
}
