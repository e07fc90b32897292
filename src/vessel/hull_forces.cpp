// SPDX-License-Identifier: Apache-2.0
#include "vessel/hull_forces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace hawser {
namespace {

/// Curve of Hoerner: pairs of B/(2T) and C_d.
constexpr double kHoernerCurve[][2] = {
    {0.0109, 1.9661},  {0.1766, 1.9657},  {0.3530, 1.8976},  {0.4519, 1.7872},  {0.4728, 1.5837},
    {0.4929, 1.2786},  {0.4933, 1.2108},  {0.5585, 1.0836},  {0.6464, 0.99863}, {0.8336, 0.87959},
    {0.9880, 0.82842}, {1.3081, 0.75994}, {1.6392, 0.69144}, {1.8600, 0.65708}, {2.3129, 0.63069},
    {2.6000, 0.59619}, {3.0088, 0.58685}, {3.4508, 0.58591}, {3.7379, 0.55988}, {4.0031, 0.55932}};
constexpr std::size_t kHoernerPoints = sizeof kHoernerCurve / sizeof kHoernerCurve[0];

constexpr std::string_view kVariableLetters = "uvrpfdnbVRDNB";
/// Half the width of the blend between ahead and astern motion, over U.
constexpr double kAsternBlend = 0.1;

}  // namespace

double hoerner_drag(double ratio) noexcept {
    if (!(ratio > kHoernerCurve[0][0])) return kHoernerCurve[0][1];
    for (std::size_t i = 1; i < kHoernerPoints; ++i) {
        const double* a = kHoernerCurve[i - 1];
        const double* b = kHoernerCurve[i];
        if (ratio <= b[0]) return a[1] + (b[1] - a[1]) * (ratio - a[0]) / (b[0] - a[0]);
    }
    return kHoernerCurve[kHoernerPoints - 1][1];
}

namespace vessel {

int variable_of(char letter) noexcept {
    const auto at = kVariableLetters.find(letter);
    return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

Polynomial::Polynomial(const HullPolynomial& def, double mass) : def_(def), mass_(mass) {
    constexpr std::int32_t kAxes[] = {0, 1, 3, 5};
    for (const HullTerm& from : def.terms) {
        Term term;
        term.value = from.value;
        term.axis = kAxes[static_cast<std::size_t>(from.axis)];
        for (const char letter : from.of) {
            const int variable = variable_of(letter);
            if (variable < 0 || static_cast<std::size_t>(term.powers) >= kMaxPowers) continue;
            term.of[static_cast<std::size_t>(term.powers++)] = static_cast<std::uint8_t>(variable);
            term.driven = term.driven || variable == kRudder || variable == kAbsRudder ||
                          variable == kRevolutions || variable == kAbsRevolutions;
        }
        // With U₀, X of u alone holds the propeller at constant revolutions.
        term.propulsive = def.speed > 0.0 && term.axis == 0 &&
                          from.of.find_first_not_of("u0") == std::string::npos;
        terms_.push_back(term);
    }
}

double Polynomial::value(const Term& term, const Values& at) const noexcept {
    double out = term.value;
    for (std::int32_t i = 0; i < term.powers; ++i) out *= at[term.of[static_cast<std::size_t>(i)]];
    return out;
}

/// Return the force of the polynomial, as the weighted sum of its values for motion ahead and
/// astern. @param ahead  Weight of motion ahead; the rest is astern. @param astern_u  u' of the
/// mirrored ship.
Wrench Polynomial::sum(const Values& at, double ahead, double astern_u) const noexcept {
    Wrench out = Wrench::Zero();
    for (const Term& term : terms_)
        out[term.axis] += (term.propulsive ? 1.0 : ahead) * value(term, at);
    if (ahead == 1.0) return out;
    Values mirrored = at;
    mirrored[kU] = astern_u;
    for (const Variable i : {kR, kDrift}) mirrored[i] = -at[i];
    for (const Term& term : terms_) {
        if (term.driven || term.propulsive) continue;
        const double side = term.axis == 0 || term.axis == 5 ? -1.0 : 1.0;
        out[term.axis] += (1.0 - ahead) * side * value(term, mirrored);
    }
    return out;
}

Wrench Polynomial::force(const Flow& flow) const noexcept {
    if (terms_.empty()) return Wrench::Zero();
    return def_.scale == HullScale::speed ? by_speed(flow) : by_mass(flow);
}

Wrench Polynomial::by_speed(const Flow& flow) const noexcept {
    const double length = def_.length;
    const double speed =
        std::max(std::hypot(flow.u(), flow.v()), std::abs(flow.r()) * length / def_.most_turn);
    if (!(speed > 1e-9)) return Wrench::Zero();
    const double ahead = std::clamp(0.5 + flow.u() / (2.0 * kAsternBlend * speed), 0.0, 1.0);
    const double astern_u = std::clamp((-flow.u() - def_.speed) / speed, -1.0, 1.0);
    Values at{};
    at[kU] = std::clamp((flow.u() - def_.speed) / speed, -1.0, 1.0);
    at[kV] = flow.v() / speed;
    at[kR] = flow.r() * length / speed;
    at[kP] = flow.p() * length / speed;
    at[kRoll] = flow.roll;
    at[kRudder] = def_.rudder_sign * flow.rudder;
    at[kDrift] =
        std::atan2(flow.v(), std::max(std::abs(flow.u()), 1e-9)) * (flow.u() < 0.0 ? -1.0 : 1.0);
    at[kAbsV] = std::abs(at[kV]);
    at[kAbsR] = std::abs(at[kR]);
    at[kAbsRudder] = std::abs(at[kRudder]);
    at[kAbsDrift] = std::abs(at[kDrift]);
    Wrench out = sum(at, ahead, astern_u) * (0.5 * flow.density * def_.area * speed * speed);
    out[3] *= length;
    out[5] *= length;
    return out;
}

Wrench Polynomial::by_mass(const Flow& flow) const noexcept {
    const double speed = std::hypot(flow.u(), flow.v());
    const double ahead =
        speed > 1e-9 ? std::clamp(0.5 + flow.u() / (2.0 * kAsternBlend * speed), 0.0, 1.0) : 1.0;
    Values at{};
    at[kU] = flow.u();
    at[kV] = flow.v();
    at[kR] = flow.r();
    at[kP] = flow.p();
    at[kRoll] = flow.roll;
    at[kRudder] = def_.rudder_sign * flow.rudder;
    at[kRevolutions] = flow.rps;
    at[kDrift] =
        std::atan2(flow.v(), std::max(std::abs(flow.u()), 1e-9)) * (flow.u() < 0.0 ? -1.0 : 1.0);
    at[kAbsV] = std::abs(at[kV]);
    at[kAbsR] = std::abs(at[kR]);
    at[kAbsRudder] = std::abs(at[kRudder]);
    at[kAbsRevolutions] = std::abs(at[kRevolutions]);
    at[kAbsDrift] = std::abs(at[kDrift]);
    Wrench out = sum(at, ahead, -flow.u()) * mass_;
    const double square = def_.length * def_.length;
    out[3] *= square;
    out[5] *= square;
    return out;
}

double surge_force(const HullResistance& def, double u) noexcept {
    const double speed = std::abs(u);
    double drag = 0.0;
    const double sigma = 1.0 - std::tanh(speed / def.blend);
    drag += sigma * def.linear * speed + (1.0 - sigma) * def.quadratic * speed * speed;
    const auto& curve = def.curve;
    if (!curve.empty()) {
        if (speed >= curve.back().speed) {
            const double over = curve.back().speed > 0.0 ? speed / curve.back().speed : 1.0;
            drag += curve.back().resistance * over * over;
        } else {
            std::size_t i = 1;
            while (curve[i].speed <= speed) ++i;
            const ResistancePoint &a = curve[i - 1], &b = curve[i];
            drag += a.resistance +
                    (b.resistance - a.resistance) * (speed - a.speed) / (b.speed - a.speed);
        }
    }
    return u < 0.0 ? drag : -drag;
}

Wrench cross_flow_force(const CrossFlow& def, const Flow& flow) noexcept {
    Wrench out = Wrench::Zero();
    if (!(def.length > 0.0)) return out;
    const double drag = def.drag > 0.0 ? def.drag : hoerner_drag(0.5 * def.beam / def.draught);
    const double width = def.length / def.strips;
    const int count = def.end_strips ? def.strips + 1 : def.strips;
    const double first = -0.5 * def.length + (def.end_strips ? 0.0 : 0.5 * width);
    for (int i = 0; i < count; ++i) {
        const double x = first + i * width, across = flow.v() + x * flow.r();
        const double f =
            -0.5 * flow.density * def.draught * drag * std::abs(across) * across * width;
        out[1] += f;
        out[5] += x * f;
    }
    return out;
}

}  // namespace vessel
}  // namespace hawser
