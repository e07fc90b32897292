// SPDX-License-Identifier: Apache-2.0
// Simbody 3.7: reduced coordinates, ball mobilizers, ball constraints on loop closures.
//
// Stepped by an explicit loop of semi-explicit Euler (velocities from accelerations, then positions
// from the new velocities, then projection): one evaluation per substep. Its integrators, including
// SemiExplicitEulerIntegrator, evaluate at least as often, and also interpolate.
#include "forest.h"
#include "runner.h"

#include <Simbody.h>

namespace hawser::bench {
namespace {

// Gap from which a closure is projected: a projection costs as much as the rest of a step. A tenth
// of the limit (1 mm).
constexpr double kProjectAt = 1e-4;  // [m], and [m/s] for velocities

SimTK::Vec3 to_simbody(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 from_simbody(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }
SimTK::Rotation to_simbody(const Quat& q) {
    return SimTK::Rotation(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z()));
}

class SimbodyRunner final : public Runner {
  public:
    SimbodyRunner(const Scene& scene, int substeps, const TreeLayout& layout)
        : scene_(scene),
          substeps_(substeps),
          layout_(layout),
          matter_(system_),
          forces_(system_),
          discrete_(forces_, matter_) {
        system_.setUseUniformBackground(true);
        mobod_.resize(scene.bodies.size());
        for (const auto& tree : spanning_forest(scene, layout))
            for (const TreeNode& n : tree) add(n);
        for (const int j : layout.closures) {
            const BallJoint& b = scene.joints[static_cast<std::size_t>(j)];
            SimTK::Constraint::Ball(at(b.a), to_simbody(b.arm_a), at(b.b), to_simbody(b.arm_b));
        }
        state_ = system_.realizeTopology();
        system_.realizeModel(state_);
        for (std::size_t i = 0; i < mobod_.size(); ++i) {
            const BodyState& s = scene.bodies[i].start;
            if (mobod_[i].free)
                at(static_cast<int>(i))
                    .setQToFitTransform(state_, SimTK::Transform(to_simbody(s.q), to_simbody(s.x)));
        }
        system_.realize(state_, SimTK::Stage::Velocity);
    }

    int substeps() const override { return substeps_; }
    std::string settings() const override {
        return "semi-explicit Euler, layout '" + layout_.name + "', " +
               std::to_string(layout_.closures.size()) + " closures";
    }

    Spent substep(const std::vector<Load>& loads) override {
        for (std::size_t i = 0; i < mobod_.size(); ++i) {
            const Body& b = scene_.bodies[i];
            Vec3 force = loads[i].force;
            if (!b.afloat) force.z() -= b.mass * scene_.gravity;
            discrete_.setOneBodyForce(
                state_, at(static_cast<int>(i)),
                SimTK::SpatialVec(to_simbody(loads[i].torque), to_simbody(force)));
        }
        return measure_time([&] { advance(kFrame / substeps_); });
    }

    void read(std::vector<BodyState>& out) const override {
        system_.realize(state_, SimTK::Stage::Velocity);
        for (std::size_t i = 0; i < mobod_.size(); ++i) {
            const SimTK::MobilizedBody& m = matter_.getMobilizedBody(mobod_[i].index);
            const SimTK::Quaternion q = m.getBodyRotation(state_).convertRotationToQuaternion();
            out[i].x = from_simbody(m.getBodyOriginLocation(state_));
            out[i].q = Quat(q[0], q[1], q[2], q[3]);
            out[i].v = from_simbody(m.getBodyOriginVelocity(state_));
            out[i].w = from_simbody(m.getBodyAngularVelocity(state_));
        }
    }

  private:
    struct Member {
        SimTK::MobilizedBodyIndex index;
        bool free = false;
    };

    SimTK::MobilizedBody& at(int body) {
        return body == kWorld
                   ? matter_.updGround()
                   : matter_.updMobilizedBody(mobod_[static_cast<std::size_t>(body)].index);
    }

    void add(const TreeNode& n) {
        const Body& b = scene_.bodies[static_cast<std::size_t>(n.body)];
        const SimTK::Body::Rigid rigid(SimTK::MassProperties(
            b.mass, SimTK::Vec3(0), SimTK::Inertia(b.inertia.x(), b.inertia.y(), b.inertia.z())));
        Member& m = mobod_[static_cast<std::size_t>(n.body)];
        if (n.parent == kFree) {
            m.index =
                SimTK::MobilizedBody::Free(matter_.updGround(), rigid).getMobilizedBodyIndex();
            m.free = true;
            return;
        }
        const Quat parent_q = n.parent == kWorld
                                  ? Quat::Identity()
                                  : scene_.bodies[static_cast<std::size_t>(n.parent)].start.q;
        const SimTK::Transform on_parent(to_simbody(Quat(parent_q.conjugate() * b.start.q)),
                                         to_simbody(n.arm_parent));
        m.index = SimTK::MobilizedBody::Ball(at(n.parent), on_parent, rigid,
                                             SimTK::Transform(to_simbody(n.arm_child)))
                      .getMobilizedBodyIndex();
    }

    void advance(double h) {
        system_.realize(state_, SimTK::Stage::Acceleration);
        const SimTK::Vector u = state_.getU() + h * state_.getUDot();
        matter_.multiplyByN(state_, false, u, qdot_);
        // Time is not advanced: no force depends on it, and advancing it invalidates more of the
        // state.
        state_.updQ() += h * qdot_;
        state_.updU() = u;
        matter_.normalizeQuaternions(state_);
        if (!layout_.closures.empty()) system_.project(state_, kProjectAt);
    }

    const Scene& scene_;
    int substeps_;
    TreeLayout layout_;
    SimTK::MultibodySystem system_;
    SimTK::SimbodyMatterSubsystem matter_;
    SimTK::GeneralForceSubsystem forces_;
    SimTK::Force::DiscreteForces discrete_;
    std::vector<Member> mobod_;
    SimTK::State state_;
    SimTK::Vector qdot_;
};

}  // namespace

std::unique_ptr<Runner> make_simbody(const Scene& scene, int substeps, const TreeLayout& layout) {
    return std::make_unique<SimbodyRunner>(scene, substeps, layout);
}

}  // namespace hawser::bench
