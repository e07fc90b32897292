// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file page_files.h
/// Files of the page inside the program. The server serves these files only.
///
/// `make view` builds the page with node and writes build/page/page_files.cpp, which defines
/// page_files(). A program that was configured without it has fallback/page_files.cpp.

#include <span>
#include <string_view>

namespace hawser::live {

struct PageFile {
    std::string_view path;  ///< Path as in a request: "/", "/view.js".
    std::string_view type;  ///< Content-Type.
    /// Contents, compressed by gzip. Contents that do not begin with 1f 8b are not compressed.
    std::span<const unsigned char> gzip;
};

[[nodiscard]] std::span<const PageFile> page_files();

/// True if the program contains the page, not only the note of fallback/page_files.cpp.
[[nodiscard]] inline bool has_page() {
    for (const PageFile& file : page_files())
        if (file.path == "/view.js") return true;
    return false;
}

}  // namespace hawser::live
