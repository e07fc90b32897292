// SPDX-License-Identifier: Apache-2.0
// Hawser through its public interface: rigid links, ball joints, contacts.
#include <hawser/world.h>

#include <stdexcept>

#include "runner.h"

namespace hawser::bench {
namespace {

class OursRunner final : public Runner {
  public:
    OursRunner(const Scene& scene, int substeps)
        : substeps_(substeps),
          world_({.step = kFrame / substeps,
                  .gravity = {0.0, 0.0, -scene.gravity},
                  .contact_tolerance = substeps > 1 ? 1e-10 : WorldDef{}.contact_tolerance,
                  .solution_tolerance = substeps > 1 ? 1e-12 : WorldDef{}.solution_tolerance}) {
        ground_ = world_.add_body({.name = "ground", .kind = BodyKind::fixed});
        for (const Body& b : scene.bodies) {
            bodies_.push_back(world_.add_body({.position = b.start.x,
                                               .orientation = b.start.q,
                                               .velocity = b.start.v,
                                               .angular_velocity = b.start.w,
                                               .mass = b.mass,
                                               .inertia = b.inertia.asDiagonal(),
                                               .force = thrust(scene, bodies_.size()),
                                               .linear_damping = Vec3::Constant(b.drag),
                                               .gravity = !b.afloat}));
        }
        for (const Floating& f : scene.floating) {
            add_floating(f, scene.bodies[static_cast<std::size_t>(f.body)]);
        }
        tow_.resize(scene.towed.size());
        for (const BallJoint& j : scene.joints) {
            InteractionDef def{.kind = InteractionKind::Ball, .body = {id(j.a), id(j.b)}};
            def.point[0] = j.arm_a;
            def.point[1] = j.arm_b;
            const InteractionId joint = world_.add_interaction(def);
            for (std::size_t k = 0; k < tow_.size(); ++k) {
                if (j.a == scene.towed[k] || j.b == scene.towed[k]) tow_[k] = joint;
            }
        }
        if (scene.touching) add_shapes(scene);
        world_.prepare();
    }

    int substeps() const override { return substeps_; }
    std::string settings() const override { return "defaults, one thread"; }
    int contacts() const override { return world_.stats().contacts; }

    Spent substep(const std::vector<Load>& /*loads*/) override {
        Status status = Status::ok;
        const Spent time = measure_time([&] { status = world_.step(); });
        if (status != Status::ok)
            throw std::runtime_error("our step failed at t = " + std::to_string(world_.time()));
        return time;
    }

    void read(std::vector<BodyState>& out) const override {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Pose pose = world_.pose(bodies_[i]);
            const Twist twist = world_.velocity(bodies_[i]);
            out[i] = {pose.position, pose.orientation, twist.linear, twist.angular};
        }
    }

    bool staggered() const override { return true; }

    bool tow_force(std::vector<Vec3>& out) const override {
        out.clear();
        for (const InteractionId id : tow_) {
            const auto f = world_.force(id);
            out.emplace_back(f[0], f[1], f[2]);
        }
        return true;
    }

  private:
    static Vec3 thrust(const Scene& scene, std::size_t body) {
        Vec3 sum = Vec3::Zero();
        for (const Thrust& t : scene.thrusts) {
            if (static_cast<std::size_t>(t.body) == body) sum += t.force;
        }
        return sum;
    }

    BodyId id(int body) const {
        return body == kWorld ? ground_ : bodies_[static_cast<std::size_t>(body)];
    }

    void add_floating(const Floating& f, const Body& hull) {
        InteractionDef def{.kind = InteractionKind::Hydrostatic, .body = {id(f.body)}};
        def.set("heave_stiffness", f.heave_k).set("heave_damping", f.heave_c);
        def.set("roll_stiffness", f.tilt_k).set("roll_damping", f.tilt_c);
        def.set("pitch_stiffness", f.tilt_k).set("pitch_damping", f.tilt_c);
        def.set("rest_height", hull.start.x.z());
        (void)world_.add_interaction(def);
    }

    void add_shapes(const Scene& scene) {
        MaterialDef same{.name = "same"};
        same.friction = scene.touching->friction;
        same.stiffness = scene.touching->stiffness;
        const MaterialId material = world_.add_material(same);
        world_.add_material_pair({.a = material, .b = material, .values = same});
        (void)world_.add_shape({.kind = ShapeKind::plane,
                                .body = ground_,
                                .position = {0.0, 0.0, scene.touching->floor},
                                .material = material});
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const BodyShape& from = scene.bodies[i].shape;
            if (from.kind == BodyShape::Kind::none) continue;
            ShapeDef def{.kind = ShapeKind::box, .body = bodies_[i], .half_size = from.half_size};
            def.material = material;
            if (from.kind == BodyShape::Kind::capsule) {
                def.kind = ShapeKind::capsule;
                def.orientation = turn_between(Vec3::UnitZ(), Vec3::UnitX());
                def.radius = from.radius;
                def.half_length = from.half_length;
            }
            (void)world_.add_shape(def);
        }
    }

    int substeps_;
    World world_;
    BodyId ground_;
    std::vector<BodyId> bodies_;
    std::vector<InteractionId> tow_;
};

}  // namespace

std::unique_ptr<Runner> make_ours(const Scene& scene, int substeps) {
    return std::make_unique<OursRunner>(scene, substeps);
}

}  // namespace hawser::bench
