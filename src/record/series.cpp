// SPDX-License-Identifier: Apache-2.0
#include "record/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

namespace hawser::record {

namespace {

std::vector<std::int32_t> chosen_bodies(const Recording& recording, std::size_t limit) {
    if (!recording.plot_bodies.empty()) return recording.plot_bodies;
    const std::vector<bool> interior = cable_interior(recording);
    std::vector<std::int32_t> out;
    const auto take = [&](auto wanted) {
        for (std::size_t i = 0; i < recording.bodies.size() && out.size() < limit; ++i)
            if (!interior[i] && wanted(recording.bodies[i].kind))
                out.push_back(static_cast<std::int32_t>(i));
    };
    take([](BodyKind k) { return k == BodyKind::rigid; });
    if (out.empty()) take([](BodyKind k) { return k != BodyKind::fixed; });
    return out;
}

/// Return the tensions of the elements of a wire in a frame. If no element was added or removed,
/// these are the elements of the start.
std::span<const float> element_tensions(const Recording& recording, const CableSeries& s,
                                        const Frame& frame) {
    if (frame.wires != nullptr)
        for (const RecordedWire& wire : *frame.wires)
            if (wire.name == s.name)
                return std::span(frame.pulls).subspan(wire.first_piece, wire.pieces.size());
    const RecordedCable& cable = recording.cables[static_cast<std::size_t>(s.cable)];
    if (cable.name != s.name) return {};
    return std::span(frame.tensions)
        .subspan(static_cast<std::size_t>(cable.first_element),
                 static_cast<std::size_t>(cable.elements));
}

void append(CableSeries& s, const Recording& recording, const Frame& frame) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const std::span<const float> pulls = element_tensions(recording, s, frame);
    const bool none = pulls.empty();
    const auto put = [&](std::vector<double>& to, float value) {  // a broken element has −1
        to.push_back(none ? kNone : std::max(0.0, static_cast<double>(value)));
    };
    put(s.first, none ? 0.0F : pulls.front());
    put(s.last, none ? 0.0F : pulls.back());
    put(s.lowest, none ? 0.0F : *std::min_element(pulls.begin(), pulls.end()));
    put(s.highest, none ? 0.0F : *std::max_element(pulls.begin(), pulls.end()));
    if (!none) s.peak = std::max(s.peak, s.highest.back());
}

/// Add the pieces that were cut off cables since the previous frames.
void add_pieces(Series& series, const Recording& recording, const Frame& frame) {
    if (frame.wires == nullptr) return;
    for (const RecordedWire& wire : *frame.wires) {
        const auto named = [&](const CableSeries& s) { return s.name == wire.name; };
        if (std::any_of(series.cables.begin(), series.cables.end(), named)) continue;
        const std::string_view of = std::string_view(wire.name).substr(0, wire.name.rfind('/'));
        const auto whole =
            std::find_if(series.cables.begin(), series.cables.end(), [&](const CableSeries& s) {
                return s.name == of &&
                       recording.cables[static_cast<std::size_t>(s.cable)].name == of;
            });
        if (whole == series.cables.end() || of == wire.name) continue;
        CableSeries piece{.cable = whole->cable, .name = wire.name};
        const std::vector<double> none(series.time.size(),
                                       std::numeric_limits<double>::quiet_NaN());
        piece.first = piece.last = piece.lowest = piece.highest = none;
        series.cables.push_back(std::move(piece));
    }
}

// Append an angle, without the jump by a whole turn at ±180° [deg].
void append_angle(std::vector<double>& values, double angle) {
    const double before = values.empty() ? 0.0 : values.back();
    angle -= 360.0 * std::round((angle - before) / 360.0);
    values.push_back(angle);
}

void append(BodySeries& s, const Recording& recording, const Frame& frame) {
    const auto index = static_cast<std::size_t>(s.body);
    const Pose& pose = frame.poses[index];
    const Vec3 moved = pose.position - recording.bodies[index].start.position;
    for (int k = 0; k < 3; ++k) s.value[std::size_t(k)].push_back(moved[k]);
    if (!s.turns) return;
    const Vec3 angles = euler_angles(pose.orientation.normalized());
    const Vec3 first = euler_angles(recording.bodies[index].start.orientation.normalized());
    for (int k = 0; k < 3; ++k)
        append_angle(s.value[3 + std::size_t(k)], kDegrees * (angles[k] - first[k]));
}

}  // namespace

Vec3 euler_angles(const Quat& q) {
    const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
    return {std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
            std::asin(std::clamp(2 * (w * y - z * x), -1.0, 1.0)),
            std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))};
}

Series collect_series(const Recording& recording, std::size_t limit) {
    Series series;
    std::vector<std::int32_t> cables = recording.plot_cables;
    const bool all = cables.empty();
    for (std::size_t i = 0; all && i < recording.cables.size(); ++i)
        cables.push_back(static_cast<std::int32_t>(i));
    for (const std::int32_t cable : cables)
        if (recording.cables[static_cast<std::size_t>(cable)].elements > 0)
            series.cables.push_back(
                {.cable = cable, .name = recording.cables[static_cast<std::size_t>(cable)].name});
    for (const std::int32_t body : chosen_bodies(recording, limit)) {
        const BodyKind kind = recording.bodies[static_cast<std::size_t>(body)].kind;
        series.bodies.push_back(
            {.body = body, .turns = kind == BodyKind::rigid || kind == BodyKind::kinematic});
    }
    for (std::size_t i = 0; i < recording.frame_count(); ++i) {
        Frame frame = recording.frame(i);
        // Tensions are unknown before the first step: the curves begin with those of the next
        // frame.
        if (i == 0 && frame.step == 0 && recording.frame_count() > 1) {
            const Frame next = recording.frame(1);
            frame.tensions = next.tensions;
            frame.wires = next.wires;
            frame.pulls = next.pulls;
        }
        add_pieces(series, recording, frame);
        series.time.push_back(frame.time);
        for (CableSeries& s : series.cables) append(s, recording, frame);
        for (BodySeries& s : series.bodies) append(s, recording, frame);
    }
    for (const RecordedTake& take : recording.takes) series.takes.push_back(take.frames);
    if (all && series.cables.size() > limit) {
        std::stable_sort(series.cables.begin(), series.cables.end(),
                         [](const auto& a, const auto& b) { return a.peak > b.peak; });
        series.cables.resize(limit);
    }
    return series;
}

std::vector<std::pair<std::size_t, std::size_t>> continuous_intervals(
    const Series& series, const std::vector<double>& values) {
    std::vector<std::pair<std::size_t, std::size_t>> out;
    bool open = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool is_finite = std::isfinite(values[i]);
        const bool other =
            std::find(series.takes.begin(), series.takes.end(), i) != series.takes.end();
        if (is_finite && (!open || other)) out.emplace_back(i, i);
        if (is_finite) out.back().second = i + 1;
        open = is_finite;
    }
    return out;
}

std::string parameter_line(const Recording& recording) {
    static constexpr const char* kFormNames[] = {"automatic", "saddle", "condensed"};
    const std::size_t n = recording.frame_count();
    const double from = n > 0 ? recording.frame_head(0).time : 0.0;
    const double to = n > 0 ? recording.frame_head(n - 1).time : 0.0;
    return fmt::format(
        "step h = {:.6g} ms  ·  form {}  ·  {:.6g} s to {:.6g} s, {} frames  ·  scene hash "
        "{:016x}  ·  {}  ·  Hawser {}",
        1e3 * recording.settings.step, kFormNames[static_cast<int>(recording.settings.form)], from,
        to, n, recording.scene_hash, recording.settings.instruction_set,
        recording.settings.version);
}

}  // namespace hawser::record
