// SPDX-License-Identifier: Apache-2.0
/// Names of the quantities that a world monitors.
#include <hawser/stats.h>

#include <cstddef>

namespace hawser {

const char* to_string(Judge judge) noexcept {
    constexpr const char* kNames[kJudgeCount] = {"energy", "violation", "cable law", "certificate",
                                                 "speed"};
    return kNames[static_cast<std::size_t>(judge)];
}

const char* to_string(Grade grade) noexcept {
    constexpr const char* kNames[] = {"good", "doubtful", "wrong"};
    return kNames[static_cast<std::size_t>(grade)];
}

const char* remedy(Judge judge) noexcept {
    constexpr const char* kRemedies[kJudgeCount] = {
        "use a smaller step (settings.step); if that does not help, check for inconsistent joints "
        "with 'hawser check'",
        "check with 'hawser check' for inconsistent joints or ranges and for joints that cannot "
        "close; check for loads beyond the stiffness of a range or material; otherwise use a "
        "smaller step (settings.step)",
        "use a smaller step (settings.step), or fewer and longer elements",
        "use a smaller step (settings.step), or raise the budget of the step",
        "use a smaller step (settings.step): rotations above 0.5 rad per step are not resolved"};
    return kRemedies[static_cast<std::size_t>(judge)];
}

}  // namespace hawser
