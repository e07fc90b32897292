// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file space.h
/// Draw a frame of a recording in space. Layers from far to near: seabed; objects under water; the
/// translucent water; objects above water. Each layer consists of solids in painting order, then
/// the parts of lines that no solid hides (solids_view.h).

#include "draw/plots.h"
#include "draw/projection.h"
#include "draw/solids_view.h"
#include "draw/water.h"

#include <vector>

namespace hawser::draw {

/// Positions in the picture [points].
inline constexpr double kSpaceWidth = 1280, kSpaceHeight = 860, kSpaceTop = 92, kSpaceBelow = 64,
                        kSpaceLeft = 54, kScaleRoom = 130;

/// Builder of one picture.
class Space {
  public:
    /// Start a picture. @param bounds  Corners of the visible box; objects outside are left out.
    Space(const record::Recording& recording, const record::Frame& frame,
          const ViewOptions& options, const Bounds& bounds);
    Drawing draw(const record::Series& series);

  private:
    void widen_box(bool given);
    [[nodiscard]] std::vector<Vec3> corners() const;
    void fit(const ViewOptions& options);
    void gather();
    [[nodiscard]] Point at(const Vec3& p) const;
    /// True if a point lies in the visible box.
    [[nodiscard]] bool inside(const Vec3& p) const;

    void polygon(const std::vector<Vec3>& points, Color fill, Color stroke, double width);
    void broken_line(const Vec3& from, const Vec3& to, Color color, double width);
    void draw_level(double z, Color fill, Color line, bool numbers);
    void draw_number(int k, double value, double every, double z);
    void draw_grounds_lines();
    void draw_layer(double level, bool above);
    static bool clip(Vec3& from, Vec3& to, double level, bool above);
    void draw_dot(const Vec3& p);
    void draw_wires(double level, bool above);
    void draw_cross(const Vec3& end);
    void draw_joints(double level, bool above);
    void draw_paths(const record::Series& series);

    void draw_heights();
    void draw_names();
    void draw_frame();

    const record::Recording& recording_;
    const record::Frame& frame_;
    Camera camera_;
    Water water_;
    Bounds box_;
    Range tension_;
    Drawing drawing_;
    double scale_ = 1.0;  ///< [points/m]
    Point shift_;
    std::vector<Solid> solids_;
    std::vector<Vec3> dots_;  ///< Positions of bodies without a size.
};

}  // namespace hawser::draw
