// SPDX-License-Identifier: Apache-2.0
/// Surroundings and paint for machines whose processor draws. There the work at each pixel is
/// expensive: it is one texture at most, and all other work is done at corners. Colours are mixed in
/// their displayed form (square roots of light), so that no conversion to linear light is needed.
import {
    BackSide, BufferAttribute, BufferGeometry, ClampToEdgeWrapping, DataTexture, DoubleSide, LinearFilter,
    LinearMipmapNearestFilter, Mesh, RepeatWrapping, ShaderMaterial, UniformsLib, UniformsUtils, Vector3,
} from 'three';
import {AIR, CLOUD, HORIZON, SAND, SUN, ZENITH} from './air.js';
import {rings} from './rings.js';
import {kWaveSum, noiseTile} from './surroundings.js';

const bytes = (out, i, rgb) => out.set([...rgb.map(v => Math.max(0, Math.min(255, Math.round(255 * v)))), 255], 4 * i);
const vec3 = v => `vec3(${v.map(x => x.toFixed(5)).join(', ')})`;
const mix = (a, b, t) => a.map((v, k) => v + (b[k] - v) * t);
const smoothstep = (a, b, x) => {
    const t = Math.max(0, Math.min(1, (x - a) / (b - a)));
    return t * t * (3 - 2 * t);
};

/// Return a function for the height of the noise tile, 0 to 1, at coordinates with period 1.
function sampler() {
    const n = 128, tile = noiseTile(n), at = (i, j) => tile[4 * ((j & n - 1) * n + (i & n - 1)) + 2] / 255;
    return (x, y) => {
        const u = x * n - 0.5, v = y * n - 0.5, i = Math.floor(u), j = Math.floor(v), a = u - i, b = v - j;
        return (at(i, j) * (1 - a) + at(i + 1, j) * a) * (1 - b) + (at(i, j + 1) * (1 - a) + at(i + 1, j + 1) * a) * b;
    };
}

function image(size, paint, mips = false) {
    const [wide, high] = size, data = new Uint8Array(4 * wide * high);
    for (let j = 0; j < high; ++j) for (let i = 0; i < wide; ++i) bytes(data, j * wide + i, paint(i, j));
    const t = new DataTexture(data, wide, high);
    t.wrapS = RepeatWrapping;
    t.wrapT = mips ? RepeatWrapping : ClampToEdgeWrapping;
    t.magFilter = LinearFilter;
    t.minFilter = mips ? LinearMipmapNearestFilter : LinearFilter;
    t.generateMipmaps = mips;
    t.needsUpdate = true;
    return t;
}

/// Paint the sky once: bearing horizontally, elevation of 0 to 90° vertically.
function skyImage() {
    const wide = 1024, high = 256, noise = sampler(), sun = SUN.toArray();
    const zenith = ZENITH.toArray(), horizon = HORIZON.toArray(), white = CLOUD.toArray(), bright = AIR.bright.value;
    return image([wide, high], (i, j) => {
        const a = 2 * Math.PI * i / wide, e = Math.PI / 2 * j / (high - 1), d = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
        const up = d[2], s = 0.9 / (0.14 + up);
        let c = mix(horizon, zenith, Math.sqrt(up));
        const cloud = smoothstep(0.48, 0.8, 0.62 * noise(d[0] * s * 0.11, d[1] * s * 0.11) + 0.38 * noise((d[0] * s * 2.7 + 3) * 0.11, (d[1] * s * 2.7 + 3) * 0.11));
        c = mix(c, white, 0.75 * cloud * smoothstep(0.01, 0.2, up));
        const facing = Math.max(0, d[0] * sun[0] + d[1] * sun[1] + d[2] * sun[2]), light = bright * (0.25 * facing ** 24 + 1.5 * facing ** 1536);
        return [1, 0.9, 0.7].map((v, k) => Math.sqrt(c[k] + light * v));
    });
}

export function makePlainSky() {
    const spokes = 32, rows = [-90, -8, 0, 5, 12, 22, 36, 54, 72, 90], position = [], uv = [], index = [];
    for (const row of rows)
        for (let k = 0; k <= spokes; ++k) {
            const e = row * Math.PI / 180, a = 2 * Math.PI * k / spokes;
            position.push(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
            uv.push(k / spokes, (Math.max(0, row) / 90 * 255 + 0.5) / 256);
        }
    for (let r = 0; r + 1 < rows.length; ++r)
        for (let k = 0; k < spokes; ++k) {
            const p = r * (spokes + 1) + k, q = p + spokes + 1;
            index.push(p, p + 1, q + 1, p, q + 1, q);
        }
    const g = new BufferGeometry();
    g.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
    g.setAttribute('uv', new BufferAttribute(new Float32Array(uv), 2));
    g.setIndex(index);
    const mesh = new Mesh(g, new ShaderMaterial({
        side: DoubleSide, depthWrite: false, fog: false, uniforms: {sky: {value: skyImage()}},
        vertexShader: `varying vec2 place;
void main() { place = uv; gl_Position = (projectionMatrix * mat4(mat3(modelViewMatrix)) * vec4(position, 1.0)).xyww; }`,
        fragmentShader: `uniform sampler2D sky; varying vec2 place;
void main() { gl_FragColor = texture2D(sky, place); }`,
    }));
    mesh.frustumCulled = false;
    mesh.renderOrder = 4;
    /// Paint the sky anew after a change of the air.
    mesh.repaint = () => {
        mesh.material.uniforms.sky.value.dispose();
        mesh.material.uniforms.sky.value = skyImage();
    };
    return mesh;
}

const fog = `uniform vec3 fogColor; uniform float fogNear, fogFar;
float haze(float depth) { return smoothstep(fogNear, fogFar, depth); }`;

/// Material for Water: surface, colour and reflectance at corners, ripples at pixels.
export const plainWater = {
    rings: () => rings(14000, 1.2, 112, 116),
    vertex: `
${kWaveSum}
uniform vec3 eye, sun, horizon, zenith, deep; uniform float time, opacity, below, caps, spread, bright; uniform sampler2D tile;
varying vec4 paint; varying vec3 mirrored; varying vec2 place; varying vec3 glint; varying float calm, white;
${fog}
void main() {
    vec4 w = modelMatrix * vec4(position, 1.0);
    float z, crest; vec2 slope;
    waves(w.xy, 0.084 * length(w.xy - eye.xy) + 0.4, z, slope, crest);
    w.z += z;
    vec3 v = eye - w.xyz; float far = length(v); v /= far;
    float side = below > 0.5 ? -1.0 : 1.0;
    vec2 swell = (textureLod(tile, (w.xy * 0.035 + time * vec2(0.012, -0.009)) * 0.11, 2.0).rg - 0.5) * (1.0 - smoothstep(300.0, 900.0, far));
    vec3 n = side * normalize(vec3(0.14 * swell - slope, 1.0));
    float c = clamp(dot(n, v), 0.0, 1.0), q = 1.0 - c, f = 0.02 + 0.98 * q * q * q * q * q;
    vec3 m = reflect(-v, n);
    vec3 sky = sqrt(mix(horizon, zenith, sqrt(abs(m.z))));
    float rise = clamp(crest / spread, -1.0, 2.0);
    vec3 body = sqrt(mix(deep, vec3(0.02, 0.25, 0.32) * bright, clamp(0.4 + 2.2 * dot(n.xy, sun.xy) + 0.35 * rise, 0.0, 1.0)) * (0.75 + 0.5 * dot(n, sun)));
    white = ((crest - caps) / spread + 0.1) * (1.0 - smoothstep(700.0, 2500.0, far)) - 4.0 * smoothstep(700.0, 2500.0, far) - 9.0 * below;
    paint = vec4(mix(body, sky, f), mix(opacity, 1.0, max(f, smoothstep(400.0, 5000.0, far))));
    calm = 0.1 + 0.44 / (1.0 + far * far * 1.2e-5);
    mirrored = (sky - body) * 2.5 * q * q * q + vec3(0.02, 0.1, 0.11) * bright;
    // What the sun's mirror image is at the pixel: m·s = 2 (n·v)(n·s) − v·s, with a little slope more.
    glint = vec3(dot(n, sun), c, dot(v, sun));
    if (below > 0.5) {
        paint = vec4(sqrt(mix(vec3(0.16, 0.42, 0.5), vec3(0.4, 0.62, 0.68), c) * bright), 0.75);
        mirrored = vec3(0.12);
        glint.x = 0.0;
    }
    place = (w.xy * 0.6 + vec2(time * 0.4, time * 0.2)) * 0.11;
    vec4 mv = viewMatrix * w;
    float h = haze(-mv.z);
    paint.rgb = mix(paint.rgb, sqrt(fogColor), h);
    mirrored *= 1.0 - h;
    gl_Position = projectionMatrix * mv;
}`,
    fragment: `
uniform sampler2D tile; uniform vec3 sun; uniform float bright;
varying vec4 paint; varying vec3 mirrored; varying vec2 place; varying vec3 glint; varying float calm, white;
void main() {
    vec3 s = texture2D(tile, place).rgb;
    vec2 d = (s.rg - 0.5) * calm;
    float turned = dot(d, sun.xy);
    float g = max(2.0 * (glint.y + 0.5 * d.x) * (glint.x + turned) - glint.z, 0.0);
    g *= g; g *= g; g *= g; g *= g; g *= g; g *= g; g *= 0.6 * min(1.0, 2.0 * bright);
    float foam = clamp(1.6 * (white + 2.4 * (s.b - 0.5)), 0.0, 0.85);
    gl_FragColor = vec4(mix(paint.rgb + mirrored * (2.2 * turned) + g, vec3(0.93, 0.96, 0.97) * sqrt(bright), foam), paint.a + g + foam);
}`,
};

/// Sand with the grid of 100 m: 400 m a period.
function sandImage() {
    const n = 512, noise = sampler(), sand = SAND.toArray();
    return image([n, n], (i, j) => {
        const g = 0.6 * noise(4 * i / n / 4, 4 * j / n / 4) + 0.4 * noise(16 * i / n, 16 * j / n), edge = k => Math.min(k % (n / 4), n / 4 - k % (n / 4));
        const line = Math.min(edge(i), edge(j)) < 1 ? 0.3 : 0;
        return mix(sand.map(v => v * (0.72 + 0.45 * g)), [0.95, 0.95, 0.95], line).map(Math.sqrt);
    }, true);
}

/// Material for Seabed.
export const plainBed = {
    uniforms: () => ({sandy: {value: sandImage()}}),
    vertex: `
uniform vec3 eye, deep; uniform float depth, wet;
varying vec4 murk; varying vec2 place;
${fog}
void main() {
    vec4 w = modelMatrix * vec4(position, 1.0), mv = viewMatrix * w;
    float far = smoothstep(300.0, 2600.0, distance(eye, w.xyz)) * wet, thick = 0.25 + 0.6 * wet * (1.0 - exp(-depth / 160.0)), h = haze(-mv.z);
    murk = vec4(mix(sqrt(deep) * 1.2, sqrt(fogColor), h), 1.0 - (1.0 - thick) * (1.0 - far) * (1.0 - h));
    place = w.xy / 400.0;
    gl_Position = projectionMatrix * mv;
}`,
    fragment: `
uniform sampler2D sandy; uniform float bright; varying vec4 murk; varying vec2 place;
void main() { gl_FragColor = vec4(mix(texture2D(sandy, place).rgb * sqrt(bright), murk.rgb, murk.a), 1.0); }`,
};

/// Return the paint of bodies: lit at corners from sky and sun, shadows by one sample of their map.
export function plainPaint() {
    return new ShaderMaterial({
        lights: true, fog: true, vertexColors: true, side: DoubleSide, shadowSide: BackSide,
        uniforms: Object.assign(UniformsUtils.merge([UniformsLib.lights, UniformsLib.fog]), AIR),
        vertexShader: `
#include <common>
#include <shadowmap_pars_vertex>
uniform vec3 sun;
varying vec3 paint; varying vec2 facing; varying float away;
${fog}
void main() {
    mat4 place = modelMatrix * instanceMatrix;
    vec4 worldPosition = place * vec4(position, 1.0), mvPosition = viewMatrix * worldPosition;
    vec3 n = mat3(place) * normal, transformedNormal = mat3(viewMatrix) * n;
    facing = vec2(n.z, dot(n, sun));
    paint = sqrt(color);
    away = haze(-mvPosition.z);
    gl_Position = projectionMatrix * mvPosition;
    #include <shadowmap_vertex>
}`,
        fragmentShader: `
#include <common>
#include <bsdfs>
#include <lights_pars_begin>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
uniform vec3 lampMean, lampTilt, lampSun;
varying vec3 paint; varying vec2 facing; varying float away;
${fog.split('\n')[0]}
void main() {
    vec2 f = gl_FrontFacing ? facing : -facing;
    vec3 light = lampMean + lampTilt * f.x + lampSun * (max(f.y, 0.0) * getShadowMask());
    gl_FragColor = vec4(mix(paint * sqrt(light), sqrt(fogColor), away), 1.0);
}`,
    });
}
