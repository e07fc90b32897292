// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file findings.h
/// What a check of a start found, in words.

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::report::start {

enum class FindingKind : std::uint8_t {
    contradiction,  ///< Joints, motors or prescribed motions that cannot all hold.
    repeated,       ///< Joints that hold the same thing twice.
    motor,          ///< A motor against what holds still, or against another motor.
    overlap,        ///< Shapes inside each other. value: depth [m].
    gap,            ///< A joint that starts open. value: [m or rad].
    speed,          ///< A joint whose bodies start with speeds that tear it. value: [m/s or rad/s].
    tension,        ///< A line that starts beyond its breaking load. value: tension [N].
    density,        ///< A mass that does not fit the size. value: [kg/m³].
    inertia,        ///< An inertia of another size. value: (radius of its mass/half diagonal)².
    wire_step,      ///< A wire whose sway the step does not resolve. value: h √(T/ρ)/l.
    joint_step,     ///< A joint about which a body swings faster than the step. value: h² f r/I.
    spin_step,      ///< A body that turns too far in a step. value: [rad].
    /// A hull that does not carry its mass, or rods that displace beside it. value: mass of the
    /// body over that of the water.
    displacement,
    dry,          ///< A cable that the sea does not act on, or without drag. value: its length [m].
    depth,        ///< A seabed that is not at the sea's depth. value: difference [m].
    short_waves,  ///< A hull in waves too short for constants. value: wavelength over length.
    memory,       ///< A radiation memory that is cut too early. value: K(T)/K(0).
    stiffness,    ///< EA that does not fit a diameter. value: EA/d² [N/m²].
    brake,        ///< A winch that starts braked without a brake.
    drum,         ///< A bare drum that keeps one element. value: length that it hauls [m].
    points,       ///< An exercise that cannot be passed. value: points needed less possible.
    post,         ///< A post that never takes a cable beside it. value: how far it is [m].
    unexamined,   ///< Too large to be looked at. value: rows or bodies.
    vessel,       ///< Coefficients of a vessel outside the range of published ships. value: 0.
};
inline constexpr int kFindingKindCount = 24;
[[nodiscard]] const char* to_string(FindingKind kind) noexcept;

struct Finding {
    bool error = false;  ///< Else a warning.
    FindingKind kind = FindingKind::unexamined;
    std::vector<std::string> about;  ///< Names of bodies, interactions, cables, shapes.
    double value = 0.0;              ///< See FindingKind.
    std::string text;                ///< What, where, how much, and what helps.
};

struct Findings {
    std::vector<Finding> list;  ///< Errors first, then by kind, the worst first.

    void add(bool error, FindingKind kind, std::vector<std::string> about, double value,
             std::string text);
    void sort();
    [[nodiscard]] std::size_t errors() const;
    [[nodiscard]] std::size_t warnings() const { return list.size() - errors(); }
};

/// Findings of one kind that a text lists one by one.
inline constexpr std::size_t kListedOfAKind = 5;

/// A line each, beginning with `before`; of each kind the worst kListedOfAKind and how many more.
[[nodiscard]] std::string to_text(const Findings& findings, const std::string& before);

}  // namespace hawser::report::start
