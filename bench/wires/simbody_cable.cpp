// SPDX-License-Identifier: Apache-2.0
// Simbody 3.7: CablePath over a cylinder with a CableSpring, which have no friction.
//
// Stepped by SemiExplicitEuler2Integrator at a fixed step, as Simbody recommends for stiff contact
// and cables in real time.
#include "rig.h"

#include <Simbody.h>

#include <iostream>

namespace hawser::bench::wires {
namespace {

/// Discards output: Debian's build prints every step of its search for the path.
class Hush {
  public:
    Hush() : before_(std::cout.rdbuf(nullptr)) {}
    ~Hush() {
        std::cout.rdbuf(before_);
        std::cout.clear();
    }
    Hush(const Hush&) = delete;
    Hush& operator=(const Hush&) = delete;

  private:
    std::streambuf* before_;
};

class SimbodyCable final : public Rig {
  public:
    explicit SimbodyCable(int substeps)
        : h_(kFrame / substeps),
          matter_(system_),
          cables_(system_),
          forces_(system_),
          discrete_(forces_, matter_) {
        const Hush hush;
        using SimTK::Transform;
        using SimTK::Vec3;
        system_.setUseUniformBackground(true);
        const double length = path_length();
        weight_ = slider(kWeight, -kAside);
        pulled_ = slider(kPulled, kAside);
        SimTK::CablePath path(cables_, matter_.updMobilizedBody(weight_), Vec3(0),
                              matter_.updMobilizedBody(pulled_), Vec3(0));
        // Simbody's cylinders point along their z: rotate it to the world's y.
        SimTK::CableObstacle::Surface post(path, matter_.updGround(),
                                           Transform(SimTK::Rotation(0.5 * kPi, SimTK::XAxis)),
                                           SimTK::ContactGeometry::Cylinder(kRadius));
        post.setNearPoint(Vec3(0, kRadius, 0));
        // Not on the tangents: between antipodes the search starts with geodesics of zero length.
        const double side = 0.8 * kRadius, up = 0.6 * kRadius;
        post.setContactPointHints(Vec3(-side, up, 0), Vec3(side, up, 0));
        const double stiffness = kEA / length;
        SimTK::CableSpring(forces_, path, stiffness, length, kDissipation);
        state_ = system_.realizeTopology();
        system_.realize(state_, SimTK::Stage::Position);
        start_ = height();
        integrator_ = std::make_unique<SimTK::SemiExplicitEuler2Integrator>(system_);
        integrator_->setFixedStepSize(h_);
        integrator_->setAllowInterpolation(false);
        integrator_->initialize(state_);
    }
    void load(double weight, double pull) override {
        const Hush hush;
        SimTK::State& s = integrator_->updAdvancedState();
        discrete_.setOneBodyForce(s, matter_.getMobilizedBody(weight_),
                                  SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0, 0, -weight)));
        discrete_.setOneBodyForce(s, matter_.getMobilizedBody(pulled_),
                                  SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0, 0, -pull)));
    }
    bool substep() override {
        const Hush hush;
        try {
            integrator_->stepTo(integrator_->getTime() + h_);
        } catch (const std::exception&) {
            return false;
        }
        return true;
    }
    double displacement() const override {
        return matter_.getMobilizedBody(weight_).getBodyOriginLocation(
                   integrator_->getAdvancedState())[2] -
               start_;
    }
    std::string settings() const override {
        return "SemiExplicitEuler2, fixed step, stiffness EA/length, dissipation 0.01 s/m";
    }

  private:
    static constexpr double kDissipation = 0.01;
    /// Legs lean outwards: between antipodes the geodesic of this version ends the program
    /// (GeodesicIntegrator, h > 0). Without friction the angle has no effect.
    static constexpr double kAside = 1.2 * kRadius;

    /// From (−aside, −leg) over the circle to (aside, −leg) [m].
    static double path_length() {
        const double far = std::hypot(kAside, kLeg);
        const double round = kPi - 2.0 * (std::acos(kRadius / far) - std::atan2(kLeg, kAside));
        return 2.0 * std::sqrt(far * far - kRadius * kRadius) + kRadius * round;
    }

    /// Make a body of a mass that slides along z at (x, −leg).
    SimTK::MobilizedBodyIndex slider(double mass, double x) {
        const SimTK::Body::Rigid body(
            SimTK::MassProperties(mass, SimTK::Vec3(0), SimTK::Inertia(mass)));
        // A slider moves along its frame's x: rotate it to the world's z.
        const SimTK::Rotation up(-0.5 * kPi, SimTK::YAxis);
        return SimTK::MobilizedBody::Slider(matter_.updGround(),
                                            SimTK::Transform(up, SimTK::Vec3(x, 0, -kLeg)), body,
                                            SimTK::Transform(up, SimTK::Vec3(0)))
            .getMobilizedBodyIndex();
    }
    [[nodiscard]] double height() const {
        return matter_.getMobilizedBody(weight_).getBodyOriginLocation(state_)[2];
    }

    double h_;
    SimTK::MultibodySystem system_;
    SimTK::SimbodyMatterSubsystem matter_;
    SimTK::CableTrackerSubsystem cables_;
    SimTK::GeneralForceSubsystem forces_;
    SimTK::Force::DiscreteForces discrete_;
    SimTK::MobilizedBodyIndex weight_, pulled_;
    SimTK::State state_;
    double start_ = 0.0;
    std::unique_ptr<SimTK::Integrator> integrator_;
};

}  // namespace

std::unique_ptr<Rig> make_simbody_cable(double turns, int substeps) {
    // A path follows the geodesic near the straight line: at most half a turn.
    if (turns > 0.5) return nullptr;
    return std::make_unique<SimbodyCable>(substeps);
}

}  // namespace hawser::bench::wires
