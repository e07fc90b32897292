// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file files.h
/// Whole files in and out: plain ones only, and written so that a reader finds the old one or the
/// new one. What a pipe or a file full of holes would do to a program that reads to the end is
/// told before.
///
/// Functions return why something cannot be done, to go behind the name of the file; "" if it can.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace hawser::record {

/// Longer files of which less than a sixteenth is on the disk are not read: they come from no
/// program that writes results, and would fill the memory with zeros [bytes].
inline constexpr std::size_t kSparse = std::size_t{1} << 24;

/// Read a file that exists, is plain and not sparse. Waits for nothing.
/// @param most  Longer ones are refused [bytes]. @throws std::bad_alloc.
[[nodiscard]] std::string read_file(const std::filesystem::path& file, std::vector<std::byte>& out,
                                    std::size_t most = ~std::size_t{0});
[[nodiscard]] std::string read_file(const std::filesystem::path& file, std::string& out,
                                    std::size_t most = ~std::size_t{0});

/// Why a file cannot be written: no folder, no right to, or something there that is no plain file.
/// A character device (/dev/null) is one that can. Leaves what is there alone.
[[nodiscard]] std::string output_fault(const std::filesystem::path& file);

/// When what is written goes to the disk: before the file gets its name, or, of many files that
/// belong together, with flush_folder() behind the last of them.
enum class Flush { now, later };

/// Write a file under another name beside its own and rename it, so that whatever ends this, there
/// is the old one or the new one. A symbolic link stays, what it names is written; a device is
/// written as it is.
[[nodiscard]] std::string write_file(const std::filesystem::path& file,
                                     std::span<const std::byte> bytes, Flush flush = Flush::now);
[[nodiscard]] std::string write_file(const std::filesystem::path& file, const std::string& text,
                                     Flush flush = Flush::now);
/// Brings what was written in a folder with Flush::later to the disk. @return why not; "": done.
[[nodiscard]] std::string flush_folder(const std::filesystem::path& folder);

/// Whether two names are those of one file, existing or not. @throws std::bad_alloc.
[[nodiscard]] bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace hawser::record
