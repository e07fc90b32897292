// SPDX-License-Identifier: Apache-2.0
#include "draw/projection.h"

#include "draw/parted.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::draw {

namespace {

constexpr Color kGhostColor{205, 210, 216, 255};
constexpr Color kBodyLine{52, 62, 74, 255};

bool has_size(const record::RecordedBody& body) { return body.half_size.maxCoeff() > 0.0; }

std::array<Vec3, 8> corners(const record::RecordedBody& body, const Pose& pose) {
    std::array<Vec3, 8> out;
    const Mat3 r = pose.orientation.normalized().toRotationMatrix();
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3 sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
        out[i] = pose.position + r * sign.cwiseProduct(body.half_size);
    }
    return out;
}

// Draw the visible faces of a box. Faces perpendicular to the line of sight are lighter.
void draw_box(Drawing& drawing, const Axes& axes, const View& view,
              const record::RecordedBody& body, const Pose& pose, bool ghost) {
    static constexpr int kBoxFaceCorners[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                  {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};
    const std::array<Vec3, 8> p = corners(body, pose);
    const Mat3 r = pose.orientation.normalized().toRotationMatrix();
    for (int face = 0; face < 6; ++face) {
        const Vec3 normal = r.col(face / 2) * (face % 2 == 0 ? -1.0 : 1.0);
        const double facing = normal.dot(view.towards_viewer());
        if (facing < 1e-3) continue;
        std::vector<Point> outline;
        for (const int corner : kBoxFaceCorners[face])
            outline.push_back(project(axes, view, p[static_cast<std::size_t>(corner)]));
        const auto light = static_cast<std::uint8_t>(150 + 70 * facing);
        const Color fill{static_cast<std::uint8_t>(light - 8), light,
                         static_cast<std::uint8_t>(light + 14), 215};
        drawing.add(Path{.points = std::move(outline),
                         .stroke = ghost ? kGhostColor : kBodyLine,
                         .width = ghost ? 0.8 : 1.2,
                         .fill = ghost ? kNoColor : fill,
                         .closed = true});
    }
}

void draw_dot(Drawing& drawing, Point at, double radius, Color color) {
    std::vector<Point> circle;
    for (int i = 0; i < 16; ++i)
        circle.push_back(
            {at.x + radius * std::cos(i * 0.392699), at.y + radius * std::sin(i * 0.392699)});
    drawing.add(Path{.points = std::move(circle), .width = 0.0, .fill = color, .closed = true});
}

/// Draw a cross at the end of a broken cable.
void draw_cross(Drawing& drawing, Point at) {
    constexpr double kPlaneHalfWidth = 5.0;
    for (const double side : {-kPlaneHalfWidth, kPlaneHalfWidth})
        drawing.line({at.x - kPlaneHalfWidth, at.y - side}, {at.x + kPlaneHalfWidth, at.y + side},
                     kBrokenColor, 2.2);
}

Vec3 position_in_frame(const record::Frame& frame, std::int32_t body, const Vec3& point) {
    const Pose& pose = frame.poses[static_cast<std::size_t>(body)];
    return pose.position + pose.orientation.normalized() * point;
}

// Draw rods between their points, and bodies as lines from their centre to joints outside their
// box.
void draw_joints(Drawing& drawing, const Axes& axes, const View& view,
                 const record::Recording& recording, const record::Frame& frame, bool ghost) {
    const Color color = ghost ? kGhostColor : kBodyLine;
    const double width = ghost ? 1.0 : 1.8;
    for (std::size_t j = 0; j < recording.joints.size(); ++j) {
        if (is_removed(frame, j)) continue;
        const record::RecordedJoint& joint = recording.joints[j];
        Point ends[2];
        bool drum = false;
        for (int k = 0; k < 2; ++k) {
            const record::RecordedBody& body =
                recording.bodies[static_cast<std::size_t>(joint.body[k])];
            drum = drum || body.kind == BodyKind::scalar;
        }
        if (drum) continue;
        for (int k = 0; k < 2; ++k) {
            const record::RecordedBody& body =
                recording.bodies[static_cast<std::size_t>(joint.body[k])];
            ends[k] = project(axes, view, position_in_frame(frame, joint.body[k], joint.point[k]));
            const bool outside =
                (joint.point[k].cwiseAbs().array() > 1.05 * body.half_size.array()).any();
            if (outside && body.kind != BodyKind::fixed)
                drawing.line(project(axes, view,
                                     frame.poses[static_cast<std::size_t>(joint.body[k])].position),
                             ends[k], color, width);
        }
        drawing.line(ends[0], ends[1], color, width);
        if (!ghost) draw_dot(drawing, ends[0], 2.4, kBodyLine);
    }
}

// Return the positions of a cable's nodes; its ends are at their attachment points. Drums have no
// position.
std::vector<Vec3> cable_points(const record::Recording& recording,
                               const record::RecordedCable& cable, const record::Frame& frame) {
    std::vector<Vec3> points;
    const std::size_t n = cable.nodes.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::int32_t node = cable.nodes[i];
        if (recording.bodies[static_cast<std::size_t>(node)].kind == BodyKind::scalar) continue;
        const Vec3 local = i == 0 ? cable.end[0] : i + 1 == n ? cable.end[1] : Vec3::Zero();
        points.push_back(position_in_frame(frame, node, local));
    }
    return points;
}

/// True if the frame contains a cable whose nodes differ from those at the start.
bool is_changed(const record::Frame& frame, const record::RecordedCable& cable) {
    return frame.wires != nullptr &&
           std::any_of(frame.wires->begin(), frame.wires->end(),
                       [&](const record::RecordedWire& w) { return w.name == cable.name; });
}

/// Draw wires with the nodes that they have in this frame. The arc on a wheel between two pieces is
/// drawn as a chord.
void draw_wires(Drawing& drawing, const Axes& axes, const View& view, const record::Frame& frame,
                const std::vector<record::RecordedWire>& wires, const std::vector<float>& pulls,
                const FrameStyle& style) {
    const auto where = [&](const record::RecordedPiece& piece, int k) {
        return project(axes, view, position_in_frame(frame, piece.body[k], piece.point[k]));
    };
    for (const record::RecordedWire& wire : wires)
        for (std::size_t i = 0; i < wire.pieces.size(); ++i) {
            const record::RecordedPiece& piece = wire.pieces[i];
            const Point from = where(piece, 0), to = where(piece, 1);
            const double pull = pulls[wire.first_piece + i];
            if (pull < 0.0 && !style.ghost) {
                for (const Point end : {from, to}) draw_cross(drawing, end);
                continue;
            }
            const Color color =
                style.ghost ? kGhostColor
                            : scale_color((pull - style.tension.low) / style.tension.span());
            drawing.line(from, to, color, style.ghost ? 1.0 : 2.2);
            const bool goes_on =
                i + 1 < wire.pieces.size() && wire.pieces[i + 1].body[0] == piece.body[1];
            if (goes_on)
                drawing.line(to, where(wire.pieces[i + 1], 0), color, style.ghost ? 1.0 : 2.2);
        }
}

void draw_cables(Drawing& drawing, const Axes& axes, const View& view,
                 const record::Recording& recording, const record::Frame& frame,
                 const FrameStyle& style) {
    const std::vector<BrokenElement> parted =
        style.ghost ? std::vector<BrokenElement>{} : broken_elements(recording, frame.time);
    if (frame.wires != nullptr)
        draw_wires(drawing, axes, view, frame, *frame.wires, frame.pulls, style);
    if (frame.lines != nullptr)
        draw_wires(drawing, axes, view, frame, *frame.lines, frame.line_pulls, style);
    for (std::size_t c = 0; c < recording.cables.size(); ++c) {
        const record::RecordedCable& cable = recording.cables[c];
        if (is_changed(frame, cable)) continue;
        std::vector<Point> points;
        const std::vector<Vec3> nodes = cable_points(recording, cable, frame);
        points.reserve(nodes.size());
        for (const Vec3& node : nodes) points.push_back(project(axes, view, node));
        if (style.ghost) {
            drawing.add(Path{.points = points, .stroke = kGhostColor, .width = 1.0});
            continue;
        }
        // A cable from a drum has one element more than drawn pieces; the last ones correspond.
        const auto pieces = static_cast<std::int32_t>(points.size()) - 1;
        for (std::int32_t i = 0; i < pieces; ++i) {
            const std::int32_t element =
                std::min(cable.elements - 1, std::max(0, cable.elements - pieces + i));
            const Point from = points[static_cast<std::size_t>(i)],
                        to = points[static_cast<std::size_t>(i) + 1];
            if (is_broken(parted, c, element)) {
                for (const Point end : {from, to}) draw_cross(drawing, end);
                continue;
            }
            const double tension =
                cable.elements > 0 ? frame.tensions[static_cast<std::size_t>(cable.first_element) +
                                                    static_cast<std::size_t>(element)]
                                   : 0.0;
            drawing.line(from, to,
                         scale_color((tension - style.tension.low) / style.tension.span()), 2.2);
        }
    }
}

}  // namespace

Point project(const Axes& axes, const View& view, const Vec3& p) {
    return axes.at(p[view.right], p[view.up]);
}

bool is_removed(const record::Frame& frame, std::size_t joint) {
    return frame.gone_joints != nullptr &&
           std::find(frame.gone_joints->begin(), frame.gone_joints->end(),
                     static_cast<std::int32_t>(joint)) != frame.gone_joints->end();
}

std::vector<bool> visible_bodies(const record::Recording& recording) {
    std::vector<bool> node = recording.wire_lumps(), visible(recording.bodies.size());
    for (const record::RecordedCable& cable : recording.cables)
        for (const std::int32_t body : cable.nodes) node[static_cast<std::size_t>(body)] = true;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        const record::RecordedBody& body = recording.bodies[i];
        visible[i] = body.kind != BodyKind::scalar &&
                     (has_size(body) || (!node[i] && body.kind != BodyKind::fixed));
    }
    return visible;
}

void add_to_bounds(const record::Recording& recording, const record::Frame& frame, Bounds& bounds) {
    const std::vector<bool> visible = visible_bodies(recording);
    for (std::size_t i = 0; i < recording.bodies.size(); ++i)
        if (visible[i])
            for (const Vec3& corner : corners(recording.bodies[i], frame.poses[i]))
                bounds.add(corner);
    for (const record::RecordedCable& cable : recording.cables)
        if (!is_changed(frame, cable))
            for (const Vec3& point : cable_points(recording, cable, frame)) bounds.add(point);
    for (const auto* wires : {frame.wires, frame.lines}) {
        if (wires == nullptr) continue;
        for (const record::RecordedWire& wire : *wires)
            for (const record::RecordedPiece& piece : wire.pieces)
                for (int k = 0; k < 2; ++k)
                    bounds.add(position_in_frame(frame, piece.body[k], piece.point[k]));
    }
    for (const record::RecordedJoint& joint : recording.joints)
        for (int k = 0; k < 2; ++k)
            if (recording.bodies[static_cast<std::size_t>(joint.body[k])].kind != BodyKind::scalar)
                bounds.add(position_in_frame(frame, joint.body[k], joint.point[k]));
}

void draw_frame(Drawing& drawing, const Axes& axes, const View& view,
                const record::Recording& recording, const record::Frame& frame,
                const FrameStyle& style) {
    const std::vector<bool> visible = visible_bodies(recording);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < visible.size(); ++i)
        if (visible[i]) order.push_back(i);
    // Sort far bodies first, so that near ones cover them.
    const Vec3 viewer = view.towards_viewer();
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return frame.poses[a].position.dot(viewer) < frame.poses[b].position.dot(viewer);
    });
    for (const std::size_t i : order) {
        const record::RecordedBody& body = recording.bodies[i];
        if (has_size(body))
            draw_box(drawing, axes, view, body, frame.poses[i], style.ghost);
        else
            draw_dot(drawing, project(axes, view, frame.poses[i].position), style.ghost ? 2.5 : 4.0,
                     style.ghost ? kGhostColor : kBodyLine);
    }
    draw_joints(drawing, axes, view, recording, frame, style.ghost);
    draw_cables(drawing, axes, view, recording, frame, style);
}

Box body_extent(const Axes& axes, const View& view, const record::RecordedBody& body,
                const Pose& pose) {
    double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;
    for (const Vec3& corner : corners(body, pose)) {
        const Point p = project(axes, view, corner);
        x0 = std::min(x0, p.x);
        x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y);
        y1 = std::max(y1, p.y);
    }
    return {x0, y0, x1 - x0, y1 - y0};
}

}  // namespace hawser::draw
