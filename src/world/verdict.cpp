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
        "take a smaller step (settings.step); if that does not help, look for joints that "
        "contradict each other with 'hawser check'",
        "look for joints or ranges that contradict each other, or that cannot close from where the "
        "bodies start, with 'hawser check', and for what presses harder than a range or a material "
        "(stiffness) bears; else take a smaller step (settings.step)",
        "take a smaller step (settings.step), or fewer and longer elements",
        "take a smaller step (settings.step), or lift the budget of the step",
        "take a smaller step (settings.step): what turns by more than 0.5 rad in one is not "
        "followed"};
    return kRemedies[static_cast<std::size_t>(judge)];
}

}  // namespace hawser
