// SPDX-License-Identifier: Apache-2.0
#include "base/body_dof.h"
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace hawser::report::start {

namespace {

/// Depth relative to the narrower shape, above which shapes overlap at the start.
constexpr double kMaxStartDepth = 0.05;

/// Largest plausible force at a contact at rest. A body on soft ground, or below others, compresses
/// its contact by the weights over the stiffness; a line on a roller by its tension. The limit is
/// this multiple of the lighter body's weight at a point, and twice the tension.
constexpr double kMaxContactWeights = 4.0;

/// Tolerated depth of a wire in a roller, in wire diameters. A wire placed by straight lines cuts
/// into its rollers. Contact moves it out on the shortest way, which is the right side up to the
/// middle of the roller.
constexpr double kWireDeep = 4.0;

/// Largest number of errors with a text each: a heap of thousands has one cause.
constexpr std::size_t kMaxPairs = 1000;

/// Interval that a shape covers along a direction, from its lowest to its highest point [m].
struct Reach {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double at, double half) {
        low = std::min(low, at - half);
        high = std::max(high, at + half);
    }
};

/// Add the interval of a shape; infinite if the shape is unbounded. @param n  Unit vector, world
/// frame.
void add_reach(const World& world, const ShapeDef& def, const Vec3& n, Reach& reach) {
    const Pose pose = world.pose(def.body);
    const Vec3 at = pose.position + pose.orientation * def.position;
    const Vec3 local = (pose.orientation * def.orientation).conjugate() * n;
    const double x = n.dot(at);
    const double across = std::hypot(local.x(), local.y());
    switch (def.kind) {
        case ShapeKind::sphere:
            return reach.add(x, def.radius);
        case ShapeKind::capsule:
            if (def.body_b.valid()) {
                reach.add(n.dot(pose.position), def.radius);
                return reach.add(n.dot(world.pose(def.body_b).position), def.radius);
            }
            return reach.add(x, def.radius + def.half_length * std::abs(local.z()));
        case ShapeKind::cylinder:
            return reach.add(x, def.radius * across + def.half_length * std::abs(local.z()));
        case ShapeKind::box:
            return reach.add(x, def.half_size.dot(local.cwiseAbs()));
        case ShapeKind::hull:
            for (const Vec3& vertex : def.vertices) reach.add(x + local.dot(vertex), 0.0);
            return;
        case ShapeKind::plane:
        case ShapeKind::heightfield:
        case ShapeKind::mesh:
            return reach.add(x, HUGE_VAL);
    }
}

class Overlaps {
  public:
    Overlaps(const record::SceneInfo& scene, const World& world)
        : world_(world),
          scene_locations_(scene.shape_places),
          pull_(static_cast<std::size_t>(world.body_count()), 0.0) {
        for (const InteractionId id : world.interactions()) {
            const double tension = start_tension(world, id);
            for (std::size_t b = 0; b < 2 && tension > 0.0; ++b) {
                const BodyId body = world.interaction_def(id).body[b];
                double& pull = pull_[static_cast<std::size_t>(body.index)];
                pull = std::max(pull, tension);
            }
        }
        of_body_.resize(static_cast<std::size_t>(world.body_count()));
        for (const ShapeId id : world.shapes()) {
            const ShapeDef& def = world.shape_def(id);
            if (!def.body_b.valid())
                of_body_[static_cast<std::size_t>(def.body.index)].push_back(id);
        }
    }

    void run(Findings& out) {
        for (const ContactView& contact : world_.overlaps()) add_contact(contact);
        std::vector<std::pair<std::pair<Owner, Owner>, Pair>> worst(pairs_.begin(), pairs_.end());
        std::stable_sort(worst.begin(), worst.end(), [](const auto& a, const auto& b) {
            return a.second.depth / a.second.width > b.second.depth / b.second.width;
        });
        for (std::size_t i = 0; i < std::min(kMaxPairs, worst.size()); ++i)
            report(worst[i].second, out);
        if (worst.size() > kMaxPairs)
            out.add(false, FindingKind::unexamined, {}, static_cast<double>(worst.size()),
                    fmt::format("{} pairs of bodies overlap at the start; the worst {} are listed",
                                worst.size(), kMaxPairs));
    }

  private:
    /// Index of a body, or −1 − shape for the segment of a wire.
    using Owner = std::int32_t;
    struct Pair {
        double depth = 0.0,
               width =
                   1.0;  ///< Depth and width of the point with the largest depth over width [m].
        ShapeId shape[2];
    };

    [[nodiscard]] Owner owner(ShapeId shape) const {
        const ShapeDef& def = world_.shape_def(shape);
        return def.body_b.valid() ? -1 - shape.index : def.body.index;
    }

    [[nodiscard]] bool is_wire(ShapeId shape) const {
        return world_.shape_def(shape).body_b.valid();
    }

    [[nodiscard]] double width(ShapeId shape, const Vec3& n) const {
        Reach reach;
        const ShapeDef& def = world_.shape_def(shape);
        if (is_wire(shape)) return 2.0 * def.radius;
        for (const ShapeId s : of_body_[static_cast<std::size_t>(def.body.index)])
            add_reach(world_, world_.shape_def(s), n, reach);
        return reach.high - reach.low;
    }

    /// Return the largest plausible force of a shape's bodies against others at rest [N]; infinite
    /// if no body moves.
    [[nodiscard]] double plausible_force(ShapeId shape) const {
        const ShapeDef& def = world_.shape_def(shape);
        double mass = 0.0, pull = 0.0;
        for (const BodyId body : {def.body, def.body_b}) {
            if (!body.valid() || base::dof_of(world_.body_def(body).kind) == 0) continue;
            mass += world_.body_def(body).mass;
            pull = std::max(pull, pull_[static_cast<std::size_t>(body.index)]);
        }
        // A line that reverses its direction presses with twice its tension.
        return mass > 0.0
                   ? kMaxContactWeights * mass * world_.settings().gravity.norm() + 2.0 * pull
                   : HUGE_VAL;
    }

    void add_contact(const ContactView& contact) {
        const double depth = -contact.gap;
        double width[2];
        for (int s = 0; s < 2; ++s) width[s] = this->width(contact.shape[s], contact.normal);
        const double narrower = std::min(width[0], width[1]);
        if (!(narrower > 0.0)) return;
        if (depth <= std::min(world_.settings().contact_margin, kMaxStartDepth * narrower)) return;
        const double pressed =
            std::min(plausible_force(contact.shape[0]), plausible_force(contact.shape[1]));
        if (std::isfinite(pressed) && contact.force.norm() <= pressed) return;
        add_contact(contact, depth, narrower, std::max(width[0], width[1]));
    }

    void add_contact(const ContactView& contact, double depth, double narrower, double wider) {
        const bool wires[2] = {is_wire(contact.shape[0]), is_wire(contact.shape[1])};
        // Half of this width is too deep. It is the width of the narrower shape; for a wire against
        // another shape it depends on the other one.
        double width = narrower;
        if (wires[0] != wires[1]) width = std::min(wider, 2.0 * kWireDeep * narrower);
        std::pair<Owner, Owner> key(owner(contact.shape[0]), owner(contact.shape[1]));
        if (key.first > key.second) std::swap(key.first, key.second);
        Pair& pair = pairs_[key];
        if (depth * pair.width <= pair.depth * width) return;
        pair.depth = depth;
        pair.width = width;
        for (int s = 0; s < 2; ++s) pair.shape[s] = contact.shape[s];
    }

    [[nodiscard]] std::string label(ShapeId shape) const {
        const ShapeDef& def = world_.shape_def(shape);
        return !def.name.empty() ? def.name : record::body_label(world_, def.body);
    }

    /// Return " (FILE: /cables/0 and FILE: /shapes/3)" for two shapes; "" if they come from no
    /// file.
    [[nodiscard]] std::string scene_locations(const ShapeId (&shape)[2]) const {
        std::string out;
        for (const ShapeId id : shape) {
            const auto i = static_cast<std::size_t>(id.index);
            if (i < scene_locations_.size())
                out += (out.empty() ? " (" : " and ") + scene_locations_[i];
        }
        return out.empty() ? out : out + ")";
    }

    void report(const Pair& pair, Findings& out) const {
        const bool deep = pair.depth > 0.5 * pair.width;
        const std::string a = label(pair.shape[0]), b = label(pair.shape[1]);
        out.add(
            deep, FindingKind::overlap, {a, b}, pair.depth,
            fmt::format("{} and {}{} start {} inside each other{}: move one of them",
                        record::name_in_quotes(a), record::name_in_quotes(b),
                        scene_locations(pair.shape), record::with_unit(pair.depth, "m"),
                        deep ? fmt::format(", deeper than half of {}, from where contact pushes "
                                           "to the wrong side",
                                           record::with_unit(pair.width, "m"))
                             : "; the contact separates them with an impact"));
    }

    const World& world_;
    const std::vector<std::string>&
        scene_locations_;                        ///< Positions in the scene file for each shape.
    std::vector<double> pull_;                   ///< Largest tension at each body [N].
    std::vector<std::vector<ShapeId>> of_body_;  ///< Shapes of each body, without segments.
    std::map<std::pair<Owner, Owner>, Pair> pairs_;
};

}  // namespace

void check_overlaps(const record::SceneInfo& scene, const World& world, Findings& out) {
    if (!world.shapes().empty()) Overlaps(scene, world).run(out);
}

}  // namespace hawser::report::start
