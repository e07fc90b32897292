// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file series.h
/// Curves over time taken from a recording.

#include <hawser/recording.h>

#include <array>
#include <numbers>
#include <vector>

namespace hawser::record {

inline constexpr double kDegrees = 180.0 / std::numbers::pi;  ///< In one radian.

/// Roll, pitch and yaw [rad]: rotation about x, then y, then z of the world.
[[nodiscard]] Vec3 euler_angles(const Quat& q);

struct CableSeries {
    std::int32_t cable = 0;
    std::vector<double> first{}, last{};      ///< Tension at both ends [N].
    std::vector<double> lowest{}, highest{};  ///< Over the cable's elements [N].
    double peak = 0.0;                        ///< Largest of `highest` [N].
};

struct BodySeries {
    std::int32_t body = 0;
    bool turns = false;                          ///< Has an orientation.
    std::array<std::vector<double>, 6> value{};  ///< Position, then roll, pitch, yaw, from the
                                                 ///< start [m, deg].
};

struct Series {
    std::vector<double> time;  ///< [s]
    std::vector<CableSeries> cables;
    std::vector<BodySeries> bodies;
};

/// The cables and bodies that the scene wants plotted; without such a wish the cables under
/// most tension and the rigid bodies, at most `limit` of each.
[[nodiscard]] Series collect_series(const Recording& recording, std::size_t limit = 12);

/// One line with step, form, duration, hash, instruction set and version.
[[nodiscard]] std::string parameter_line(const Recording& recording);

}  // namespace hawser::record
