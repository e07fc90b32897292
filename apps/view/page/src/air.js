// SPDX-License-Identifier: Apache-2.0
/// Light and visibility: colours of sky and sea, direction and strength of sun and lamps, fog. All
/// shaders share these objects, so that a change needs no new material.
import {Color, Vector3} from 'three';

export const HORIZON = new Color(0xc3d5e0), ZENITH = new Color(0x3f7fc0), DEEP = new Color(0x0b3550), SAND = new Color(0xb7a583), CLOUD = new Color(0.95, 0.97, 0.98);
export const SUN = new Vector3(0.55, -0.5, 0.62).normalize();
/// Colour and strength of the lamps: the sky, the reflection of the ground, the sun.
export const LAMPS = {sky: new Color(0xe4f0f8), ground: new Color(0x64727a), around: 2.3, sun: new Color(0xfff2dc), straight: 2.5};

/// Direction of the sun without one of the scene [rad].
export const kSun = {azimuth: Math.atan2(-0.5, 0.55), elevation: Math.asin(0.62 / Math.hypot(0.55, 0.5, 0.62))};
/// Colours by time of day. Ships have their deck lights on at night, so that lamps stay brighter than
/// the sea. `bright`: light of the sea and of clouds compared with the day.
export const kLights = {
    day: {horizon: 0xc3d5e0, zenith: 0x3f7fc0, deep: 0x0b3550, sky: 0xe4f0f8, around: 2.3, sun: 0xfff2dc, straight: 2.5, bright: 1, elevation: kSun.elevation},
    dusk: {horizon: 0xe2a97c, zenith: 0x3a5480, deep: 0x0a2233, sky: 0xb7bfd4, around: 1.5, sun: 0xffb47a, straight: 1.6, bright: 0.5, elevation: 0.09},
    night: {horizon: 0x111a26, zenith: 0x060b16, deep: 0x02080f, sky: 0xcfd6e4, around: 0.85, sun: 0x9fb4d0, straight: 0.35, bright: 0.07, elevation: 0.7},
};
export const kClear = 9000;   // [m] visibility that is drawn as clear air

/// Uniforms of shaders, by reference.
export const AIR = {
    horizon: {value: HORIZON}, zenith: {value: ZENITH}, deep: {value: DEEP}, sun: {value: SUN}, cloudy: {value: CLOUD}, bright: {value: 1},
    lampMean: {value: new Color()}, lampTilt: {value: new Color()}, lampSun: {value: new Color()},
};
export const air = {light: 'day', visibility: kClear, azimuth: kSun.azimuth, elevation: null, version: 0};

/// Fractions of a fog: limits of the haze [m] and the fraction by which the sky takes the colour of the
/// horizon.
export function fogOf(visibility) {
    const v = Math.max(50, Math.min(kClear, visibility || kClear));
    return {near: v < kClear ? 0.02 * v : 500, far: v, veil: v < kClear ? Math.min(1, Math.max(0, 1.15 - v / 5000)) : 0};
}

/// Set light and visibility. @param elevation  Of the sun [rad]; null: that of the time of day.
/// @param azimuth  Direction to the sun from x towards y [rad].
export function setAir(change = {}) {
    Object.assign(air, change);
    const p = kLights[air.light] ?? kLights.day, {veil} = fogOf(air.visibility), e = air.elevation ?? p.elevation;
    HORIZON.set(p.horizon);
    if (veil > 0) HORIZON.lerp(new Color(0xb4bdc2).multiplyScalar(Math.max(0.04, p.bright)), 0.8 * veil);
    ZENITH.set(p.zenith).lerp(HORIZON, veil);
    DEEP.set(p.deep);
    CLOUD.setRGB(0.95, 0.97, 0.98).multiplyScalar(0.15 * p.bright + 0.85 * p.bright ** 0.7).lerp(HORIZON, veil);
    SUN.set(Math.cos(e) * Math.cos(air.azimuth), Math.cos(e) * Math.sin(air.azimuth), Math.sin(e));
    LAMPS.sky.set(p.sky);
    LAMPS.around = p.around;
    LAMPS.sun.set(p.sun);
    LAMPS.straight = p.straight * (1 - veil);
    AIR.bright.value = p.bright;
    const lamp = (out, f) => out.setRGB(...LAMPS.sky.toArray().map((v, k) => f(v, LAMPS.ground.toArray()[k]) * LAMPS.around / Math.PI));
    lamp(AIR.lampMean.value, (a, b) => (a + b) / 2);
    lamp(AIR.lampTilt.value, (a, b) => (a - b) / 2);
    AIR.lampSun.value.copy(LAMPS.sun).multiplyScalar(LAMPS.straight / Math.PI);
    ++air.version;
}
setAir();

/// Fraction of the sea that whitecaps cover at a wind [m/s] at 10 m (E. C. Monahan and I. Ó Muircheartaigh,
/// 1980).
export const whitecaps = wind => Math.min(0.2, 3.84e-6 * Math.max(0, wind) ** 3.41);

/// Return the value that a normal variable of deviation 1 exceeds with a probability below ½
/// (Abramowitz and Stegun 26.2.23, error 4.5e-4).
export function exceeded(probability) {
    const t = Math.sqrt(-2 * Math.log(Math.min(0.5, Math.max(1e-12, probability))));
    return t - (2.515517 + 0.802853 * t + 0.010328 * t * t) / (1 + 1.432788 * t + 0.189269 * t * t + 0.001308 * t ** 3);
}
