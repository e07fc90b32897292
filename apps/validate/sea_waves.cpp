// SPDX-License-Identifier: Apache-2.0
// Waves and wind without a world.
#include "validate/sea.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <cmath>

namespace hawser::validate {
namespace {

constexpr int kSeedCount = 20;
constexpr double kRecordSeconds = 3.0 * 3600.0,
                 kEvery = 0.5;  ///< Length and interval of records [s].

/// Statistics of one record of the elevation at a point.
struct Record {
    double deviation = 0.0;  ///< σ [m].
    double period = 0.0;     ///< Mean time between upward crossings of 0 [s].
    double kurtosis = 0.0;
};

Record record_waves(const Sea& sea) {
    double sums[5] = {}, before = 0.0, first = -1.0, last = -1.0;
    int crossings = 0;
    const long count = std::lround(kRecordSeconds / kEvery);
    SeaMoment now;
    for (long i = 0; i < count; ++i) {
        sea.at(kEvery * static_cast<double>(i), sea.inputs(), now);
        const double z = sea.elevation(now, 0.0, 0.0);
        double power = 1.0;
        for (double& sum : sums) {
            sum += power;
            power *= z;
        }
        if (i > 0 && before <= 0.0 && z > 0.0) {
            last = kEvery * (static_cast<double>(i) - z / (z - before));
            if (first < 0.0) first = last;
            ++crossings;
        }
        before = z;
    }
    for (double& sum : sums) sum /= static_cast<double>(count);
    const double m = sums[1], variance = sums[2] - m * m;
    const double fourth = sums[4] - 4 * m * sums[3] + 6 * m * m * sums[2] - 3 * m * m * m * m;
    return {std::sqrt(variance), (last - first) / (crossings - 1), fourth / (variance * variance)};
}

/// Return Tz = 2π √(m₀/m₂) of the components.
double crossing_period(const Sea& sea) {
    double m0 = 0.0, m2 = 0.0;
    for (const WaveComponent& w : sea.components()) {
        m0 += w.amplitude * w.amplitude;
        m2 += w.amplitude * w.amplitude * w.frequency * w.frequency;
    }
    return 2.0 * kPi * std::sqrt(m0 / m2);
}

}  // namespace

void case_sea_waves(Report& report) {
    const double omega = 2.0 * kPi / 9.0;
    report.compare("length of 9 s in 150 m [m]", {126.466}, {2.0 * kPi / wave_number(omega, 150.0)},
                   5e-4, "the reference has six digits", 1.0);
    report.compare("length of 9 s in 15 m [m]", {95.572}, {2.0 * kPi / wave_number(omega, 15.0)},
                   5e-4, "the reference has five digits", 1.0);
}

void case_sea_statistics(Report& report) {
    double height = 0.0, kurtosis = 0.0, period = 0.0;
    for (int seed = 1; seed <= kSeedCount; ++seed) {
        SeaDef def{.depth = 150.0};
        def.waves.push_back({.kind = WaveKind::jonswap,
                             .height = 3.0,
                             .period = 9.0,
                             .seed = static_cast<std::uint64_t>(seed)});
        const Sea sea(def);
        const Record record = record_waves(sea);
        height += 4.0 * record.deviation / kSeedCount;
        kurtosis += record.kurtosis / kSeedCount;
        period += record.period / crossing_period(sea) / kSeedCount;
    }
    report.compare("JONSWAP, Hs 3 m, Tp 9 s: 4 sigma, mean of 20 seeds and 3 h [m]", {3.0},
                   {height}, 5e-3, "0.5 %; a record has some 1,500 waves", 3.0);
    report.compare("mean period of crossings over that of the components", {1.0}, {period}, 0.02,
                   "2 %", 1.0);
    report.compare("kurtosis, mean", {3.0}, {kurtosis}, 0.1, "of a Gaussian process", 1.0);
    for (const double speed : {10.0, 20.0}) {
        SeaDef def{.depth = 150.0};
        def.wind = {.speed = speed, .gusts = true};
        double sum = 0.0;
        const Sea sea(def);
        for (const GustComponent& g : sea.gusts())
            sum += g.width * gust_spectrum(speed, g.frequency);
        report.compare(fmt::format("NPD gusts of {:.0f} m/s, 1/600 to 0.5 Hz: sigma [m/s]", speed),
                       {speed == 10.0 ? 0.872 : 2.28}, {std::sqrt(sum)}, 0.01,
                       "1 %; one frequency a bin");
    }
}

}  // namespace hawser::validate
