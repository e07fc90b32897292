// SPDX-License-Identifier: Apache-2.0
// Bullet 3.24 in double precision: capsules with point-to-point constraints on a static capsule,
// sequential impulse.
#if HAWSER_HAVE_BULLET
#include "peers/bullet_common.h"
#include "rig.h"

#include <algorithm>

namespace hawser::bench::wires {
namespace {

// Like bench/peers for chains: the default ERP of 0.2 and 10 iterations are worse.
constexpr double kChainErp = 0.8;
constexpr int kChainIterations = 200;
constexpr int kPostGroup = 1, kWireGroup = 2;

class BulletChain final : public Rig {
  public:
    BulletChain(const ChainShape& s, int substeps) : h_(kFrame / substeps), out_(s.out) {
        world_.setGravity(btVector3(0, 0, 0));
        world_.getSolverInfo().m_numIterations = kChainIterations;
        world_.getSolverInfo().m_erp = kChainErp;
        // By default friction has one direction, that of sliding. Without sliding it acts along the
        // bollard as well as along the wire, so that it does not hold.
        world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
        post_.setCollisionShape(&post_shape_);  // a btCapsuleShape points along y
        rubs(post_);
        world_.addCollisionObject(&post_, kPostGroup, kWireGroup);
        const auto at = [&](std::size_t i) { return btVector3(s.nodes[i][0], 0, s.nodes[i][1]); };
        weight_ = &add_ball(kWeight, at(0));
        start_ = weight_->getCenterOfMassPosition().z();
        btRigidBody* before = weight_;
        btVector3 arm(0, 0, 0);
        for (std::size_t i = 0; i + 1 < s.nodes.size(); ++i) {
            btRigidBody& link = add_link(at(i), at(i + 1));
            const btVector3 half(0, 0.5 * at(i).distance(at(i + 1)), 0);
            join(*before, arm, link, -half);
            before = &link;
            arm = half;
        }
        pulled_ = &add_ball(kPulled, at(s.nodes.size() - 1));
        join(*before, arm, *pulled_, btVector3(0, 0, 0));
    }
    ~BulletChain() override {
        for (auto& j : joints_) world_.removeConstraint(j.get());
        for (auto& b : bodies_) world_.removeRigidBody(b.get());
        world_.removeCollisionObject(&post_);
    }
    void load(double weight, double pull) override {
        weight_->applyCentralForce(btVector3(0, 0, -weight));
        pulled_->applyCentralForce(btVector3(pull * out_[0], 0, pull * out_[1]));
    }
    bool substep() override {
        world_.stepSimulation(h_, 0);
        return true;
    }
    double displacement() const override { return weight_->getCenterOfMassPosition().z() - start_; }
    double gap() const override {
        double most = 0.0;
        for (const auto& j : joints_) {
            const btVector3 a = j->getRigidBodyA().getCenterOfMassTransform() * j->getPivotInA();
            const btVector3 b = j->getRigidBodyB().getCenterOfMassTransform() * j->getPivotInB();
            most = std::max(most, static_cast<double>(a.distance(b)));
        }
        return most;
    }
    std::string settings() const override {
        return "sequential impulse, ERP 0.8, 200 iterations, two friction directions, "
               "post a long capsule";
    }

  private:
    static void rubs(btCollisionObject& object) {
        object.setFriction(std::sqrt(kRub));  // Bullet multiplies the values of two surfaces
        object.setRestitution(0);
    }
    btRigidBody& add(double mass, btCollisionShape& shape, const btTransform& at, bool touches) {
        btVector3 inertia;
        shape.calculateLocalInertia(mass, inertia);
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
        info.m_startWorldTransform = at;
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody& b = *bodies_.back();
        b.setDamping(0, 0);
        b.setActivationState(DISABLE_DEACTIVATION);
        rubs(b);
        world_.addRigidBody(&b, kWireGroup, touches ? kPostGroup : 0);
        return b;
    }
    btRigidBody& add_ball(double mass, const btVector3& at) {
        return add(mass, ball_, btTransform(btQuaternion::getIdentity(), at), false);
    }
    btRigidBody& add_link(const btVector3& from, const btVector3& to) {
        const btVector3 along = to - from;
        shapes_.push_back(std::make_unique<btCapsuleShape>(kWireRadius, along.length()));
        const btQuaternion q = shortestArcQuat(btVector3(0, 1, 0), along.normalized());
        return add(kDensity * along.length(), *shapes_.back(), btTransform(q, 0.5 * (from + to)),
                   true);
    }
    void join(btRigidBody& a, const btVector3& in_a, btRigidBody& b, const btVector3& in_b) {
        joints_.push_back(std::make_unique<btPoint2PointConstraint>(a, b, in_a, in_b));
        world_.addConstraint(joints_.back().get(), true);
    }

    double h_;
    std::array<double, 2> out_;
    double start_ = 0.0;
    BulletParts parts_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&parts_.dispatcher, &parts_.broadphase, &solver_,
                                   &parts_.configuration};
    btCapsuleShape post_shape_{kRadius - kWireRadius, 4.0};
    btSphereShape ball_{0.1};
    btCollisionObject post_;
    btRigidBody *weight_ = nullptr, *pulled_ = nullptr;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btPoint2PointConstraint>> joints_;
};

}  // namespace

std::unique_ptr<Rig> make_bullet_chain(double turns, int elements, int substeps) {
    return std::make_unique<BulletChain>(chain_shape(turns, elements), substeps);
}

}  // namespace hawser::bench::wires

#endif  // HAWSER_HAVE_BULLET
