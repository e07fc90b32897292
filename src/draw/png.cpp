// SPDX-License-Identifier: Apache-2.0
#include "draw/png.h"

#include "draw/svg.h"
#include "record/files.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace hawser::draw {

namespace {

constexpr std::size_t kMessageSize = 200;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why) {
    throw std::runtime_error(fmt::format("{}: cannot write: {}", file.string(), why));
}

struct CloseFile {
    void operator()(std::FILE* f) const { std::fclose(f); }
};

// Report an error of libpng. It is C and exits by longjmp, which must not cross a C++ object with a
// destructor. Therefore write_rows has none; its message is returned through the error pointer.
[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    auto* text = static_cast<char*>(png_get_error_ptr(png));
    std::snprintf(text, kMessageSize, "%s", message);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

bool write_rows(png_structp png, png_infop info, std::FILE* out, const Image& image,
                png_text* texts, png_uint_32 density) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_init_io(png, out);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_pHYs(png, info, density, density, PNG_RESOLUTION_METER);
    png_set_text(png, info, texts, 2);
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y)
        png_write_row(png, image.rgb.data() + 3 * static_cast<std::ptrdiff_t>(y) * image.width);
    png_write_end(png, info);
    return true;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file, const Drawing& about) {
    if (const std::string fault = record::output_fault(file); !fault.empty()) fail(file, fault);
    const std::unique_ptr<std::FILE, CloseFile> out(std::fopen(file.c_str(), "wb"));
    if (!out) fail(file, std::strerror(errno));
    char message[kMessageSize] = "out of memory";
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, message, on_error, on_warning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    std::string title = about.title, description = about.description;
    std::string title_key = "Title", description_key = "Description";
    png_text texts[2] = {};
    texts[0].compression = texts[1].compression = PNG_ITXT_COMPRESSION_NONE;
    texts[0].key = title_key.data();
    texts[0].text = title.data();
    texts[1].key = description_key.data();
    texts[1].text = description.data();
    // 96 points per inch times the scale, in pixels per metre.
    const auto density =
        static_cast<png_uint_32>(96.0 / 0.0254 * image.width / std::max(1.0, about.width));
    const bool good = info != nullptr && write_rows(png, info, out.get(), image, texts, density);
    png_destroy_write_struct(&png, &info);
    if (!good) fail(file, message);
    if (std::fflush(out.get()) != 0) fail(file, std::strerror(errno));
}

std::vector<std::filesystem::path> write_pictures(const Drawing& drawing,
                                                  const std::filesystem::path& base, double scale) {
    std::error_code ignored;  // A failure to create the folder appears when the file is opened.
    if (base.has_parent_path()) std::filesystem::create_directories(base.parent_path(), ignored);
    const std::filesystem::path svg = base.string() + ".svg", png = base.string() + ".png";
    if (const std::string fault = record::write_file(svg, to_svg(drawing)); !fault.empty())
        fail(svg, fault);
    write_png(rasterise(drawing, scale), png, drawing);
    return {svg, png};
}

}  // namespace hawser::draw
