// SPDX-License-Identifier: Apache-2.0
/// Sky, light, sea surface and seabed.
import {
    BackSide, BufferAttribute, BufferGeometry, Color, DirectionalLight, Group, HemisphereLight, Mesh,
    ShaderMaterial, SphereGeometry, UniformsLib, UniformsUtils, Vector3, Vector4, DoubleSide,
} from 'three';

export const HORIZON = new Color(0xc3d5e0);
const ZENITH = new Color(0x4d86bd), DEEP = new Color(0x0e3a52), SAND = new Color(0xb7a583);
export const SUN = new Vector3(0.55, -0.5, 0.62).normalize();
export const kWaves = 48;  // components that the surface is drawn with, the largest first

const noise = `
float hash(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
float noise(vec2 p) {
    vec2 i = floor(p), f = fract(p); f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x),
               mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);
}`;

export function makeSky() {
    const material = new ShaderMaterial({
        side: BackSide, depthWrite: false, fog: false,
        uniforms: {zenith: {value: ZENITH}, horizon: {value: HORIZON}, sun: {value: SUN}},
        vertexShader: `varying vec3 way;
void main() {
    way = position;
    vec4 p = projectionMatrix * mat4(mat3(modelViewMatrix)) * vec4(position, 1.0);
    gl_Position = p.xyww;
}`,
        fragmentShader: `uniform vec3 zenith, horizon, sun; varying vec3 way; ${noise}
void main() {
    vec3 d = normalize(way);
    float up = max(d.z, 0.0);
    vec3 c = mix(horizon, zenith, pow(up, 0.55));
    vec2 q = d.xy / (0.18 + up) * 1.3;
    float cloud = smoothstep(0.52, 0.85, 0.6 * noise(q) + 0.3 * noise(q * 2.3) + 0.1 * noise(q * 5.1));
    c = mix(c, vec3(0.94, 0.96, 0.97), 0.55 * cloud * smoothstep(0.02, 0.25, up));
    float s = max(dot(d, sun), 0.0);
    c += vec3(1.0, 0.9, 0.7) * (0.25 * pow(s, 24.0) + 1.5 * pow(s, 900.0));
    gl_FragColor = vec4(c, 1.0);
    #include <colorspace_fragment>
}`,
    });
    const mesh = new Mesh(new SphereGeometry(1, 24, 16), material);
    mesh.frustumCulled = false;
    mesh.renderOrder = -10;
    return mesh;
}

export function makeLight() {
    const group = new Group(), sky = new HemisphereLight(0xdcebf5, 0x55636b, 1.7);
    const sun = new DirectionalLight(0xfff2dc, 2.6);
    sky.position.set(0, 0, 1);
    sun.castShadow = true;
    sun.shadow.mapSize.set(1024, 1024);
    sun.shadow.bias = -0.0006;
    sun.shadow.normalBias = 0.35;
    group.add(sky, sun, sun.target);
    group.sun = sun;
    return group;
}

/// The sun's shadow covers a square of `reach` metres about `at`.
export function aimSun(light, at, reach) {
    const {sun} = light, c = sun.shadow.camera, r = Math.max(15, Math.min(reach, 260));
    sun.target.position.copy(at);
    sun.position.copy(at).addScaledVector(SUN, 3 * r);
    if (Math.abs(c.right - r) > 0.15 * r) {
        Object.assign(c, {left: -r, right: r, top: r, bottom: -r, near: 0.5 * r, far: 6 * r});
        c.updateProjectionMatrix();
    }
}

/// Rings about the eye: fine near it, to `far` metres. Vertices in units of 1 m, scaled by script.
function rings(far, inner) {
    const spokes = 96, count = 76, position = [0, 0, 0], index = [];
    for (let i = 0; i < count; ++i) {
        const r = inner * (far / inner) ** (i / (count - 1));
        for (let k = 0; k < spokes; ++k)
            position.push(r * Math.cos(2 * Math.PI * k / spokes), r * Math.sin(2 * Math.PI * k / spokes), 0);
    }
    for (let k = 0; k < spokes; ++k) index.push(0, 1 + k, 1 + (k + 1) % spokes);
    for (let i = 0; i + 1 < count; ++i)
        for (let k = 0; k < spokes; ++k) {
            const a = 1 + i * spokes + k, b = 1 + i * spokes + (k + 1) % spokes;
            index.push(a, a + spokes, b + spokes, a, b + spokes, b);
        }
    const g = new BufferGeometry();
    g.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
    g.setIndex(index);
    return g;
}

/// The wave components that are drawn: [amplitude, kx, ky, phase at t = 0 … ω t], the largest.
export function largestWaves(components, limit = kWaves) {
    return [...components].sort((a, b) => b.amplitude - a.amplitude).slice(0, limit);
}

/// Height of the drawn surface at a place and time; the same sum as in the shader.
export function waveHeight(waves, t, x, y) {
    let z = 0;
    for (const w of waves)
        z += w.amplitude * Math.cos(w.wave_number * (x * Math.cos(w.direction) + y * Math.sin(w.direction))
                                    - w.frequency * t + w.phase);
    return z;
}

export class Water {
    constructor() {
        this.waves = [];
        const uniforms = UniformsUtils.merge([UniformsLib.fog, {
            count: {value: 0}, wave: {value: Array.from({length: kWaves}, () => new Vector4())},
            eye: {value: new Vector3()}, origin: {value: new Vector3()}, time: {value: 0},
            opacity: {value: 0.62}, below: {value: 0},
            horizon: {value: HORIZON}, zenith: {value: ZENITH}, deep: {value: DEEP}, sun: {value: SUN},
        }]);
        this.material = new ShaderMaterial({
            uniforms, transparent: true, depthWrite: false, fog: true, side: DoubleSide,
            vertexShader: waterVertex, fragmentShader: waterFragment,
        });
        this.mesh = new Mesh(rings(14000, 1.2), this.material);
        this.mesh.frustumCulled = false;
        this.mesh.renderOrder = 5;
    }

    setWaves(components) {
        this.waves = largestWaves(components ?? []);
        this.material.uniforms.count.value = this.waves.length;
    }

    /// t [s], the level of still water [m], the eye, a factor on all waves.
    update(t, level, eye, factor = 1) {
        const u = this.material.uniforms;
        this.waves.forEach((w, i) => u.wave.value[i].set(
            w.amplitude * factor, w.wave_number * Math.cos(w.direction), w.wave_number * Math.sin(w.direction),
            (w.phase - w.frequency * t) % (2 * Math.PI)));
        u.time.value = t % 1000;
        u.eye.value.copy(eye);
        u.below.value = eye.z < level ? 1 : 0;
        this.mesh.position.set(eye.x, eye.y, level);
    }
}

const waterVertex = `
uniform int count; uniform vec4 wave[${kWaves}]; uniform vec3 eye;
varying vec3 at; varying vec3 tilt;
#include <common>
#include <fog_pars_vertex>
void main() {
    vec4 w = modelMatrix * vec4(position, 1.0);
    float z = 0.0; vec2 slope = vec2(0.0);
    float reach = length(w.xy - eye.xy), spacing = 0.14 * reach + 0.5;
    for (int i = 0; i < ${kWaves}; ++i) {
        if (i >= count) break;
        // What the grid cannot carry there would alias: it fades.
        float fade = 1.0 - smoothstep(0.25, 0.7, length(wave[i].yz) * spacing / 3.14159);
        float a = wave[i].x * fade, arg = dot(wave[i].yz, w.xy) + wave[i].w;
        z += a * cos(arg);
        slope -= a * sin(arg) * wave[i].yz;
    }
    w.z += z;
    at = w.xyz; tilt = vec3(-slope, 1.0);
    vec4 mvPosition = viewMatrix * w;
    gl_Position = projectionMatrix * mvPosition;
    #include <fog_vertex>
}`;

const waterFragment = `
uniform vec3 eye, horizon, zenith, deep, sun; uniform float time, opacity, below;
varying vec3 at; varying vec3 tilt;
#include <common>
#include <fog_pars_fragment>
${noise}
void main() {
    vec3 v = eye - at; float far = length(v); v /= far;
    float calm = 1.0 / (1.0 + far * far * 4e-5);
    vec2 p = at.xy;
    vec2 r = vec2(noise(p * 0.55 + vec2(time * 0.7, time * 0.3)) - 0.5, noise(p * 0.55 + vec2(7.0 - time * 0.4, time * 0.6)) - 0.5)
           + 0.6 * vec2(noise(p * 1.7 + vec2(-time * 1.1, time * 0.8)) - 0.5, noise(p * 1.7 + vec2(3.0 + time, -time * 0.9)) - 0.5);
    vec2 swell = vec2(noise(p * 0.045 + time * 0.05) - 0.5, noise(p * 0.045 + 9.0 - time * 0.04) - 0.5);
    vec3 n = normalize(tilt + vec3(0.11 * calm * r + (0.03 + 0.05 * calm) * swell, 0.0));
    if (below > 0.5) n = -n;
    float c = clamp(dot(n, v), 0.0, 1.0), f = 0.02 + 0.98 * pow(1.0 - c, 5.0);
    vec3 m = reflect(-v, n); m.z = abs(m.z);
    vec3 sky = mix(horizon, zenith, pow(clamp(m.z, 0.0, 1.0), 0.55));
    float lit = 0.75 + 0.5 * dot(n, sun);
    vec3 body = mix(deep, vec3(0.03, 0.27, 0.33), 0.35 + 1.2 * (n.x * sun.x + n.y * sun.y)) * lit;
    float glint = pow(max(dot(m, sun), 0.0), 220.0) * (0.3 + 0.9 * calm);
    vec3 colour = mix(body, sky, f) + vec3(1.0, 0.92, 0.75) * glint;
    float alpha = mix(opacity, 1.0, max(f, smoothstep(400.0, 5000.0, far)));
    if (below > 0.5) { colour = mix(vec3(0.16, 0.42, 0.5), vec3(0.4, 0.62, 0.68), c); alpha = 0.75; }
    gl_FragColor = vec4(colour, clamp(alpha + glint, 0.0, 1.0));
    #include <colorspace_fragment>
    #include <fog_fragment>
}`;

export class Seabed {
    constructor() {
        this.material = new ShaderMaterial({
            fog: true, uniforms: UniformsUtils.merge([UniformsLib.fog, {
                eye: {value: new Vector3()}, sand: {value: SAND}, deep: {value: DEEP}, depth: {value: 100}, wet: {value: 1},
            }]),
            vertexShader: `varying vec3 at;
#include <fog_pars_vertex>
void main() { vec4 w = modelMatrix * vec4(position, 1.0); at = w.xyz; vec4 mvPosition = viewMatrix * w;
gl_Position = projectionMatrix * mvPosition;
#include <fog_vertex>
}`,
            fragmentShader: `uniform vec3 eye, sand, deep; uniform float depth, wet; varying vec3 at;
#include <fog_pars_fragment>
${noise}
float grid(vec2 p, float s) {
    vec2 q = abs(fract(p / s - 0.5) - 0.5) * s, w = fwidth(p) * 1.2;
    vec2 l = 1.0 - smoothstep(w * 0.5, w * 1.5, q);
    return max(l.x, l.y) * (1.0 - smoothstep(s * 0.1, s * 0.4, max(w.x, w.y)));
}
void main() {
    float far = distance(eye, at);
    float g = 0.5 * noise(at.xy * 0.03) + 0.3 * noise(at.xy * 0.13) + 0.2 * noise(at.xy * 0.6 + sin(at.yx * 0.2));
    vec3 c = sand * (0.72 + 0.45 * g);
    c = mix(c, vec3(0.95), 0.25 * grid(at.xy, 100.0));
    float murk = wet * (1.0 - exp(-depth / 160.0));
    c = mix(c, deep * 1.5, 0.25 + 0.6 * murk);
    c = mix(c, deep * 1.15, wet * smoothstep(300.0, 2600.0, far));
    gl_FragColor = vec4(c, 1.0);
    #include <colorspace_fragment>
    #include <fog_fragment>
}`,
        });
        this.mesh = new Mesh(rings(9000, 10), this.material);
        this.mesh.frustumCulled = false;
        this.mesh.renderOrder = -1;
    }

    /// Height of the bed [m], depth of water over it [m]; 0: dry.
    set(height, depth) {
        this.height = height;
        this.material.uniforms.depth.value = Math.max(0, depth);
        this.material.uniforms.wet.value = depth > 0 ? 1 : 0;
    }

    update(eye) {
        this.material.uniforms.eye.value.copy(eye);
        this.mesh.position.set(eye.x, eye.y, this.height);
    }
}
