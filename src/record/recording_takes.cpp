// SPDX-License-Identifier: Apache-2.0
/// Order of what a recording holds. Steps ascend; where the run went to another state of its own a
/// take ends, and they begin anew with those of that state.
#include <hawser/recording.h>

#include "record/recording_bytes.h"

#include <algorithm>

namespace hawser::record {

/// The least step that the next one of `all` may have: that of the last one of the same take.
template <class T>
std::int64_t Recording::least_step(const std::vector<T>& all,
                                   std::size_t RecordedTake::* before) const {
    const std::size_t first = takes.empty() ? 0 : takes.back().*before;
    if (all.size() > first) return all.back().step;
    return takes.empty() ? start_step : takes.back().to;
}

/// What the bytes say is for the world to judge that they are done to.
void Recording::read_changes(ByteReader in) {
    RecordedChanges out;
    out.step = get_step(in, least_step(changes, &RecordedTake::changes));
    out.inputs_before = inputs.size();
    out.bytes = in.take(in.left());
    changes.push_back(out);
}

void Recording::read_loads(ByteReader in) {
    RecordedLoads out;
    const std::size_t first = takes.empty() ? 0 : takes.back().loads;
    const std::int64_t least = least_step(loads, &RecordedTake::loads);
    out.step = get_step(in, loads.size() > first ? least + 1 : least);
    out.bytes = in.take(in.left());
    loads.push_back(out);
}

void Recording::read_inputs(ByteReader in) {
    std::vector<RecordedInput> given(in.get_count(20));
    for (RecordedInput& change : given) {
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

/// Steps from the last frame to one that comes now, and whether a gap that long may be: a replay
/// takes no more of them than frames of a stride explain.
void Recording::check_gap(std::int64_t step, bool frame) const {
    const bool begins = frames_.size() == (takes.empty() ? 0 : takes.back().frames);
    const std::int64_t before = !begins         ? frame_head(frames_.size() - 1).step
                                : takes.empty() ? start_step
                                                : takes.back().to;
    const std::int64_t gap = step - before;
    const bool first = frames_.empty() && frame;
    if (gap > settings.stride || gap < 0 || (first && gap != 0) || (frame && !begins && gap == 0))
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
        throw BadBytes("a take begins without a state to begin with");
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
