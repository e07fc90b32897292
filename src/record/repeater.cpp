// SPDX-License-Identifier: Apache-2.0
#include <hawser/hawser.h>
#include <hawser/recording.h>

#include "record/changes.h"

namespace hawser::record {

void Repeater::before_step(World& world) {
    const auto& inputs = recording_.inputs;
    const auto& changes = recording_.changes;
    const auto& cuts = recording_.cuts;
    const std::int64_t now = world.step_count();
    for (;;) {
        const bool due = change_ < changes.size() && changes[change_].step <= now;
        if (due && changes[change_].inputs_before <= input_) {
            apply_changes(changes[change_++].bytes, world);
        } else if (input_ < inputs.size() && inputs[input_].step <= now) {
            world.set_input({inputs[input_].input}, inputs[input_].value);
            ++input_;
        } else {
            break;
        }
    }
    while (cut_ < cuts.size() && cuts[cut_].step < now) ++cut_;
    if (cut_ < cuts.size() && cuts[cut_].step == now) world.degrade_next_step(cuts[cut_].left_out);
}

}  // namespace hawser::record
