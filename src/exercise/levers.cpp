// SPDX-License-Identifier: Apache-2.0
#include "exercise/levers.h"

#include <hawser/hawser.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hawser::exercise {
namespace {

/// Tolerance of times, which are multiples of the step up to rounding [s].
constexpr double kLeverRounding = 1e-9;
/// Largest number of delayed values; older ones are dropped.
constexpr std::size_t kMaxLate = 4096;

bool equal_or_both_nan(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

Controls::Control& Controls::control(const Session& session, const std::string& input) {
    const auto [at, fresh] = controls_.try_emplace(input);
    if (fresh) at->second.start = present_value(session.world(), input);
    return at->second;
}

double Controls::requested(const std::string& input) const noexcept {
    const auto at = controls_.find(input);
    return at == controls_.end() ? kDefault : at->second.requested;
}

void Controls::ask(const Session& session, const std::string& input, double value) {
    Control& l = control(session, input);
    for (const Fault* f : l.faults)
        if (f->kind == FaultKind::input_late) {
            if (std::isnan(l.passed)) l.passed = std::isnan(l.requested) ? l.start : l.requested;
            if (l.delayed.size() == kMaxLate) l.delayed.pop_front();
            l.delayed.emplace_back(session.time() + f->delay, value);
            break;
        }
    l.requested = value;
}

void Controls::begin(const Session& session, const Fault& fault) {
    std::vector<FaultyInput> inputs;
    if (fault.kind == FaultKind::input_stuck || fault.kind == FaultKind::input_late)
        inputs.push_back({resolve_target(session.scene(), fault.target, 0.0).first, false});
    else if (fault.kind == FaultKind::motor_loses_force || fault.kind == FaultKind::brake_slips)
        inputs = faulty_inputs(fault, session.world());
    for (const auto& [input, mode] : inputs) {
        Control& l = control(session, input);
        l.mode = l.mode || mode;
        l.faults.push_back(&fault);
        if (fault.kind == FaultKind::input_stuck)
            l.stuck[&fault] =
                std::isnan(fault.value)
                    ? present_value(session.world(), input)
                    : resolve_target(session.scene(), fault.target, fault.value).second;
    }
}

void Controls::end(const Fault& fault) {
    for (auto& [name, l] : controls_) {
        std::erase(l.faults, &fault);
        l.stuck.erase(&fault);
        const bool delayed = std::any_of(l.faults.begin(), l.faults.end(), [](const Fault* f) {
            return f->kind == FaultKind::input_late;
        });
        if (delayed) continue;
        l.delayed.clear();
        l.passed = kDefault;
    }
}

/// Return the value in force for a requested value. Faults are applied in this order: delays,
/// scaled values, stuck inputs.
double Controls::let_through(Control& l, double now) {
    double value = std::isnan(l.requested) ? l.start : l.requested;
    while (!l.delayed.empty() && l.delayed.front().first <= now + kLeverRounding) {
        l.passed = l.delayed.front().second;
        l.delayed.pop_front();
    }
    if (!std::isnan(l.passed)) value = l.passed;
    for (const Fault* f : l.faults) {
        if (f->kind == FaultKind::brake_slips) value *= f->share;
        if (f->kind != FaultKind::motor_loses_force) continue;
        if (!l.mode)
            value *= f->share;
        else if (value < static_cast<double>(WinchMode::brake) - 0.5 ||
                 value > static_cast<double>(WinchMode::release) + 0.5)
            value = static_cast<double>(WinchMode::free);
    }
    for (const Fault* f : l.faults)
        if (f->kind == FaultKind::input_stuck) value = l.stuck.at(f);
    return value;
}

void Controls::apply(Session& session) {
    for (auto& [name, l] : controls_) {
        const bool touched =
            !std::isnan(l.requested) || !l.faults.empty() || !std::isnan(l.applied);
        if (!touched) continue;
        const double value = let_through(l, session.time());
        if (equal_or_both_nan(value, l.applied)) continue;
        session.set_input(name, value);
        l.applied = value;
    }
}

void Controls::forget_applied() {
    for (auto& [name, l] : controls_) l.applied = kDefault;
}

}  // namespace hawser::exercise
