// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file files.h
/// Read and write whole plain files. Writing is atomic: a reader finds the old file or the new one.
/// Pipes and sparse files, which could block or exhaust a program that reads to the end, are
/// rejected before they are read.
///
/// Functions return the reason of a failure, to follow the name of the file; "" on success.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace hawser::record {

/// Size above which a file is rejected if less than a sixteenth of it is allocated on the disk
/// [bytes]. No program that writes results makes such files, and reading one would fill the memory
/// with zeros.
inline constexpr std::size_t kSparseFileSize = std::size_t{1} << 24;

/// Read a file that exists, is plain and not sparse. Does not block. @param most  Longer files are
/// rejected [bytes]. @throws std::bad_alloc.
[[nodiscard]] std::string read_file(const std::filesystem::path& file, std::vector<std::byte>& out,
                                    std::size_t most = ~std::size_t{0});
[[nodiscard]] std::string read_file(const std::filesystem::path& file, std::string& out,
                                    std::size_t most = ~std::size_t{0});

/// Return the reason why a file cannot be written: no folder, no permission, or the path is not a
/// plain file. A character device (/dev/null) is accepted. Does not change an existing file.
[[nodiscard]] std::string output_fault(const std::filesystem::path& file);

/// Time at which data is flushed to the disk. Value `now`: before the file gets its name. Value
/// `later`: by flush_folder(), after the last of many related files.
enum class Flush { now, later };

/// Write a file under another name in the same folder and rename it, so that after an interruption
/// either the old or the new file exists. If the path is a symbolic link, its target is replaced. A
/// device is written directly.
[[nodiscard]] std::string write_file(const std::filesystem::path& file,
                                     std::span<const std::byte> bytes, Flush flush = Flush::now);
[[nodiscard]] std::string write_file(const std::filesystem::path& file, const std::string& text,
                                     Flush flush = Flush::now);
/// Flush the files that were written in a folder with Flush::later to the disk. @return the reason
/// of a failure; "" on success.
[[nodiscard]] std::string flush_folder(const std::filesystem::path& folder);

/// True if two names belong to one file, existing or not. @throws std::bad_alloc.
[[nodiscard]] bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace hawser::record
