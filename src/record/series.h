// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file series.h
/// Collect curves over time from a recording.

#include <hawser/recording.h>

#include <array>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace hawser::record {

inline constexpr double kDegrees = 180.0 / std::numbers::pi;  ///< Degrees in one radian.

/// Return roll, pitch and yaw [rad]: rotation about x, then y, then z of the world.
[[nodiscard]] Vec3 euler_angles(const Quat& q);

/// Tension in a cable, or in a piece that was cut off it, also if nodes were added or removed. NaN
/// in frames in which the piece does not exist.
struct CableSeries {
    std::int32_t cable =
        0;               ///< Index of the cable; for a piece, of the cable from which it was cut.
    std::string name{};  ///< Name of the piece, as "tow/2".
    std::vector<double> first{}, last{};      ///< Tension at both ends [N].
    std::vector<double> lowest{}, highest{};  ///< Least and largest tension over the elements [N].
    double peak = 0.0;                        ///< Largest of `highest` [N].
};

struct BodySeries {
    std::int32_t body = 0;
    bool turns = false;  ///< True if the body has an orientation.
    std::array<std::vector<double>, 6>
        value{};  ///< Position, then roll, pitch, yaw, relative to the start [m, deg].
};

struct Series {
    std::vector<double> time;  ///< Time of each frame [s].
    std::vector<std::size_t>
        takes;  ///< Indices of the frames at which the run restored one of its own states.
    std::vector<CableSeries> cables;
    std::vector<BodySeries> bodies;
};

/// Collect the curves of the cables and bodies that the scene plots. If the scene plots none, use
/// the cables with the largest tensions and the rigid bodies, at most `limit` of each.
[[nodiscard]] Series collect_series(const Recording& recording, std::size_t limit = 12);

/// Return the intervals [begin, end) in which a curve is continuous. It breaks at a restored state
/// and at a frame without value.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> continuous_intervals(
    const Series& series, const std::vector<double>& values);

/// Return one line with step, form, duration, hash, instruction set and version.
[[nodiscard]] std::string parameter_line(const Recording& recording);

}  // namespace hawser::record
