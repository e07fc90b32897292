// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file figure_file.h
/// Reference figures of scenes in a JSON file.
///
/// An entry has the number of steps, the tolerance, texts, counts and real numbers. A real number
/// passes if |value - reference| <= tolerance x scale. A third number is its own tolerance, in
/// place of that of the scene. A count that is null differs between instruction sets and is not
/// compared. The file leaves out counts and real numbers that are 0.

#include "golden/figures.h"

#include <filesystem>
#include <optional>
#include <utility>

namespace hawser::golden {

/// Figures of a scene in the form of the file.
struct Entry {
    int steps = 0;
    double tolerance = 0.0;
    std::map<std::string, std::string> texts;
    std::map<std::string, std::optional<std::int64_t>> counts;
    std::map<std::string, Real> reals;
};

using Entries = std::map<std::string, Entry>;

/// Read the entries of a file. @return nullopt if the file does not exist. @throws std::exception
/// if it cannot be read.
[[nodiscard]] Entries read_entries(const std::filesystem::path& file);
void write_entries(const std::filesystem::path& file, const Entries& entries);

/// Return a line for each figure that differs or is missing, with both values.
[[nodiscard]] std::string compare(const Entry& reference, const Figures& figures);

/// Make an entry of the figures. @param steps  Steps that were requested.
[[nodiscard]] Entry entry_of(const Figures& figures, int steps);

/// Widen an entry by the figures of another instruction set. A tolerance becomes 1,000 times the
/// largest difference of the scene, between 1e-9 and 1e-6. A figure with a larger difference gets
/// its own tolerance, up to 1e-4. Counts that differ become null. @return the name of the real
/// number with the largest difference, and this difference in units of its scale.
std::pair<std::string, double> widen(Entry& entry, const Figures& figures);

}  // namespace hawser::golden
