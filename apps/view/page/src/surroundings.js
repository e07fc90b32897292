// SPDX-License-Identifier: Apache-2.0
/// Sky, light, sea surface and seabed.
import {
    BackSide, DataTexture, DirectionalLight, Group, HemisphereLight,
    LinearFilter, LinearMipmapLinearFilter, LinearMipmapNearestFilter, Mesh, RepeatWrapping, RGBAFormat, ShaderMaterial, SphereGeometry, UniformsLib, UniformsUtils, Vector3, Vector4, DoubleSide,
} from 'three';
import {AIR, exceeded, LAMPS, SAND, SUN, whitecaps} from './air.js';
import {drawSector, rings} from './rings.js';

export const kWaves = 40;  // components that the surface is drawn with, the largest first

/// A tile of smooth noise, periodic: red and green its slope, blue its height, each about ½.
export function noiseTile(size = 128) {
    const height = new Float32Array(size * size);
    let seed = 20240607;
    const random = () => {   // Numerical Recipes' quick generator: the same tile each time
        seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
        return seed / 4294967296;
    };
    for (const [cells, weight] of [[4, 0.5], [9, 0.3], [21, 0.17], [47, 0.08]]) {
        const grid = Float32Array.from({length: cells * cells}, random);
        for (let j = 0; j < size; ++j)
            for (let i = 0; i < size; ++i) {
                const x = i * cells / size, y = j * cells / size, a = Math.floor(x), b = Math.floor(y);
                const ease = t => t * t * t * (t * (6 * t - 15) + 10), u = ease(x - a), v = ease(y - b);
                const g = (p, q) => grid[(q % cells) * cells + p % cells];
                height[j * size + i] += weight * ((g(a, b) * (1 - u) + g(a + 1, b) * u) * (1 - v) + (g(a, b + 1) * (1 - u) + g(a + 1, b + 1) * u) * v - 0.5);
            }
    }
    const out = new Uint8Array(4 * size * size), h = (i, j) => height[((j + size) % size) * size + (i + size) % size];
    const byte = v => Math.max(0, Math.min(255, Math.round(127.5 + 127.5 * v)));
    for (let j = 0; j < size; ++j)
        for (let i = 0; i < size; ++i) {
            const slope = size / 20;
            out.set([byte(slope * (h(i + 1, j) - h(i - 1, j))), byte(slope * (h(i, j + 1) - h(i, j - 1))), byte(1.6 * h(i, j)), 255], 4 * (j * size + i));
        }
    return out;
}

function noiseTexture(low) {
    const size = 128, t = new DataTexture(noiseTile(size), size, size, RGBAFormat);
    t.wrapS = t.wrapT = RepeatWrapping;
    t.minFilter = low ? LinearMipmapNearestFilter : LinearMipmapLinearFilter;
    t.magFilter = LinearFilter;
    t.generateMipmaps = true;
    t.anisotropy = low ? 1 : 4;
    t.needsUpdate = true;
    return t;
}
/// To sRGB; where processors draw by a square root, which is within 0.03 of it and cheap.
export const encode = `
#ifdef LOW
    gl_FragColor.rgb = sqrt(max(gl_FragColor.rgb, 0.0));
#else
    #include <colorspace_fragment>
#endif`;
export const tile = {value: null};
const noise = `uniform sampler2D tile;
float noise(vec2 p) { return texture2D(tile, p * 0.11).b; }
vec2 ripple(vec2 p) { return texture2D(tile, p * 0.11).rg - 0.5; }`;

export function makeSky() {
    tile.value ??= noiseTexture(false);
    const material = new ShaderMaterial({
        side: BackSide, depthWrite: false, fog: false,
        uniforms: {...AIR, tile},
        vertexShader: `varying vec3 way;
void main() {
    way = position;
    vec4 p = projectionMatrix * mat4(mat3(modelViewMatrix)) * vec4(position, 1.0);
    gl_Position = p.xyww;
}`,
        fragmentShader: `uniform vec3 zenith, horizon, sun, cloudy; uniform float bright; varying vec3 way; ${noise}
void main() {
    vec3 d = normalize(way);
    float up = max(d.z, 0.0);
    vec3 c = mix(horizon, zenith, sqrt(up));
    vec2 q = d.xy / (0.14 + up) * 0.9;
    float cloud = smoothstep(0.48, 0.8, 0.62 * noise(q) + 0.38 * noise(q * 2.7 + 3.0));
    c = mix(c, cloudy, 0.75 * cloud * smoothstep(0.01, 0.2, up));
    float s = max(dot(d, sun), 0.0); s *= s; s *= s; s *= s;
    float glow = s * s * s, disc = glow * glow; disc *= disc; disc *= disc; disc *= disc; disc *= disc; disc *= disc;
    c += vec3(1.0, 0.9, 0.7) * (0.25 * glow + 1.5 * disc) * bright;
    gl_FragColor = vec4(c, 1.0);
    ${encode}
}`,
    });
    const mesh = new Mesh(new SphereGeometry(1, 24, 16), material);
    mesh.frustumCulled = false;
    mesh.renderOrder = 4;   // behind all that is opaque: only what is seen of it is painted
    return mesh;
}

/// @param low  True: a coarser map of shadows, for processors that draw.
export function makeLight(low = false) {
    const group = new Group(), sky = new HemisphereLight(LAMPS.sky, LAMPS.ground, LAMPS.around);
    const sun = new DirectionalLight(LAMPS.sun, LAMPS.straight), map = low ? 512 : 1024;
    sky.position.set(0, 0, 1);
    sun.castShadow = true;
    sun.shadow.mapSize.set(map, map);
    sun.shadow.bias = -0.0004;
    sun.shadow.normalBias = 0.25;
    group.add(sky, sun, sun.target);
    Object.assign(group, {sun, sky});
    return group;
}

/// Give the lamps the light of the air.
export function lightUp({sun, sky}) {
    sky.color.copy(LAMPS.sky);
    sky.groundColor.copy(LAMPS.ground);
    sky.intensity = LAMPS.around;
    sun.color.copy(LAMPS.sun);
    sun.intensity = LAMPS.straight;
}

/// Aim the shadow of the sun at a square of `reach` metres about `at`. Return the covered reach.
export function aimSun(light, at, reach) {
    const {sun} = light, c = sun.shadow.camera, r = Math.max(15, Math.min(reach, 260));
    sun.target.position.copy(at);
    sun.position.copy(at).addScaledVector(SUN, 3 * r);
    if (Math.abs(c.right - r) > 0.15 * r) {
        Object.assign(c, {left: -r, right: r, top: r, bottom: -r, near: 0.5 * r, far: 6 * r});
        c.updateProjectionMatrix();
    }
    return r;
}

/// Return the largest wave components, which are drawn: [amplitude, kx, ky, phase at t = 0 … ω t].
export function largestWaves(components, limit = kWaves) {
    return [...components].sort((a, b) => b.amplitude - a.amplitude).slice(0, limit);
}

/// Return the height of the drawn surface at a point and time; equal to the sum in the shader.
export function waveHeight(waves, t, x, y) {
    let z = 0;
    for (const w of waves)
        z += w.amplitude * Math.cos(w.wave_number * (x * Math.cos(w.direction) + y * Math.sin(w.direction))
                                    - w.frequency * t + w.phase);
    return z;
}

export class Water {
    /// @param plain  Drawing for machines whose processor draws (plain.js).
    constructor(plain = null) {
        tile.value ??= noiseTexture(Boolean(plain));
        this.waves = [];
        const uniforms = UniformsUtils.merge([UniformsLib.fog, {
            count: {value: 0}, wave: {value: Array.from({length: kWaves}, () => new Vector4())},
            eye: {value: new Vector3()}, origin: {value: new Vector3()}, time: {value: 0},
            opacity: {value: 0.62}, below: {value: 0}, caps: {value: 1e3}, spread: {value: 1}, pixel: {value: 0.001},
        }]);
        Object.assign(uniforms, AIR, {tile});
        this.material = new ShaderMaterial({
            uniforms, transparent: true, depthWrite: false, fog: true, side: DoubleSide,
            vertexShader: plain?.vertex ?? waterVertex, fragmentShader: plain?.fragment ?? waterFragment,
        });
        this.mesh = new Mesh(plain?.rings() ?? rings(14000, 1.2, 144, 150), this.material);
        this.mesh.frustumCulled = false;
        this.mesh.renderOrder = 5;
    }

    setWaves(components) {
        this.waves = largestWaves(components ?? []);
        this.material.uniforms.count.value = this.waves.length;
    }

    /// Set the wind [m/s]; NaN: the wind that raises such waves. Foam covers the crests whose convergence of
    /// the surface is exceeded over the area of whitecaps in that wind.
    setWind(wind, factor = 1) {
        const u = this.material.uniforms, w = Number.isFinite(wind) ? wind : windOf(this.waves, factor);
        u.spread.value = Math.max(1e-6, factor * Math.sqrt(this.waves.reduce((s, c) => s + 0.5 * (c.amplitude * c.wave_number) ** 2, 0)));
        u.caps.value = this.waves.length ? u.spread.value * exceeded(whitecaps(w)) : 1e3;
    }

    /// t [s], the level of still water [m], the camera, a factor on all waves.
    update(t, level, camera, factor = 1) {
        const u = this.material.uniforms, eye = camera.position;
        this.waves.forEach((w, i) => u.wave.value[i].set(
            w.amplitude * factor, w.wave_number * Math.cos(w.direction), w.wave_number * Math.sin(w.direction),
            (w.phase - w.frequency * t) % (2 * Math.PI)));
        u.time.value = t % 1000;
        u.eye.value.copy(eye);
        u.below.value = eye.z < level ? 1 : 0;
        this.mesh.position.set(eye.x, eye.y, level);
        drawSector(this.mesh, camera);
    }
}

/// Return the wind [m/s] of a fully developed sea of these waves: Hs = 0.0246 U² (Pierson and Moskowitz,
/// 1964).
export const windOf = (waves, factor = 1) => Math.sqrt(4 * factor * Math.sqrt(waves.reduce((s, c) => s + 0.5 * c.amplitude ** 2, 0)) / 0.0246);

/// Elevation and slope of the surface. Waves that a grid of this spacing cannot resolve would alias;
/// they fade out.
export const kWaveSum = `
uniform int count; uniform vec4 wave[${kWaves}];
void waves(vec2 place, float spacing, out float z, out vec2 slope, out float crest) {
    z = 0.0; slope = vec2(0.0); crest = 0.0;
    for (int i = 0; i < ${kWaves}; ++i) {
        if (i >= count) break;
        float k = length(wave[i].yz), fade = 1.0 - smoothstep(0.35, 0.9, k * spacing / 3.14159);
        if (fade <= 0.0) continue;
        float a = wave[i].x * fade, arg = dot(wave[i].yz, place) + wave[i].w, c = a * cos(arg);
        z += c;
        crest += k * c;
        slope -= a * sin(arg) * wave[i].yz;
    }
}`;

const waterVertex = `
${kWaveSum}
uniform vec3 eye;
varying vec3 at;
#include <common>
#include <fog_pars_vertex>
void main() {
    vec4 w = modelMatrix * vec4(position, 1.0);
    float z, crest; vec2 slope;
    waves(w.xy, 0.065 * length(w.xy - eye.xy) + 0.3, z, slope, crest);
    w.z += z;
    at = w.xyz;
    vec4 mvPosition = viewMatrix * w;
    gl_Position = projectionMatrix * mvPosition;
    #include <fog_vertex>
}`;

// Slopes are summed at pixels: a mesh that carries them as far as they are seen would be too fine.
const waterFragment = `
${kWaveSum}
uniform vec3 eye, horizon, zenith, deep, sun; uniform float time, opacity, below, caps, spread, bright, pixel;
varying vec3 at;
#include <common>
#include <fog_pars_fragment>
${noise}
void main() {
    vec3 v = eye - at; float far = length(v); v /= far;
    float calm = 1.0 / (1.0 + far * far * 1.2e-5);
    vec2 p = at.xy, slope; float z, crest;
    waves(p, 0.5 * far * pixel / max(0.06, abs(v.z)), z, slope, crest);
    vec2 swell = ripple(p * 0.035 + time * vec2(0.012, -0.009));
    vec2 r = ripple(p * 0.9 + vec2(time * 0.62, time * 0.31)) + ripple(p * 0.37 + vec2(-time * 0.21, time * 0.34));
    vec3 n = normalize(vec3(-slope + (0.05 + 0.22 * calm) * r + 0.1 * swell, 1.0));
    if (below > 0.5) n = -n;
    float c = clamp(dot(n, v), 0.0, 1.0), q = 1.0 - c, f = 0.02 + 0.98 * q * q * q * q * q;
    vec3 m = reflect(-v, n); m.z = abs(m.z);
    vec3 sky = mix(horizon, zenith, sqrt(clamp(m.z, 0.0, 1.0)));
    float lit = 0.75 + 0.5 * dot(n, sun);
    vec3 body = mix(deep, vec3(0.02, 0.25, 0.32) * bright, clamp(0.4 + 2.2 * (n.x * sun.x + n.y * sun.y) + 0.22 * clamp(crest / spread, -1.0, 2.0), 0.0, 1.0)) * lit;
    float glint = max(dot(m, sun), 0.0);
    glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint;
    glint *= 0.9 * min(1.0, 2.0 * bright);
    vec3 colour = mix(body, sky, f) + vec3(1.0, 0.92, 0.75) * glint;
    // Foam: broken by two scales of noise, thin streaks behind the crest.
    float grain = noise(p * 2.3 + time * 0.05) + noise(p * 0.7) - 1.0, ragged = crest + 0.9 * spread * grain;
    float foam = smoothstep(caps, caps + 0.5 * spread, ragged) * smoothstep(0.3, 0.75, noise(p * 5.1) + 0.25) * (1.0 - smoothstep(900.0, 3500.0, far));
    colour = mix(colour, vec3(0.9, 0.94, 0.95) * (0.1 + 0.9 * bright) * (0.7 + 0.3 * lit), 0.85 * foam);
    float alpha = mix(opacity, 1.0, max(max(f, foam), smoothstep(400.0, 5000.0, far)));
    if (below > 0.5) { colour = mix(vec3(0.16, 0.42, 0.5), vec3(0.4, 0.62, 0.68), c) * bright; alpha = 0.75; }
    gl_FragColor = vec4(colour, clamp(alpha + glint, 0.0, 1.0));
    ${encode}
    #include <fog_fragment>
}`;

export class Seabed {
    constructor(plain = null) {
        const uniforms = UniformsUtils.merge([UniformsLib.fog, {
            eye: {value: new Vector3()}, sand: {value: SAND}, depth: {value: 100}, wet: {value: 1},
        }]);
        Object.assign(uniforms, AIR, {tile}, plain?.uniforms());
        this.material = new ShaderMaterial({
            fog: true, uniforms, vertexShader: plain?.vertex ?? bedVertex, fragmentShader: plain?.fragment ?? bedFragment,
        });
        this.mesh = new Mesh(rings(9000, 10, 48, 24), this.material);
        this.mesh.frustumCulled = false;
        this.mesh.renderOrder = 1;   // behind bodies: only what is seen of it is painted
    }

    /// Height of the bed [m], depth of water over it [m]; 0: dry.
    set(height, depth) {
        this.height = height;
        this.material.uniforms.depth.value = Math.max(0, depth);
        this.material.uniforms.wet.value = depth > 0 ? 1 : 0;
    }

    update(camera) {
        const eye = camera.position;
        this.material.uniforms.eye.value.copy(eye);
        this.mesh.position.set(eye.x, eye.y, this.height);
        drawSector(this.mesh, camera);
    }
}

const bedVertex = `varying vec3 at;
#include <fog_pars_vertex>
void main() { vec4 w = modelMatrix * vec4(position, 1.0); at = w.xyz; vec4 mvPosition = viewMatrix * w;
gl_Position = projectionMatrix * mvPosition;
#include <fog_vertex>
}`;

const bedFragment = `uniform vec3 eye, sand, deep; uniform float depth, wet, bright; varying vec3 at;
#include <fog_pars_fragment>
${noise}
float grid(vec2 p, float s) {
    vec2 q = abs(fract(p / s - 0.5) - 0.5) * s, w = fwidth(p) * 1.2;
    vec2 l = 1.0 - smoothstep(w * 0.5, w * 1.5, q);
    return max(l.x, l.y) * (1.0 - smoothstep(s * 0.1, s * 0.4, max(w.x, w.y)));
}
void main() {
    float far = distance(eye, at);
    float g = 0.6 * noise(at.xy * 0.02) + 0.4 * noise(at.xy * 0.31);
    vec3 c = sand * (0.72 + 0.45 * g);
    c = mix(c, vec3(0.95), 0.25 * grid(at.xy, 100.0));
    float murk = wet * (1.0 - exp(-depth / 160.0));
    c = mix(c * bright, deep * 1.5, 0.25 + 0.6 * murk);
    c = mix(c, deep * 1.15, wet * smoothstep(300.0, 2600.0, far));
    gl_FragColor = vec4(c, 1.0);
    ${encode}
    #include <fog_fragment>
}`;
