// SPDX-License-Identifier: Apache-2.0
/// Names of statuses, stages, events and bounds.
#include <hawser/stats.h>

#include "world/checks.h"

#include <cstddef>
#include <string>

namespace hawser {

const char* to_string(Status status) noexcept {
    switch (status) {
        case Status::ok:
            return "ok";
        case Status::wrong_pivot:
            return "wrong_pivot";
        case Status::not_finite:
            return "not_finite";
        case Status::out_of_memory:
            return "out_of_memory";
        case Status::cancelled:
            return "cancelled";
        case Status::over_bound:
            return "over_bound";
        case Status::diverged:
            return "diverged";
        case Status::bad_load:
            return "bad_load";
        case Status::bad_edit:
            return "bad_edit";
        case Status::in_use:
            return "in_use";
    }
    return "?";
}

std::string to_string(const BoundMet& met) {
    const std::string value = world::number(met.value), limit = world::number(met.limit);
    switch (met.bound) {
        case Bound::none:
            return "";
        case Bound::contacts:
            return value + " contact points exceed max_contacts = " + limit +
                   "; raise it, or separate overlapping shapes";
        case Bound::pairs:
            return value +
                   " pairs of shapes near each other (and more) exceed 8 max_contacts = " + limit +
                   "; raise it, or separate overlapping shapes";
        case Bound::memory:
            return value + " bytes exceed max_memory = " + limit +
                   "; raise it if the machine has more memory, or make the scene smaller";
    }
    return "?";
}

const char* to_string(Stage stage) noexcept {
    constexpr const char* kNames[kStageCount] = {"prestep",  "collide", "graph",     "analyse",
                                                 "assemble", "factor",  "nonsmooth", "integrate"};
    return kNames[static_cast<std::size_t>(stage)];
}

const char* to_string(DegradedBy cause) noexcept {
    constexpr const char* kNames[] = {"nothing", "prediction", "clock", "work", "order"};
    return kNames[static_cast<std::size_t>(cause)];
}

const char* to_string(EventKind kind) noexcept {
    constexpr const char* kNames[kEventKindCount] = {"line_break",
                                                     "slack",
                                                     "taut",
                                                     "saturation",
                                                     "range",
                                                     "input_clamped",
                                                     "warning",
                                                     "energy_created",
                                                     "joint_open",
                                                     "cable_law",
                                                     "uncertified",
                                                     "fast",
                                                     "layer",
                                                     "brake_slip",
                                                     "release",
                                                     "weak_link",
                                                     "drum_empty",
                                                     "cut",
                                                     "join",
                                                     "detach",
                                                     "chain_jump",
                                                     "no_node",
                                                     "node_limit",
                                                     "render",
                                                     "alarm",
                                                     "alarm_end",
                                                     "overload",
                                                     "missed",
                                                     "hauled_in",
                                                     "lift_off",
                                                     "lay_on",
                                                     "incomplete",
                                                     "shed",
                                                     "failure",
                                                     "mode_refused",
                                                     "position_lost",
                                                     "failure_critical"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace hawser
