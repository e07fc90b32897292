// SPDX-License-Identifier: Apache-2.0
// A semi-submersible in regular waves with coefficients of WAMIT, compared with WAMIT's own motions
// (.4) and mean drift (.9). Its mass, centre of mass and external roll damping are those of the
// run's .frc.
#include <hawser/hydro_files.h>

#include "base/dense.h"
#include "validate/data.h"
#include "validate/sea.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

namespace hawser::validate {
namespace {

using Complex = std::complex<double>;

constexpr double kSemiMass = 51'979'800.0, kSemiG = -0.5, kRollDamping = 2e9;
constexpr double kWaveAmplitude =
    0.25;  ///< Amplitude of the waves, small because the reference is linear [m].
constexpr double kHoldPeriod = 250.0;  ///< Natural period of surge, sway and yaw [s].
constexpr double kRamp = 100.0, kSettle = 1000.0, kEase = 1000.0,
                 kMeasure = 500.0;  ///< Durations of the phases [s].
const char* const kMotionNames[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

struct SemiMotion {
    std::array<Complex, 6> rao;
    std::array<double, 6> drift;  ///< Mean force of the springs, over a² [N/m², N/m].
};

/// A semi-submersible on springs and dampers in surge, sway and yaw. Their forces are set
/// explicitly each step, which is accurate for such long periods.
class SemiSubmersible {
  public:
    SemiSubmersible(std::shared_ptr<const WaveCoefficients> c, double omega, double direction)
        : omega_(omega), direction_(direction), c_(std::move(c)) {
        const double squared = kSemiG * kSemiG * kSemiMass;
        const Vec3 inertia(56'606'002'200.0 - squared, 60'088'648'800.0 - squared,
                           73'096'593'750.0);
        body_ = w_.add_body({.name = "semi",
                             .position = {0, 0, kSemiG},
                             .mass = kSemiMass,
                             .inertia = inertia.asDiagonal()});
        SeaDef sea{.depth = 5000.0};
        sea.waves.push_back(
            {.height = 2.0 * kWaveAmplitude, .period = 2.0 * kPi / omega, .direction = direction});
        WaterHull hull{.body = body_, .wave_pressure = false, .damping = {0, 0, 0, kRollDamping}};
        hull.coefficients = c_;
        hull.excitation = ExcitationKind::full;
        hull.drift = true;
        // Waves act at the slowly varying position. Its remaining motion at the waves' period
        // causes a mean force, 4/(ωτ)³ of the motions.
        hull.slow_time = 120.0;
        hull.linear = {.on = true, .height = kSemiG};
        sea.hulls.push_back(hull);
        w_.add(sea);
        for (int k = 0; k < 6; ++k)
            inert_[k] = (k < 3 ? kSemiMass : inertia[k - 3]) + c_->zero(k, k);
    }

    SemiMotion run() {
        const double end = kRamp + kSettle + kEase + kMeasure;
        while (w_.time() < end) {
            w_.set_system_signal("sea.waves", std::min(1.0, w_.time() / kRamp));
            // Let slow motions decay first. Then reduce the dampers, which would change phases, so
            // slowly that this excites no motion.
            const double eased = std::clamp((w_.time() - kRamp - kSettle) / kEase, 0.0, 1.0);
            step(0.02 + 0.29 * (1.0 + std::cos(kPi * eased)));
            if (eased == 1.0) take();
        }
        return evaluate();
    }

  private:
    void step(double damping) {
        const double rate = 2.0 * kPi / kHoldPeriod;
        const Twist v = w_.velocity(body_);
        const std::array<double, 6> x = displacement();
        Vec3 push = Vec3::Zero(), turn = Vec3::Zero();
        for (const int k : {0, 1}) {
            spring_[std::size_t(k)] = inert_[k] * rate * rate * x[std::size_t(k)];
            push[k] = -spring_[std::size_t(k)] - 2.0 * damping * rate * inert_[k] * v.linear[k];
        }
        spring_[5] = inert_[5] * rate * rate * x[5];
        turn.z() = -spring_[5] - 2.0 * damping * rate * inert_[5] * v.angular.z();
        w_.set_force(body_, push, turn);
        advance(w_, 1);
    }

    /// Return the displacement of the reference point of the coefficients, and the rotation vector.
    [[nodiscard]] std::array<double, 6> displacement() const {
        const Pose pose = w_.pose(body_);
        const Vec3 x = pose.position + pose.orientation * c_->reference;
        const Eigen::AngleAxisd turn(pose.orientation);
        const Vec3 r = turn.angle() * turn.axis();
        return {x.x(), x.y(), x.z(), r.x(), r.y(), r.z()};
    }

    void take() {
        time_.push_back(w_.time());
        place_.push_back(displacement());
        springs_.push_back(spring_);
    }

    /// Compute mean, cos ωt, sin ωt and the remaining slow motion by weighted least squares. Pitch
    /// and roll of the start, at about 40 s, decay for hours. The weights of J. von Hann end
    /// smoothly; without them a few thousandths of that motion would count as mean.
    SemiMotion evaluate() const {
        const auto n = static_cast<Eigen::Index>(time_.size());
        const double slow = 2.0 * kPi / kHoldPeriod;
        Eigen::MatrixXd left(n, 5), right(n, 6), force(n, 6);
        for (Eigen::Index i = 0; i < n; ++i) {
            const double t = time_[std::size_t(i)];
            const double left_over = std::exp(-0.02 * slow * (t - time_.front()));
            const double weight = std::sin(kPi * (double(i) + 0.5) / double(n));  // its root
            left.row(i) << 1.0, std::cos(omega_ * t), std::sin(omega_ * t),
                left_over * std::cos(slow * t), left_over * std::sin(slow * t);
            left.row(i) *= weight;
            for (Eigen::Index k = 0; k < 6; ++k) {
                right(i, k) = weight * place_[std::size_t(i)][std::size_t(k)];
                force(i, k) = weight * springs_[std::size_t(i)][std::size_t(k)];
            }
        }
        const Eigen::MatrixXd x = base::least_squares(left, right);
        const Eigen::MatrixXd f = base::least_squares(left, force);
        SemiMotion out{};
        // Phases refer to the wave at the mean position of the body; Re ξ e^{−iωt}.
        const double wave = wave_number(omega_, 5000.0) *
                            (x(0, 0) * std::cos(direction_) + x(0, 1) * std::sin(direction_));
        for (Eigen::Index k = 0; k < 6; ++k) {
            out.rao[std::size_t(k)] =
                Complex(x(1, k), x(2, k)) * std::polar(1.0 / kWaveAmplitude, -wave);
            out.drift[std::size_t(k)] = f(0, k) / (kWaveAmplitude * kWaveAmplitude);
        }
        return out;
    }

    World w_{WorldDef{}};
    BodyId body_{};
    double omega_, direction_;
    std::shared_ptr<const WaveCoefficients> c_;
    double inert_[6] = {};
    std::array<double, 6> spring_{};
    std::vector<double> time_;
    std::vector<std::array<double, 6>> place_, springs_;
};

std::size_t nearest(const std::vector<double>& all, double value) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
        if (std::abs(all[i] - value) < std::abs(all[best] - value)) best = i;
    return best;
}

void compare_motion(Report& report, const WaveCoefficients& c, double period, double degrees) {
    const std::size_t w = nearest(c.frequency, 2.0 * kPi / period);
    const std::size_t h = nearest(c.heading, degrees * kPi / 180.0);
    const SemiMotion got =
        SemiSubmersible(std::make_shared<const WaveCoefficients>(c), c.frequency[w], c.heading[h])
            .run();
    const std::string at = fmt::format("{:.0f} s, {:.0f} deg: ", period, degrees);
    for (int k = 0; k < 6; ++k) {
        const Complex ours = got.rao[std::size_t(k)], theirs = c.motion[c.index(h, w, k)];
        if (std::abs(theirs) < (k < 3 ? 0.02 : 5e-4)) continue;
        report.compare(at + kMotionNames[k] + (k < 3 ? " [m/m]" : " [rad/m]"), {std::abs(theirs)},
                       {std::abs(ours)}, 0.02, "2 %");
        report.compare(at + kMotionNames[k] + ", phase [deg]", {0.0},
                       {std::arg(ours / theirs) * 180.0 / kPi}, 3.0, "3 degrees", 1.0);
    }
    std::vector<double> table, mean;
    for (const int k : {0, 1}) {
        table.push_back(c.drift[c.index(h, w, k)]);
        mean.push_back(got.drift[std::size_t(k)]);
    }
    report.compare(at + "mean drift, surge and sway [N/m2]", table, mean, 0.02, "2 %");
}

}  // namespace

void case_sea_rao(Report& report) {
    WaveCoefficients c = read_coefficients(data_file("semisub.1"));
    if (c.motion.empty() || c.drift.empty() || !c.has_stiffness || !c.has_zero) {
        report.fail("semisub.4, .9 and .hst have to be beside semisub.1");
        return;
    }
    c.reference = {0.0, 0.0, -kSemiG};
    // Its panels do not meet edge to edge everywhere; columns up to the waterline need no deck.
    const HullMesh mesh = read_hull(data_file("semisub.gdf"));
    double top = mesh.vertices.front().z();
    for (const Vec3& x : mesh.vertices) top = std::max(top, x.z());
    const HullStatics statics = hull_statics(mesh, Pose{}, top);
    report.compare("volume of the mesh [m3]", {50'712.0}, {statics.volume}, 0.01, "1 %");
    for (const double period : {8.0, 10.0, 12.0, 15.0})
        for (const double degrees : {0.0, 40.0}) compare_motion(report, c, period, degrees);
}

}  // namespace hawser::validate
