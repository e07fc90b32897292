// SPDX-License-Identifier: Apache-2.0
#include "draw/parted.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace hawser::draw {

namespace {

/// Return the index of the element "CABLE/sN" at the start of a position, as scenes name elements.
std::optional<std::int32_t> element_index(const record::RecordedCable& cable,
                                          std::string_view where) {
    const std::string front = cable.name + "/s";
    if (!where.starts_with(front)) return std::nullopt;
    where.remove_prefix(front.size());
    std::int32_t number = -1;
    const auto [end, error] = std::from_chars(where.data(), where.data() + where.size(), number);
    const bool whole = end == where.data() + where.size() || *end == ' ';
    if (error != std::errc{} || !whole || number < 0 || number >= cable.elements)
        return std::nullopt;
    return number;
}

}  // namespace

std::vector<BrokenElement> broken_elements(const record::Recording& recording, double until) {
    std::vector<BrokenElement> out;
    for (const record::RecordedEvent& event : recording.events) {
        if (event.kind != EventKind::line_break || event.time > until) continue;
        for (std::size_t c = 0; c < recording.cables.size(); ++c)
            if (const auto element = element_index(recording.cables[c], event.where))
                out.push_back({c, *element, event.time,
                               fmt::format("{} parted, {:.4g} s", event.where, event.time)});
    }
    return out;
}

bool is_broken(const std::vector<BrokenElement>& parted, std::size_t cable, std::int32_t element) {
    return std::any_of(parted.begin(), parted.end(), [&](const BrokenElement& p) {
        return p.cable == cable && p.element == element;
    });
}

}  // namespace hawser::draw
