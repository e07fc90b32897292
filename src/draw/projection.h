// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file projection.h
/// Project boxes, cables and joints of a recorded frame onto a panel.

#include <hawser/recording.h>
#include "draw/axes.h"

#include <string>
#include <vector>

namespace hawser::draw {

/// Direction of view along an axis of the world.
struct View {
    int right = 0, up = 2;  ///< World axes (0-2) drawn to the right and upwards.
    double up_sign = 1.0;   ///< −1: the axis drawn upwards is the negative one.
    std::string title;

    [[nodiscard]] Vec3 towards_viewer() const {
        return Vec3::Unit(right).cross(up_sign * Vec3::Unit(up));
    }
};

/// Corners of the box that contains all drawn parts of a frame [m].
struct Bounds {
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
    void add(const Vec3& p) {
        if (p.allFinite()) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    }
    [[nodiscard]] bool empty() const { return (low.array() > high.array()).any(); }
};

/// True if a joint of Recording::joints has been removed by the time of the frame.
[[nodiscard]] bool is_removed(const record::Frame& frame, std::size_t joint);

/// Return the bodies that a picture draws: bodies with a size, and points that are no nodes of a
/// cable. The world itself is excluded, and so are drums, which have no position.
[[nodiscard]] std::vector<bool> visible_bodies(const record::Recording& recording);

void add_to_bounds(const record::Recording& recording, const record::Frame& frame, Bounds& bounds);

struct FrameStyle {
    bool ghost = false;  ///< Pale grey drawing of an earlier state.
    Range tension;       ///< Range of tension for the colours [N].
};

/// Paint bodies, joints and cables of a frame.
void draw_frame(Drawing& drawing, const Axes& axes, const View& view,
                const record::Recording& recording, const record::Frame& frame,
                const FrameStyle& style);

[[nodiscard]] Point project(const Axes& axes, const View& view, const Vec3& p);

/// Return the box that a body covers in a panel [points].
[[nodiscard]] Box body_extent(const Axes& axes, const View& view, const record::RecordedBody& body,
                              const Pose& pose);

}  // namespace hawser::draw
