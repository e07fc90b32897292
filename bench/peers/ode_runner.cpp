// SPDX-License-Identifier: Apache-2.0
// Open Dynamics Engine 0.16: maximal coordinates, dWorldStep (dense LDLT and Dantzig) or
// dWorldQuickStep (projected successive over-relaxation).
#if HAWSER_HAVE_ODE
#include "runner.h"

#include <ode/ode.h>

namespace hawser::bench {
namespace {

// ERP is the share of a joint error that one step removes. On heavy_hook at 8 substeps the gap
// of dWorldStep falls from 1.2e-7 m at 0.1 over 1.5e-8 m at 0.8 to 1.2e-8 m at 1; QuickStep does
// best at 0.5 to 0.8. CFM is the softness: up to 1e-12 does not show, 1e-10 makes the gap ten
// times larger; 0 would leave a closed loop singular.
constexpr double kOdeErp = 0.8;
constexpr double kCfm = 1e-14;
// Default 20. Of 10, 20, 50, 100, 200 this and 20 (at twice the substeps) cost least to hold.
constexpr int kQuickIterations = 50;

class OdeRunner final : public Runner {
  public:
    OdeRunner(const Scene& scene, int substeps, bool quick) : substeps_(substeps), quick_(quick) {
        dInitODE2(0);
        world_ = dWorldCreate();
        dWorldSetGravity(world_, 0.0, 0.0, -scene.gravity);
        dWorldSetERP(world_, kOdeErp);
        dWorldSetCFM(world_, kCfm);
        dWorldSetQuickStepNumIterations(world_, kQuickIterations);
        dWorldSetAutoDisableFlag(world_, 0);
        for (const Body& b : scene.bodies) add_body(b);
        for (const BallJoint& j : scene.joints) {
            dJointID id = dJointCreateBall(world_, nullptr);
            dJointAttach(id, body(j.a), body(j.b));
            dJointSetBallAnchor(id, j.anchor.x(), j.anchor.y(), j.anchor.z());
        }
    }
    ~OdeRunner() override {
        dWorldDestroy(world_);
        dCloseODE();
    }

    int substeps() const override { return substeps_; }
    std::string settings() const override {
        return quick_ ? "ERP 0.8, CFM 1e-14, 50 iterations" : "ERP 0.8, CFM 1e-14";
    }

    double substep(const std::vector<Load>& loads) override {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Load& l = loads[i];
            dBodyAddForce(bodies_[i], l.force.x(), l.force.y(), l.force.z());
            dBodyAddTorque(bodies_[i], l.torque.x(), l.torque.y(), l.torque.z());
        }
        const double h = kFrame / substeps_;
        return seconds([&] { quick_ ? dWorldQuickStep(world_, h) : dWorldStep(world_, h); });
    }

    void read(std::vector<BodyState>& out) const override {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const dReal* x = dBodyGetPosition(bodies_[i]);
            const dReal* q = dBodyGetQuaternion(bodies_[i]);
            const dReal* v = dBodyGetLinearVel(bodies_[i]);
            const dReal* w = dBodyGetAngularVel(bodies_[i]);
            out[i].x = Vec3(x[0], x[1], x[2]);
            out[i].q = Quat(q[0], q[1], q[2], q[3]);
            out[i].v = Vec3(v[0], v[1], v[2]);
            out[i].w = Vec3(w[0], w[1], w[2]);
        }
    }

  private:
    dBodyID body(int i) const {
        return i == kWorld ? nullptr : bodies_[static_cast<std::size_t>(i)];
    }

    void add_body(const Body& b) {
        dBodyID id = dBodyCreate(world_);
        dMass m;
        // Principal moments given directly: dMassSetBox and dMassSetCylinder take full lengths
        // and densities or axes of their own.
        dMassSetParameters(&m, b.mass, 0, 0, 0, b.inertia.x(), b.inertia.y(), b.inertia.z(), 0, 0,
                           0);
        dBodySetMass(id, &m);
        const BodyState& s = b.start;
        dBodySetPosition(id, s.x.x(), s.x.y(), s.x.z());
        const dQuaternion q = {s.q.w(), s.q.x(), s.q.y(), s.q.z()};
        dBodySetQuaternion(id, q);
        dBodySetLinearVel(id, s.v.x(), s.v.y(), s.v.z());
        dBodySetAngularVel(id, s.w.x(), s.w.y(), s.w.z());
        dBodySetGravityMode(id, b.afloat ? 0 : 1);
        bodies_.push_back(id);
    }

    int substeps_;
    bool quick_;
    dWorldID world_ = nullptr;
    std::vector<dBodyID> bodies_;
};

}  // namespace

std::unique_ptr<Runner> make_ode(const Scene& scene, int substeps, bool quick) {
    return std::make_unique<OdeRunner>(scene, substeps, quick);
}

}  // namespace hawser::bench

#endif  // HAWSER_HAVE_ODE
