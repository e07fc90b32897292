// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file series.h
/// Curves over time taken from a recording.

#include <hawser/recording.h>

#include <array>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace hawser::record {

inline constexpr double kDegrees = 180.0 / std::numbers::pi;  ///< In one radian.

/// Roll, pitch and yaw [rad]: rotation about x, then y, then z of the world.
[[nodiscard]] Vec3 euler_angles(const Quat& q);

/// Tension in a cable, or in a piece that was cut off it, whatever nodes have come and gone; NaN in
/// frames in which there is none.
struct CableSeries {
    std::int32_t cable = 0;                   ///< Of a piece: that which it was cut off.
    std::string name{};                       ///< Of the piece, as "tow/2".
    std::vector<double> first{}, last{};      ///< Tension at both ends [N].
    std::vector<double> lowest{}, highest{};  ///< Over the elements there are [N].
    double peak = 0.0;                        ///< Largest of `highest` [N].
};

struct BodySeries {
    std::int32_t body = 0;
    bool turns = false;                          ///< Has an orientation.
    std::array<std::vector<double>, 6> value{};  ///< Position, then roll, pitch, yaw, from the
                                                 ///< start [m, deg].
};

struct Series {
    std::vector<double> time;        ///< [s]
    std::vector<std::size_t> takes;  ///< Places at which the run went to another state of its own.
    std::vector<CableSeries> cables;
    std::vector<BodySeries> bodies;
};

/// The cables and bodies that the scene wants plotted; without such a wish the cables under
/// most tension and the rigid bodies, at most `limit` of each.
[[nodiscard]] Series collect_series(const Recording& recording, std::size_t limit = 12);

/// Stretches [begin, end) in which a curve is one line: it breaks where the run went to another
/// state, and where there is no value.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> stretches(
    const Series& series, const std::vector<double>& values);

/// One line with step, form, duration, hash, instruction set and version.
[[nodiscard]] std::string parameter_line(const Recording& recording);

}  // namespace hawser::record
