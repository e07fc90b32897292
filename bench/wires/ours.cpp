// SPDX-License-Identifier: Apache-2.0
// Hawser's three methods for a wire around a bollard: a route without mass, a guide of a wire of
// point masses, and a wire of point masses whose capsules touch a cylinder.
#include "rig.h"

#include <hawser/guide.h>
#include <hawser/hawser.h>

#include <algorithm>

namespace hawser::bench::wires {
namespace {

/// Bollard, weight and pull. The weight hangs below (−x, 0) and the wire passes over the top.
class OwnRig : public Rig {
  public:
    void load(double weight, double pull) override {
        w_.set_force(weight_, Vec3(0, 0, -weight), Vec3::Zero());
        w_.set_force(pulled_, pull * out_, Vec3::Zero());
    }
    bool substep() override { return w_.step() == Status::ok; }
    double displacement() const override { return w_.pose(weight_).position.z() - start_; }
    std::string settings() const override { return "defaults"; }

  protected:
    OwnRig()
        : w_(WorldDef{.step = kFrame, .gravity = Vec3::Zero()}),
          post_(w_.add_body({.name = "post", .kind = BodyKind::fixed})) {}

    /// Add both end bodies. @param extra  Mass of the wire at each of the two [kg].
    void ends(const Vec3& weight, const Vec3& pulled, const Vec3& out, double extra) {
        out_ = out;
        start_ = weight.z();
        weight_ = w_.add_body({.name = "weight",
                               .kind = BodyKind::lump,
                               .position = weight,
                               .mass = kWeight + extra});
        pulled_ = w_.add_body({.name = "pulled",
                               .kind = BodyKind::lump,
                               .position = pulled,
                               .mass = kPulled + extra});
    }

    World w_;
    BodyId post_{}, weight_{}, pulled_{};

  private:
    Vec3 out_ = Vec3::Zero();
    double start_ = 0.0;
};

/// Return the point of the wire on the bollard at an angle.
Vec3 on_post(double angle) { return {-kRadius * std::cos(angle), 0, kRadius * std::sin(angle)}; }
Vec3 along_post(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }

class RouteRig final : public OwnRig {
  public:
    RouteRig(double turns, int places) {
        const double angle = 2.0 * kPi * turns;
        const Vec3 out = along_post(angle);
        ends({-kRadius, 0, -kLeg}, on_post(angle) + kLeg * out, out, 0.0);
        RouteDef def{.EA = kEA, .first = {.body = weight_}, .last = {.body = pulled_}};
        if (places == 1 && std::abs(turns - std::floor(turns)) > 0.1) {
            def.places.push_back({.body = post_,
                                  .radius = kRadius,
                                  .friction = kRub,
                                  .turns = static_cast<int>(std::floor(turns))});
        } else {
            // Eyes around the bollard; a single one with both legs on one line stands at its side.
            for (int i = 0; i < places; ++i) {
                const double at = places == 1 ? 0.0 : angle * i / (places - 1);
                def.places.push_back({.body = post_,
                                      .point = on_post(at),
                                      .friction = kRub,
                                      .angle = angle / places});
            }
        }
        w_.add(def);
    }
};

/// Three elements, of which the second passes the bollard with half a metre on either side.
class GuideRig final : public OwnRig {
  public:
    explicit GuideRig(double turns) {
        constexpr double kSide = 0.5;
        const double angle = 2.0 * kPi * turns, element = kRadius * angle + 2.0 * kSide;
        const Vec3 out = along_post(angle), last = on_post(angle);
        ends({-kRadius, 0, -kSide - element}, last + (kSide + element) * out, out,
             0.5 * kDensity * element);
        WireDef def{.name = "wire", .from = weight_, .to = pulled_};
        def.elements = 3;
        def.length = 3.0 * element;
        def.EA = kEA;
        def.mass_per_length = kDensity;
        def.path = {{-kRadius, 0, -kSide}, last + kSide * out};
        const WireId wire = w_.wires().add(def);
        // No node may pass: displacements here are smaller than the length at its sides.
        w_.add(GuideDef{.name = "guide",
                        .wire = wire,
                        .body = post_,
                        .radius = kRadius,
                        .friction = kRub,
                        .turns = static_cast<int>(std::floor(turns)),
                        .element_length = 0.0});
    }
};

class SegmentRig final : public OwnRig {
  public:
    SegmentRig(double turns, int elements) {
        const ChainShape s = chain_shape(turns, elements);
        const auto at = [&](std::size_t i) { return Vec3(s.nodes[i][0], 0, s.nodes[i][1]); };
        const auto length = [&](std::size_t i) { return (at(i + 1) - at(i)).norm(); };
        const std::size_t last = s.nodes.size() - 1;
        ends(at(0), at(last), Vec3(s.out[0], 0, s.out[1]), 0.5 * kDensity * length(0));
        const MaterialId rub =
            w_.add_material({.name = "wire on post", .friction = kRub, .stiffness = 1e9});
        w_.add_shape({.kind = ShapeKind::cylinder,
                      .body = post_,
                      .orientation = Quat(Eigen::AngleAxisd(0.5 * kPi, Vec3::UnitX())),
                      .radius = kRadius - kWireRadius,
                      .half_length = 1.0,
                      .material = rub,
                      .group = 1,
                      .touches = 2});
        BodyId before = weight_;
        for (std::size_t i = 0; i < last; ++i) {
            BodyId next = pulled_;
            if (i + 1 < last)
                next = w_.add_body({.kind = BodyKind::lump,
                                    .position = at(i + 1),
                                    .mass = 0.5 * kDensity * (length(i) + length(i + 1))});
            w_.add(StretchDef{.a = before, .b = next, .EA = kEA});
            w_.add_shape({.kind = ShapeKind::capsule,
                          .body = before,
                          .body_b = next,
                          .radius = kWireRadius,
                          .material = rub,
                          .group = 2,
                          .touches = 1});
            before = next;
        }
    }
    std::string settings() const override { return "contact stiffness 1e9 N/m"; }
};

}  // namespace

std::unique_ptr<Rig> make_route(double turns, int places) {
    return std::make_unique<RouteRig>(turns, places);
}
std::unique_ptr<Rig> make_guide(double turns) { return std::make_unique<GuideRig>(turns); }
std::unique_ptr<Rig> make_segments(double turns, int elements) {
    return std::make_unique<SegmentRig>(turns, elements);
}

}  // namespace hawser::bench::wires
