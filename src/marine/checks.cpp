// SPDX-License-Identifier: Apache-2.0
#include "marine/checks.h"

#include "marine/spectra.h"

namespace hawser::marine {
namespace {

constexpr double kMaxAngle = 1e3;  ///< Limit of a direction or phase [rad].

/// Reject a wave steep enough to break: H > 0.142 λ tanh kd (R. Miche, "Mouvements ondulatoires de
/// la mer en profondeur constante ou décroissante", 1944).
void check_steepness(const std::string& at, const WaveDef& wave, double depth, double gravity) {
    const double k = wave_number(kTwoPi / wave.period, depth, gravity);
    const double highest = 0.142 * kTwoPi / k * std::tanh(k * depth);
    if (wave.height > highest)
        throw SeaError(at + "/height", number(wave.height) + " m; in water of " + number(depth) +
                                           " m a wave of " + number(wave.period) +
                                           " s breaks above " + number(highest) + " m");
}

void check_wave(const std::string& at, const WaveDef& wave, double depth, double gravity) {
    check_range(at + "/height", wave.height, 0.0, 100.0, true, "m");
    check_range(at + "/period", wave.period, 0.0, 1e4, true, "s");
    check_range(at + "/direction", wave.direction, -kMaxAngle, kMaxAngle, false, "rad");
    if (wave.kind == WaveKind::regular) {
        check_range(at + "/phase", wave.phase, -kMaxAngle, kMaxAngle, false, "rad");
        return check_steepness(at, wave, depth, gravity);
    }
    check_range(at + "/gamma", wave.gamma, 1.0, 20.0, false, "");
    check_range(at + "/spreading", wave.spreading, 0.0, 200.0, false, "");
    check_range(at + "/components", wave.components, 1.0, kMaxWaveComponents, false, "");
    check_range(at + "/lowest", wave.lowest, 0.0, 1.0, true, "");
    check_range(at + "/highest", wave.highest, 1.0, 20.0, true, "");
}

void check_tables(const SeaDef& def) {
    for (std::size_t i = 0; i < def.level.size(); ++i) {
        const SeaLevel& l = def.level[i];
        const std::string at = entry("level", i);
        check_range(at + "/time", l.time, -1e12, 1e12, false, "s");
        check_range(at + "/level", l.level, -def.depth, 1e3, true, "m");
        if (i > 0 && !(l.time > def.level[i - 1].time))
            throw SeaError(at + "/time", number(l.time) + " s; times have to ascend");
    }
    for (std::size_t i = 0; i < def.current.size(); ++i) {
        const SeaCurrent& c = def.current[i];
        const std::string at = entry("current", i);
        check_range(at + "/depth", c.depth, 0.0, 1e5, false, "m");
        check_range(at + "/speed", c.speed, 0.0, 50.0, false, "m/s");
        check_range(at + "/direction", c.direction, -kMaxAngle, kMaxAngle, false, "rad");
        if (i > 0 && !(c.depth > def.current[i - 1].depth))
            throw SeaError(at + "/depth", number(c.depth) + " m; depths have to ascend");
    }
}

}  // namespace

void check_line_water(const std::string& at, const LineWater& w) {
    check_range(at + "/diameter", w.diameter, 0.0, 1e3, true, "m");
    check_range(at + "/volume", w.volume, 0.0, 1e6, false, "m^2");
    check_range(at + "/cd_normal", w.cd_normal, 0.0, 1e3, false, "");
    check_range(at + "/cd_tangential", w.cd_tangential, 0.0, 1e3, false, "");
    check_range(at + "/ca_normal", w.ca_normal, 0.0, 1e3, false, "");
    check_range(at + "/ca_tangential", w.ca_tangential, 0.0, 1e3, false, "");
}

void check_sea(const SeaDef& def, double gravity) {
    check_range("gravity", gravity, 0.0, 1e3, true, "m/s^2");
    check_range("depth", def.depth, 0.0, 1e5, true, "m");
    check_range("density", def.density, 0.0, 1e5, true, "kg/m^3");
    check_tables(def);
    int components = 0;
    for (std::size_t i = 0; i < def.waves.size(); ++i) {
        const WaveDef& wave = def.waves[i];
        check_wave(entry("waves", i), wave, def.depth, gravity);
        components += wave.kind == WaveKind::regular ? 1 : wave.components;
    }
    if (components > kMaxWaveComponents)
        throw SeaError("waves", std::to_string(components) + " components together; give up to " +
                                    std::to_string(kMaxWaveComponents));
    const WindDef& wind = def.wind;
    check_range("wind/speed", wind.speed, 0.0, 100.0, false, "m/s");
    check_range("wind/direction", wind.direction, -kMaxAngle, kMaxAngle, false, "rad");
    check_range("wind/components", wind.components, 1.0, kMaxWaveComponents, false, "");
    check_range("wind/density", wind.density, 0.0, 1e3, true, "kg/m^3");
    for (const double x : def.gauge) check_range("gauge", x, -1e7, 1e7, false, "m");
}

}  // namespace hawser::marine
