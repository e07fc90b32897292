// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rig.h
/// A wire around a bollard, as every engine of `hawser-bench wires` builds it.
///
/// ```
///              ╭───╮            bollard: radius 0.5 m to the middle of the wire, along y, fixed;
///     weight   │   │   pull     μ = 0.25; half a turn, one and a half, three turns
///       W ◄────╯   ╰────► P
/// ```
/// The weight is a body of 1,000 kg on a leg of 2 m with the force W = 1,000 kg g; the pull is the
/// force P on a body of 100 kg at the other end. Other bodies have no weight, so that Euler's ratio
/// e^{μθ} (L. Euler, 1762; J. A. Eytelwein, 1808) is exact also for a wire with mass: it is the
/// expected P/W at which the wire slips. Turns lie over each other, and wires do not touch
/// themselves.
///
/// Chains of straight elements lie around the bollard as a polygon. Each touching element has its
/// middle on it, and the legs before and after them are free: they turn by θ in all.
///
/// Compiled as C++17, too: Simbody's headers are not C++20.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace hawser::bench::wires {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kFrame = 1.0 / 60.0;  ///< [s]
inline constexpr double kRadius = 0.5;        ///< Radius of the bollard to the middle of the wire
                                              ///< [m].
inline constexpr double kWireRadius = 0.027;  ///< Radius of the wire [m]: 54 mm have 2.33e8 N.
inline constexpr double kDensity = 23.0;      ///< Mass per length of the wire [kg/m].
inline constexpr double kEA = 2.33e8;         ///< [N]
inline constexpr double kRub = 0.25;          ///< μ
inline constexpr double kWeight = 1000.0;     ///< Mass of the weight [kg].
inline constexpr double kW = kWeight * 9.81;  ///< [N]
inline constexpr double kPulled = 100.0;      ///< Mass of the body that is pulled [kg].
inline constexpr double kLeg = 2.0;           ///< Length from the bollard to either body [m].
inline constexpr int kLegElements = 4;        ///< Number of elements of a chain's leg.

/// A wire around a bollard in one engine, advanced frame by frame.
class Rig {
  public:
    virtual ~Rig() = default;
    Rig() = default;
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;

    /// Set the forces along the legs, away from the bollard, from the next substep on [N].
    virtual void load(double weight, double pull) = 0;
    /// Advance by a substep. @return false if it failed.
    virtual bool substep() = 0;
    /// Return the displacement of the weight towards the bollard since the start [m].
    [[nodiscard]] virtual double displacement() const = 0;
    /// Return the largest distance between jointed ends [m]; 0 without joints.
    [[nodiscard]] virtual double gap() const { return 0.0; }
    /// Return the settings that are needed to repeat the run, in a few words.
    [[nodiscard]] virtual std::string settings() const = 0;
};

/// Shape of a chain: nodes from the weight to the pull [m], in the plane x-z.
struct ChainShape {
    std::vector<std::array<double, 2>> nodes;
    std::array<double, 2> out{};  ///< Direction of the pull. The direction of the weight is (0,
                                  ///< −1).
    int touching = 0;             ///< Number of elements on the bollard, after kLegElements of the
                                  ///< first leg.
};

/// Return the angle by which each of `n` elements on the bollard turns the wire [rad].
inline double turn_of_element(double turns, int n) { return 2.0 * kPi * turns / n; }

inline ChainShape chain_shape(double turns, int n) {
    const double turn = turn_of_element(turns, n);
    // Vertices of the polygon whose sides touch the circle with their middles.
    const double out = kRadius / std::cos(0.5 * turn);
    ChainShape s;
    s.touching = n;
    for (int i = kLegElements; i > 0; --i) s.nodes.push_back({-out, -kLeg * i / kLegElements});
    for (int i = 0; i <= n; ++i)
        s.nodes.push_back({-out * std::cos(i * turn), out * std::sin(i * turn)});
    const double all = n * turn;
    s.out = {std::sin(all), std::cos(all)};
    const std::array<double, 2> last = s.nodes.back();
    for (int i = 1; i <= kLegElements; ++i)
        s.nodes.push_back({last[0] + s.out[0] * kLeg * i / kLegElements,
                           last[1] + s.out[1] * kLeg * i / kLegElements});
    return s;
}

/// Return ln(P/W) at which a polygon of nodes slips, with contacts in the middles of its elements,
/// half of each at the adjacent nodes. With T and N increasing by ρ per node, k = (ρ − 1)/(ρ + 1),
/// τ = tan(α/2), the balance of a node along and across the bisector gives μτk² + (1 + τ²)k = μτ.
/// Less than μθ.
inline double lump_exponent(double turns, int n) {
    const double half = std::tan(0.5 * turn_of_element(turns, n));
    const double rub = kRub * half, linear = 1.0 + half * half;
    const double k = 2.0 * rub / (linear + std::sqrt(linear * linear + 4.0 * rub * rub));
    return 2.0 * n * std::atanh(k);
}

/// Return the start of the search for rigid links, each pulled at half its turn to its side. There
/// is no closed form: links lean on their neighbours, and those of few links per turn slip far
/// below it.
inline double link_exponent(double turns, int n) {
    return 2.0 * n * std::atanh(std::min(0.99, kRub * std::tan(0.5 * turn_of_element(turns, n))));
}

std::unique_ptr<Rig> make_route(double turns, int places);
std::unique_ptr<Rig> make_guide(double turns);
std::unique_ptr<Rig> make_segments(double turns, int elements);
/// Make a rig. Null if the engine is not in this build, or does not have the case.
std::unique_ptr<Rig> make_mujoco_tendon(double turns, int substeps);
std::unique_ptr<Rig> make_mujoco_chain(double turns, int elements, int substeps, bool noslip);
std::unique_ptr<Rig> make_bullet_chain(double turns, int elements, int substeps);
std::unique_ptr<Rig> make_simbody_cable(double turns, int substeps);

}  // namespace hawser::bench::wires
