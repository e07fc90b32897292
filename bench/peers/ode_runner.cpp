// SPDX-License-Identifier: Apache-2.0
// Open Dynamics Engine 0.16: maximal coordinates, dWorldStep (dense LDLT and Dantzig) or
// dWorldQuickStep (projected successive over-relaxation).
#if HAWSER_HAVE_ODE
#include "runner.h"

#include <ode/ode.h>

#include <cstdarg>

namespace hawser::bench {
namespace {

// ERP is the fraction of a joint error that one step removes. On heavy_hook at 8 substeps the gap
// of dWorldStep decreases from 1.2e-7 m at 0.1 over 1.5e-8 m at 0.8 to 1.2e-8 m at 1; QuickStep is
// best at 0.5 to 0.8. CFM is the softness: up to 1e-12 has no effect, 1e-10 makes the gap ten times
// larger; 0 would leave a closed loop singular.
constexpr double kOdeErp = 0.8;
constexpr double kCfm = 1e-14;
// Default 20. Among 10, 20, 50, 100 and 200, this and 20 (at twice the substeps) hold at the least
// cost.
constexpr int kQuickIterations = 50;
// Contacts have the compliance of the scene, k = ERP / (h CFM): with CFM 1e-14 Dantzig's method
// fails for four points of a face ("LCP internal error"). Compared with 0.8 this keeps a stack up
// longer.
constexpr double kContactErp = 0.2;
constexpr int kPointsPerPair = 8;  // two boxes face to face have four to eight

class OdeRunner final : public Runner {
  public:
    OdeRunner(const Scene& scene, int substeps, bool quick) : substeps_(substeps), quick_(quick) {
        dInitODE2(0);
        dSetMessageHandler(ignore_message);  // "LCP internal error" in most steps that fail
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
        if (scene.touching) touch(scene);
    }
    ~OdeRunner() override {
        for (dGeomID g : geoms_) dGeomDestroy(g);
        if (floor_) dGeomDestroy(floor_);
        dJointGroupDestroy(points_);
        dWorldDestroy(world_);
        dCloseODE();
    }

    int substeps() const override { return substeps_; }
    std::string settings() const override {
        const std::string all = quick_ ? "ERP 0.8, CFM 1e-14, 50 iterations" : "ERP 0.8, CFM 1e-14";
        return floor_ ? all + ", contacts ERP 0.2 and the scene's stiffness" : all;
    }

    Spent substep(const std::vector<Load>& loads) override {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Load& l = loads[i];
            dBodyAddForce(bodies_[i], l.force.x(), l.force.y(), l.force.z());
            dBodyAddTorque(bodies_[i], l.torque.x(), l.torque.y(), l.torque.z());
        }
        const double h = kFrame / substeps_;
        return measure_time([&] {
            find_contacts();
            quick_ ? dWorldQuickStep(world_, h) : dWorldStep(world_, h);
        });
    }

    int contacts() const override { return floor_ ? contacts_ : -1; }

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
    static void ignore_message(int /*number*/, const char* /*text*/, va_list /*values*/) {}

    /// Make a geometry for each shape and the floor, in no space: only pairs that can touch are
    /// tested.
    void touch(const Scene& scene) {
        friction_ = scene.touching->friction;
        softness_ = kContactErp * substeps_ / (kFrame * scene.touching->stiffness);
        mutual_ = scene.touching->bodies;
        floor_ = dCreatePlane(nullptr, 0.0, 0.0, 1.0, scene.touching->floor);
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const BodyShape& s = scene.bodies[i].shape;
            if (s.kind == BodyShape::Kind::none) continue;
            const Vec3 size = 2.0 * s.half_size;
            const bool box = s.kind == BodyShape::Kind::box;
            dGeomID g = box ? dCreateBox(nullptr, size.x(), size.y(), size.z())
                            : dCreateCapsule(nullptr, s.radius, 2.0 * s.half_length);
            dGeomSetBody(g, bodies_[i]);
            if (!box) {  // along z in ODE, along x here
                dMatrix3 turn;
                dRFromAxisAndAngle(turn, 0.0, 1.0, 0.0, 1.57079632679489662);
                dGeomSetOffsetRotation(g, turn);
            }
            geoms_.push_back(g);
        }
    }

    void find_contacts() {
        if (!floor_) return;
        dJointGroupEmpty(points_);
        contacts_ = 0;
        for (std::size_t i = 0; i < geoms_.size(); ++i) {
            collide_pair(geoms_[i], floor_);
            for (std::size_t j = 0; mutual_ && j < i; ++j) collide_pair(geoms_[i], geoms_[j]);
        }
    }

    void collide_pair(dGeomID a, dGeomID b) {
        dContact points[kPointsPerPair];
        const int n = dCollide(a, b, kPointsPerPair, &points[0].geom, sizeof(dContact));
        for (int i = 0; i < n; ++i) {
            points[i].surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
            points[i].surface.soft_erp = kContactErp;
            points[i].surface.soft_cfm = softness_;
            points[i].surface.mu = friction_;
            dJointAttach(dJointCreateContact(world_, points_, &points[i]), dGeomGetBody(a),
                         dGeomGetBody(b));
        }
        contacts_ += n;
    }

    dBodyID body(int i) const {
        return i == kWorld ? nullptr : bodies_[static_cast<std::size_t>(i)];
    }

    void add_body(const Body& b) {
        dBodyID id = dBodyCreate(world_);
        dMass m;
        // Set principal moments directly: dMassSetBox and dMassSetCylinder take full lengths and
        // densities or other axes.
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
    std::vector<dGeomID> geoms_;
    dGeomID floor_ = nullptr;
    dJointGroupID points_ = dJointGroupCreate(0);
    double friction_ = 0.0, softness_ = 0.0;
    bool mutual_ = false;
    int contacts_ = 0;
};

}  // namespace

std::unique_ptr<Runner> make_ode(const Scene& scene, int substeps, bool quick) {
    return std::make_unique<OdeRunner>(scene, substeps, quick);
}

}  // namespace hawser::bench

#endif  // HAWSER_HAVE_ODE
