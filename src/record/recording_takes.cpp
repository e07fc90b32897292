// SPDX-License-Identifier: Apache-2.0
/// Check the order of a recording's entries. Steps ascend within a branch. If the run restored one
/// of its own states, a branch ends and the next one starts at the step of that state.
#include <hawser/recording.h>

#include "record/recording_bytes.h"

#include <algorithm>

namespace hawser::record {

/// Return the least allowed step number of the next entry of the list `all`: that of the last entry
/// in the same branch.
template <class T>
std::int64_t Recording::least_step(const std::vector<T>& all,
                                   std::size_t RecordedTake::* before) const {
    const std::size_t first = takes.empty() ? 0 : takes.back().*before;
    if (all.size() > first) return all.back().step;
    return takes.empty() ? start_step : takes.back().to;
}

/// Read changes. The world that they are applied to checks their contents.
void Recording::read_changes(ByteReader in) {
    RecordedChanges out;
    out.step = get_step(in, least_step(changes, &RecordedTake::changes));
    out.inputs_before = inputs.size();
    out.bytes = in.take(in.bytes_left());
    changes.push_back(out);
}

void Recording::read_loads(ByteReader in) {
    RecordedLoads out;
    const std::size_t first = takes.empty() ? 0 : takes.back().loads;
    const std::int64_t least = least_step(loads, &RecordedTake::loads);
    out.step = get_step(in, loads.size() > first ? least + 1 : least);
    out.bytes = in.take(in.bytes_left());
    loads.push_back(out);
}

void Recording::read_inputs(ByteReader in) {
    std::vector<RecordedInput> input_changes(in.get_count(20));
    for (RecordedInput& change : input_changes) {
        change.step = get_step(in, least_step(inputs, &RecordedTake::inputs));
        change.input = in.get<std::int32_t>();
        change.value = get_finite(in);
        if (change.input < 0 ||
            (!input_names.empty() && static_cast<std::size_t>(change.input) >= input_names.size()))
            throw BadBytes("an index is out of range");
        inputs.push_back(change);
    }
    in.expect_end();
}

void Recording::add_cut(const RecordedCut& cut) {
    const std::size_t first = takes.empty() ? 0 : takes.back().cuts;
    const std::int64_t least = least_step(cuts, &RecordedTake::cuts);
    if (cut.step < least || (cuts.size() > first && cut.step == least))
        throw BadBytes("cuts are not in the order of time");
    cuts.push_back(cut);
}

/// Check the number of steps from the last frame to the new one. A gap longer than one stride of
/// frames is rejected.
void Recording::check_gap(std::int64_t step, bool frame) const {
    const bool begins_branch = frames_.size() == (takes.empty() ? 0 : takes.back().frames);
    const std::int64_t before = !begins_branch  ? frame_head(frames_.size() - 1).step
                                : takes.empty() ? start_step
                                                : takes.back().to;
    const std::int64_t gap = step - before;
    const bool first = frames_.empty() && frame;
    if (gap > settings.stride || gap < 0 || (first && gap != 0) ||
        (frame && !begins_branch && gap == 0))
        throw BadBytes("frames are not in the order of time");
}

void Recording::read_take(ByteReader in) {
    RecordedTake take;
    take.from = get_step(in, takes.empty() ? start_step : 0);
    take.to = get_step(in, 0);
    in.expect_end();
    take.frames = frames_.size();
    take.inputs = inputs.size();
    take.changes = changes.size();
    take.loads = loads.size();
    take.cuts = cuts.size();
    if (take.changes == (takes.empty() ? 0 : takes.back().changes) ||
        changes.back().step != take.from)
        throw BadBytes("a branch begins without a state");
    check_gap(take.from, false);
    takes.push_back(take);
}

std::size_t Recording::take_of(std::size_t frame) const noexcept {
    const auto behind =
        std::upper_bound(takes.begin(), takes.end(), frame,
                         [](std::size_t f, const RecordedTake& t) { return f < t.frames; });
    return static_cast<std::size_t>(behind - takes.begin());
}

}  // namespace hawser::record
