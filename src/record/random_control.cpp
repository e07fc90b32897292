// SPDX-License-Identifier: Apache-2.0
#include "record/random_control.h"

#include "base/hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <random>
#include <vector>

namespace hawser::record {

namespace {

constexpr double kRampFraction = 0.4;
constexpr double kLimitFraction = 0.3;
constexpr double kRestFraction = 0.2;

/// Random values of one input, by line of the file. Lines are counted in intervals from time 0.
class RandomSequence {
  public:
    RandomSequence(const RandomInput& input, const RandomControlDef& def)
        : input_(input),
          def_(def),
          random_(base::fnv1a(input.name.data(), input.name.size(),
                              base::fnv1a(&def.seed, sizeof def.seed))) {}

    [[nodiscard]] std::map<std::int64_t, double> values() {
        std::map<std::int64_t, double> out;
        double value = clamp(input_.start);
        out[0] = value;
        for (double time = pause(); time < def_.duration; time += pause()) {
            const double target = next_target();
            const bool ramp = uniform() < kRampFraction && !input_.whole;
            const double length = ramp ? def_.period * (0.2 + 0.8 * uniform()) : 0.0;
            const std::int64_t first = line(time), count = line(length);
            for (std::int64_t k = 0; k <= count; ++k) {
                const double share =
                    count == 0 ? 1.0 : static_cast<double>(k) / static_cast<double>(count);
                if (static_cast<double>(first + k) * def_.interval < def_.duration)
                    out[first + k] = value + share * (target - value);
            }
            value = target;
            time += length;
        }
        return out;
    }

  private:
    [[nodiscard]] double clamp(double value) const {
        value = std::clamp(value, input_.min, input_.max);
        return input_.whole ? std::round(value) : value;
    }
    /// Return a random number in [0, 1). std::uniform_real_distribution differs between libraries.
    [[nodiscard]] double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    [[nodiscard]] double pause() { return def_.period * (0.25 + 1.5 * uniform()); }
    [[nodiscard]] std::int64_t line(double time) const {
        return static_cast<std::int64_t>(std::ceil(time / def_.interval));
    }
    [[nodiscard]] double next_target() {
        const double choice = uniform(), u = uniform();
        if (input_.whole) {
            const double low = std::ceil(input_.min), high = std::floor(input_.max);
            return std::min(high, low + std::floor(u * (high - low + 1.0)));
        }
        if (choice < kLimitFraction) return u < 0.5 ? input_.min : input_.max;
        if (choice < kLimitFraction + kRestFraction) return clamp(input_.rest);
        return input_.min + u * (input_.max - input_.min);
    }

    const RandomInput& input_;
    const RandomControlDef& def_;
    std::mt19937_64 random_;
};

/// Format a number with six digits, or with all digits if rounding leaves the range.
std::string number(double value, const RandomInput& input) {
    std::string text = fmt::format("{:.6g}", value);
    const double rounded = std::strtod(text.c_str(), nullptr);
    return rounded >= input.min && rounded <= input.max ? text : fmt::format("{}", value);
}

}  // namespace

std::string random_control(std::span<const RandomInput> inputs, const RandomControlDef& def) {
    std::map<std::int64_t, std::vector<std::string>> lines;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (const auto& [line, value] : RandomSequence(inputs[i], def).values()) {
            auto& fields = lines[line];
            fields.resize(inputs.size());
            fields[i] = number(value, inputs[i]);
        }
    std::string text = "time";
    for (const RandomInput& input : inputs) text += "," + input.name;
    text += '\n';
    for (const auto& [line, fields] : lines)
        fmt::format_to(std::back_inserter(text), "{:.9g},{}\n",
                       static_cast<double>(line) * def.interval, fmt::join(fields, ","));
    return text;
}

}  // namespace hawser::record
