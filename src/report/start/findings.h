// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file findings.h
/// Findings of a check of a start, in words.

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::report::start {

enum class FindingKind : std::uint8_t {
    contradiction,  ///< Joints, motors or prescribed motions that are inconsistent.
    repeated,       ///< Redundant joints.
    motor,          ///< A motor against a fixed part or another motor.
    overlap,        ///< Shapes inside each other. value: depth [m].
    gap,            ///< A joint that starts open. value: [m or rad].
    speed,          ///< A joint with inconsistent initial velocities. value: [m/s or rad/s].
    tension,        ///< A line that starts beyond its breaking load. value: tension [N].
    density,        ///< A mass that does not fit the size. value: [kg/m³].
    inertia,        ///< An inertia of another size. value: (radius of its mass/half diagonal)².
    wire_step,  ///< A wire whose transverse vibration the step does not resolve. value: h √(T/ρ)/l.
    joint_step,  ///< A joint about which a body swings faster than the step. value: h² f r/I.
    spin_step,   ///< A body that turns too far in a step. value: [rad].
    /// A hull that does not carry its mass, or rods that add displacement. value: mass of the body
    /// over that of the water.
    displacement,
    dry,    ///< A cable without loads of the sea, or without drag. value: its length [m].
    depth,  ///< A seabed that differs from the sea's depth. value: difference [m].
    /// A hull in waves too short for constant coefficients. value: wavelength over length.
    short_waves,
    memory,      ///< A radiation memory that is cut too early. value: K(T)/K(0).
    stiffness,   ///< EA that does not fit a diameter. value: EA/d² [N/m²].
    brake,       ///< A winch that starts braked without a brake.
    drum,        ///< A bare drum that keeps one element. value: length that it hauls [m].
    points,      ///< An exercise that cannot be passed. value: points needed less possible.
    post,        ///< A bollard that never engages a nearby cable. value: distance [m].
    unexamined,  ///< Too large to be checked. value: rows or bodies.
    vessel,      ///< Coefficients of a vessel outside the range of published ships. value: 0.
    phase,       ///< A phase of an exercise without an end condition. value: its index.
    goal,        ///< A goal that no control can reach in time. value: time that is missing [s].
    station,     ///< A station without inputs. value: its index.
    range,       ///< A control of a station without a range. value: index of its station.
};
inline constexpr int kFindingKindCount = 28;
[[nodiscard]] const char* to_string(FindingKind kind) noexcept;

struct Finding {
    bool error = false;  ///< False: a warning.
    FindingKind kind = FindingKind::unexamined;
    std::vector<std::string> about;  ///< Names of bodies, interactions, cables, shapes.
    double value = 0.0;              ///< See FindingKind.
    std::string text;                ///< Object, place, amount and remedy.
};

struct Findings {
    std::vector<Finding> list;  ///< Errors first, then by kind, the worst first.

    void add(bool error, FindingKind kind, std::vector<std::string> about, double value,
             std::string text);
    void sort();
    [[nodiscard]] std::size_t errors() const;
    [[nodiscard]] std::size_t warnings() const { return list.size() - errors(); }
};

/// Number of findings of one kind that a text lists.
inline constexpr std::size_t kListedOfAKind = 5;

/// Return one line for each finding, with the prefix `before`: the worst kListedOfAKind of each
/// kind, and the number of others.
[[nodiscard]] std::string to_text(const Findings& findings, const std::string& before);

}  // namespace hawser::report::start
