// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file page_files.h
/// The files of the page, inside the program: what is served comes from here and from nowhere else.
///
/// `make view` builds the page with node and writes build/page/page_files.cpp, which defines
/// page_files(); a program that was configured without it has fallback/page_files.cpp.

#include <span>
#include <string_view>

namespace hawser::live {

struct PageFile {
    std::string_view path;  ///< As in a request: "/", "/view.js".
    std::string_view type;  ///< Content-Type.
    /// Contents, compressed by gzip; what does not begin with 1f 8b is not compressed.
    std::span<const unsigned char> gzip;
};

[[nodiscard]] std::span<const PageFile> page_files();

}  // namespace hawser::live
