// SPDX-License-Identifier: Apache-2.0
#include "record/recording_outputs.h"

#include <hawser/recording.h>

#include "record/recording_bytes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hawser::record {

bool OutputFollower::changed(const World& world) {
    const auto now = world.output_ids();
    if (std::equal(now.begin(), now.end(), outputs_.begin(), outputs_.end())) return false;
    outputs_.assign(now.begin(), now.end());
    return true;
}

void OutputFollower::write_names(ByteWriter& out, const World& world) const {
    out.put(static_cast<std::uint32_t>(outputs_.size()));
    for (const OutputId id : outputs_) {
        const OutputDef& output = world.output_def(id);
        out.put_text(output.name);
        out.put_text(output.unit);
    }
}

void OutputFollower::write_values(ByteWriter& out, const World& world) const {
    constexpr double kMaximum = std::numeric_limits<double>::max();
    const auto values = world.outputs();
    for (const OutputId id : outputs_) {
        const double value = values[static_cast<std::size_t>(id.index)];
        out.put(std::isnan(value) ? value : std::clamp(value, -kMaximum, kMaximum));
    }
}

/// Read the outputs that apply from the next frame on. An output with the name and unit of an
/// earlier one continues it.
void Recording::read_output_names(ByteReader in) {
    OutputTable table;
    table.first_frame = frames_.size();
    table.outputs.resize(in.get_count(8));
    for (std::int32_t& index : table.outputs) {
        RecordedOutput output;
        output.name = in.get_text();
        output.unit = in.get_text();
        const auto next = static_cast<std::int32_t>(outputs.size());
        const auto [known, added] =
            output_indices_.try_emplace(std::pair(output.name, output.unit), next);
        index = known->second;
        if (added) outputs.push_back(std::move(output));
    }
    in.expect_end();
    output_tables_.push_back(std::move(table));
}

/// Read the values of the outputs at the last frame.
void Recording::read_output_values(std::span<const std::byte> payload) {
    if (output_tables_.empty()) throw BadBytes("values of outputs without names");
    OutputTable& table = output_tables_.back();
    if (frames_.size() != table.first_frame + table.values.size() + 1 ||
        payload.size() != 8 * table.outputs.size())
        throw BadBytes("values of outputs that do not exist");
    ByteReader in(payload);
    for (std::size_t k = 0; k < table.outputs.size(); ++k)
        if (std::isinf(in.get<double>())) throw BadBytes("a number is not finite");
    table.values.push_back(payload);
}

std::vector<double> Recording::output_values(std::size_t frame) const {
    std::vector<double> values(outputs.size(), std::numeric_limits<double>::quiet_NaN());
    const auto behind =
        std::upper_bound(output_tables_.begin(), output_tables_.end(), frame,
                         [](std::size_t f, const OutputTable& t) { return f < t.first_frame; });
    if (behind == output_tables_.begin()) return values;
    const OutputTable& table = *std::prev(behind);
    if (frame - table.first_frame >= table.values.size()) return values;
    ByteReader in(table.values[frame - table.first_frame]);
    for (const std::int32_t index : table.outputs)
        values[static_cast<std::size_t>(index)] = in.get<double>();
    return values;
}

}  // namespace hawser::record
