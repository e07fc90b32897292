// SPDX-License-Identifier: Apache-2.0
#include "report/start/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace hawser::report::start {

const char* to_string(FindingKind kind) noexcept {
    constexpr const char* kNames[kFindingKindCount] = {
        "contradiction", "repeated", "motor",   "overlap",     "gap",        "speed",
        "tension",       "density",  "inertia", "wire_step",   "joint_step", "spin_step",
        "displacement",  "dry",      "depth",   "short_waves", "memory",     "stiffness",
        "brake",         "drum",     "points",  "post",        "unexamined", "vessel",
        "phase",         "goal",     "station", "range"};
    return kNames[static_cast<std::size_t>(kind)];
}

void Findings::add(bool error, FindingKind kind, std::vector<std::string> about, double value,
                   std::string text) {
    list.push_back({error, kind, std::move(about), value, std::move(text)});
}

void Findings::sort() {
    std::stable_sort(list.begin(), list.end(), [](const Finding& a, const Finding& b) {
        if (a.error != b.error) return a.error;
        if (a.kind != b.kind) return a.kind < b.kind;
        return a.value > b.value;
    });
}

std::size_t Findings::errors() const {
    return static_cast<std::size_t>(
        std::count_if(list.begin(), list.end(), [](const Finding& f) { return f.error; }));
}

std::string to_text(const Findings& findings, const std::string& before) {
    std::string text;
    std::array<std::array<std::size_t, kFindingKindCount>, 2> count{};
    for (const Finding& f : findings.list) {
        const char* what = f.error ? "error" : "warning";
        const std::size_t n = ++count[f.error ? 1 : 0][static_cast<std::size_t>(f.kind)];
        if (n <= kListedOfAKind)
            fmt::format_to(std::back_inserter(text), "{}{}: {}\n", before, what, f.text);
    }
    for (const bool error : {true, false})
        for (int k = 0; k < kFindingKindCount; ++k) {
            const std::size_t n = count[error ? 1 : 0][static_cast<std::size_t>(k)];
            if (n > kListedOfAKind)
                fmt::format_to(std::back_inserter(text), "{}{}: and {} more of the kind \"{}\"\n",
                               before, error ? "error" : "warning", n - kListedOfAKind,
                               to_string(static_cast<FindingKind>(k)));
        }
    return text;
}

}  // namespace hawser::report::start
