// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rig.h
/// A wire around a post, as modelled by every engine of `hawser-bench wires`.
///
/// ```
///              ╭───╮            post: radius 0.5 m to the middle of the wire, along y, does not
///     weight   │   │   pull     turn; μ = 0.25; half a turn, one and a half, three turns
///       W ◄────╯   ╰────► P
/// ```
/// The weight is a body of 1,000 kg on a leg of 2 m with the force W = 1,000 kg g. The pull is the
/// force P on a body of 100 kg at the other end. No other body has weight. Euler's ratio e^{μθ} (L.
/// Euler, 1762; J. A. Eytelwein, 1808) is then exact for P/W at slip, also for a wire with mass.
/// Turns may overlap: the wire does not touch itself.
///
/// A chain of straight elements surrounds the post as a polygon. Each touching element touches with
/// its middle; the legs before and behind are free. The elements turn by θ in total.
///
/// The file must also compile as C++17: the headers of Simbody are not C++20.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace hawser::bench::wires {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kFrame = 1.0 / 60.0;  ///< [s]
inline constexpr double kRadius = 0.5;  ///< Radius of the post, to the middle of the wire [m].
inline constexpr double kWireRadius = 0.027;  ///< Radius of the wire [m]: 54 mm have 2.33e8 N.
inline constexpr double kDensity = 23.0;      ///< Density of the wire [kg/m].
inline constexpr double kEA = 2.33e8;         ///< [N]
inline constexpr double kRub = 0.25;          ///< μ
inline constexpr double kWeight = 1000.0;     ///< Mass of the weight [kg].
inline constexpr double kW = kWeight * 9.81;  ///< [N]
inline constexpr double kPulled = 100.0;      ///< Mass of the body that is pulled [kg].
inline constexpr double kLeg = 2.0;           ///< From the post to either of them [m].
inline constexpr int kLegElements = 4;        ///< Elements of the leg of a chain.

/// A wire around a post in one engine, advanced frame by frame.
class Rig {
  public:
    virtual ~Rig() = default;
    Rig() = default;
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;

    /// Forces along the legs, away from the post, from the next substep on [N].
    virtual void load(double weight, double pull) = 0;
    /// Take one substep. @return false if it failed.
    virtual bool substep() = 0;
    /// Return the displacement of the weight towards the post since the start [m].
    [[nodiscard]] virtual double way() const = 0;
    /// Return the largest distance between ends that a joint connects [m]; 0 if there is none.
    [[nodiscard]] virtual double gap() const { return 0.0; }
    /// Return the settings that reproduce the run, in a few words.
    [[nodiscard]] virtual std::string settings() const = 0;
};

/// Shape of a chain: nodes from the weight to the pull [m], in the plane x-z.
struct ChainShape {
    std::vector<std::array<double, 2>> nodes;
    std::array<double, 2> out{};  ///< Direction of the pull. That of the weight is (0, −1).
    int touching = 0;             ///< Elements on the post, after kLegElements of the first leg.
};

/// Angle by which each of `n` elements on the post turns the wire [rad].
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

/// Return ln(P/W) at which a polygon of lumps slips. Contacts act in the middles of its elements,
/// half at each lump. With T and N growing by ρ per lump, k = (ρ − 1)/(ρ + 1) and τ = tan(α/2),
/// balance of a lump along and across the bisector gives μτk² + (1 + τ²)k = μτ. The result is less
/// than μθ.
inline double lump_exponent(double turns, int n) {
    const double half = std::tan(0.5 * turn_of_element(turns, n));
    const double rub = kRub * half, linear = 1.0 + half * half;
    const double k = 2.0 * rub / (linear + std::sqrt(linear * linear + 4.0 * rub * rub));
    return 2.0 * n * std::atanh(k);
}

/// Return the start of the search for rigid links, each pulled at half its turn on either side.
/// There is no closed form: links support each other, and with few links a turn they slip far below
/// it.
inline double link_exponent(double turns, int n) {
    return 2.0 * n * std::atanh(std::min(0.99, kRub * std::tan(0.5 * turn_of_element(turns, n))));
}

std::unique_ptr<Rig> make_route(double turns, int places);
std::unique_ptr<Rig> make_guide(double turns);
std::unique_ptr<Rig> make_segments(double turns, int elements);
/// Return the rig; null if the engine is not in this build or does not support the case.
std::unique_ptr<Rig> make_mujoco_tendon(double turns, int substeps);
std::unique_ptr<Rig> make_mujoco_chain(double turns, int elements, int substeps, bool noslip);
std::unique_ptr<Rig> make_bullet_chain(double turns, int elements, int substeps);
std::unique_ptr<Rig> make_simbody_cable(double turns, int substeps);

}  // namespace hawser::bench::wires
