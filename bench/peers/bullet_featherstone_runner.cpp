// SPDX-License-Identifier: Apache-2.0
// Bullet 3.24 in double precision: reduced coordinates (btMultiBody, Featherstone's algorithm),
// loop closures by btMultiBodyMLCPConstraintSolver with Dantzig's pivoting.
#if HAWSER_HAVE_BULLET
#include "bullet_common.h"
#include "forest.h"
#include "runner.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyMLCPConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <map>
#include <optional>
#include <utility>

namespace hawser::bench {
namespace {

// The default. Gap on mooring without substeps: 6.5e-7, 3.3e-7, 1.3e-7, 8e-8 m at 0.1, 0.2, 0.5,
// 0.8; but at 0.8 a closure at the end of a taut line rings (tow_zigzag, second layout).
constexpr double kFeatherstoneErp = 0.2;

/// A world of multibodies that is one island.
///
/// Bullet finds islands through colliders, and passes on no closures if there are none, so closures
/// and contacts are given to the solver here. The prediction of poses for soft bodies is left out.
/// Both make the engine faster than its default world.
class TreeWorld final : public CollidesIfAsked<btMultiBodyDynamicsWorld> {
  public:
    using CollidesIfAsked::CollidesIfAsked;

    void solveConstraints(btContactSolverInfo& info) override {
        solveExternalForces(info);
        const int closures = m_sortedMultiBodyConstraints.size();
        const int touching = collides ? getDispatcher()->getNumManifolds() : 0;
        if (closures + touching > 0)
            m_multiBodyConstraintSolver->solveMultiBodyGroup(
                nullptr, 0, getDispatcher()->getInternalManifoldPointer(), touching, nullptr, 0,
                closures > 0 ? &m_sortedMultiBodyConstraints[0] : nullptr, closures, info, nullptr,
                getDispatcher());
        solveInternalConstraints(info);
    }
    void calculateSimulationIslands() override {}
    void predictUnconstraintMotion(btScalar h) override {
        // NOLINTNEXTLINE(bugprone-parent-virtual-call): without that of btMultiBodyDynamicsWorld
        btDiscreteDynamicsWorld::predictUnconstraintMotion(h);
    }
};

/// Place of a body of the scene: a tree and its link, -1 for the base.
struct Place {
    btMultiBody* tree = nullptr;
    int link = -1;
};

class FeatherstoneRunner final : public Runner {
  public:
    FeatherstoneRunner(const Scene& scene, int substeps, const TreeLayout& layout)
        : scene_(scene),
          substeps_(substeps),
          layout_(layout),
          mlcp_(&dantzig_),
          world_(&parts_.dispatcher, &parts_.broadphase, &mlcp_, &parts_.configuration) {
        world_.setGravity(btVector3(0, 0, -scene.gravity));
        btContactSolverInfo& info = world_.getSolverInfo();
        info.m_erp = info.m_erp2 = kFeatherstoneErp;
        info.m_globalCfm = 0;
        info.m_splitImpulse = 0;
        // A warm start above 1000 N s makes btDantzigSolver report failure; it works without.
        info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
        if (scene.touching) {
            touching_.emplace(scene, world_, parts_);
            world_.collides = true;
        }
        place_.resize(scene.bodies.size());
        for (const auto& tree : spanning_forest(scene, layout)) add_tree(tree);
        for (const int j : layout.closures) close(scene.joints[static_cast<std::size_t>(j)]);
    }
    ~FeatherstoneRunner() override {
        for (auto& c : closures_) world_.removeMultiBodyConstraint(c.get());
        for (auto& c : colliders_) world_.removeCollisionObject(c.get());
        for (auto& t : trees_) world_.removeMultiBody(t.get());
        if (ground_) world_.removeMultiBody(ground_.get());
    }

    int substeps() const override { return substeps_; }
    std::string settings() const override {
        const int n = static_cast<int>(closures_.size());
        std::string text = "layout '" + layout_.name + "', " + std::to_string(n) + " closures";
        return n > 0 ? text + ", ERP 0.2" : text;
    }

    int contacts() const override { return touching_ ? touching_->points() : -1; }

    Spent substep(const std::vector<Load>& loads) override {
        for (std::size_t i = 0; i < place_.size(); ++i) {
            const Place& p = place_[i];
            btVector3 force = to_bullet(loads[i].force);
            if (scene_.bodies[i].afloat)
                force += btVector3(0, 0, scene_.bodies[i].mass * scene_.gravity);
            if (p.link < 0) {
                p.tree->addBaseForce(force);
                p.tree->addBaseTorque(to_bullet(loads[i].torque));
            } else {
                p.tree->addLinkForce(p.link, force);
                p.tree->addLinkTorque(p.link, to_bullet(loads[i].torque));
            }
        }
        return measure_time([&] { world_.stepSimulation(kFrame / substeps_, 0); });
    }

    void read(std::vector<BodyState>& out) const override {
        for (const auto& t : trees_) {
            const std::size_t n = static_cast<std::size_t>(t->getNumLinks()) + 1;
            omega_.resize(n);
            velocity_.resize(n);
            t->forwardKinematics(rotation_, origin_);
            t->compTreeLinkVelocities(omega_.data(), velocity_.data());
            for (const auto& [body, link] : members_.at(t.get())) {
                BodyState& s = out[static_cast<std::size_t>(body)];
                const int row = link + 1;  // the base is first
                const auto k = static_cast<std::size_t>(row);
                if (link < 0) {
                    s.x = from_bullet(t->getBasePos());
                    s.q = from_bullet(t->getWorldToBaseRot().inverse());
                } else {
                    const btTransform& at = t->getLink(link).m_cachedWorldTransform;
                    s.x = from_bullet(at.getOrigin());
                    s.q = from_bullet(at.getRotation());
                }
                // compTreeLinkVelocities returns vectors in the frame of each link.
                s.v = s.q * from_bullet(velocity_[k]);
                s.w = s.q * from_bullet(omega_[k]);
            }
        }
    }

  private:
    const Body& body(int i) const { return scene_.bodies[static_cast<std::size_t>(i)]; }

    void add_tree(const std::vector<TreeNode>& nodes) {
        const bool floating = nodes.front().parent == kFree;
        const int links = static_cast<int>(nodes.size()) - (floating ? 1 : 0);
        const Body root = floating ? body(nodes.front().body) : Body{};
        auto tree = std::make_unique<btMultiBody>(links, root.mass, to_bullet(root.inertia),
                                                  !floating, false);
        tree->setBasePos(to_bullet(root.start.x));
        tree->setWorldToBaseRot(to_bullet(root.start.q).inverse());
        tree->setHasSelfCollision(false);
        tree->setLinearDamping(0);
        tree->setAngularDamping(0);
        tree->setMaxCoordinateVelocity(1e30);
        int link = 0;
        for (const TreeNode& n : nodes) {
            if (n.parent == kFree) {
                place(*tree, n.body, -1);
                continue;
            }
            const bool on_base = n.parent == kWorld;
            const Quat parent_q = on_base ? Quat::Identity() : body(n.parent).start.q;
            const int parent = on_base ? -1 : place_[static_cast<std::size_t>(n.parent)].link;
            const Body& b = body(n.body);
            tree->setupSpherical(link, b.mass, to_bullet(b.inertia), parent,
                                 to_bullet(Quat(b.start.q.conjugate() * parent_q)),
                                 to_bullet(n.arm_parent), -to_bullet(n.arm_child), true);
            place(*tree, n.body, link++);
        }
        tree->finalizeMultiDof();
        world_.addMultiBody(tree.get());
        for (const TreeNode& n : nodes) add_collider(n.body);
        trees_.push_back(std::move(tree));
    }

    void add_collider(int i) {
        auto shape = bullet_shape(body(i).shape);
        if (!touching_ || !shape) return;
        const Place p = place_[static_cast<std::size_t>(i)];
        auto collider = std::make_unique<btMultiBodyLinkCollider>(p.tree, p.link);
        const BodyState& s = body(i).start;
        collider->setCollisionShape(shape.get());
        collider->setWorldTransform(btTransform(to_bullet(s.q), to_bullet(s.x)));
        touching_->surface(*collider);
        world_.addCollisionObject(collider.get(), touching_->group(), touching_->mask());
        if (p.link < 0)
            p.tree->setBaseCollider(collider.get());
        else
            p.tree->getLink(p.link).m_collider = collider.get();
        colliders_.push_back(std::move(collider));
        shapes_.push_back(std::move(shape));
    }

    void place(btMultiBody& tree, int body, int link) {
        place_[static_cast<std::size_t>(body)] = {&tree, link};
        members_[&tree].emplace_back(body, link);
    }

    void close(const BallJoint& j) {
        const bool swap = j.a == kWorld;
        const int a = swap ? j.b : j.a, b = swap ? j.a : j.b;
        const btVector3 arm_a = to_bullet(swap ? j.arm_b : j.arm_a);
        const btVector3 arm_b = to_bullet(swap ? j.arm_a : j.arm_b);
        const Place pa = place_[static_cast<std::size_t>(a)];
        // A null body instead of a fixed tree makes a closure to the world drift.
        const Place pb = b == kWorld ? Place{&ground(), -1} : place_[static_cast<std::size_t>(b)];
        auto c = std::make_unique<btMultiBodyPoint2Point>(pa.tree, pa.link, pb.tree, pb.link, arm_a,
                                                          arm_b);
        c->setMaxAppliedImpulse(BT_INFINITY);  // the default is 100 N s
        c->finalizeMultiDof();
        world_.addMultiBodyConstraint(c.get());
        closures_.push_back(std::move(c));
    }

    btMultiBody& ground() {
        if (!ground_) {
            ground_ = std::make_unique<btMultiBody>(0, 0.0, btVector3(0, 0, 0), true, false);
            ground_->finalizeMultiDof();
            world_.addMultiBody(ground_.get());
        }
        return *ground_;
    }

    const Scene& scene_;
    int substeps_;
    TreeLayout layout_;
    BulletParts parts_;
    btDantzigSolver dantzig_;
    btMultiBodyMLCPConstraintSolver mlcp_;
    TreeWorld world_;
    std::optional<BulletTouching> touching_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
    std::vector<std::unique_ptr<btMultiBody>> trees_;
    std::unique_ptr<btMultiBody> ground_;
    std::vector<std::unique_ptr<btMultiBodyPoint2Point>> closures_;
    std::vector<Place> place_;
    std::map<const btMultiBody*, std::vector<std::pair<int, int>>> members_;
    mutable btAlignedObjectArray<btQuaternion> rotation_;
    mutable btAlignedObjectArray<btVector3> origin_;
    mutable std::vector<btVector3> omega_, velocity_;
};

}  // namespace

std::unique_ptr<Runner> make_bullet_featherstone(const Scene& scene, int substeps,
                                                 const TreeLayout& layout) {
    return std::make_unique<FeatherstoneRunner>(scene, substeps, layout);
}

}  // namespace hawser::bench

#endif  // HAWSER_HAVE_BULLET
