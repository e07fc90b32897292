// SPDX-License-Identifier: Apache-2.0
/// Readers of binary outputs, which add text to the log.
#include "golden/figures.h"
#include "golden/outputs.h"

#include <fmt/format.h>
#include <png.h>
#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace hawser::golden {

namespace {

using hawser::test::read_text;

/// Read a number of a binary file. Files and machines are little-endian.
template <class T>
T number_at(const std::string& bytes, std::size_t at) {
    if (at + sizeof(T) > bytes.size()) throw std::runtime_error("the file is too short");
    T value{};
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

template <class T>
std::string project_as(const std::string& bytes, std::size_t begin, std::size_t count) {
    Projection sum(300, 0.0);
    for (std::size_t i = 0; i < count; ++i)
        sum.add(static_cast<double>(number_at<T>(bytes, begin + i * sizeof(T))));
    return fmt::format("{} numbers, projection {:.7g}", count, sum.result().value);
}

std::string project_accessor(const nlohmann::json& document, const nlohmann::json& accessor,
                             const std::string& bytes, std::size_t buffer) {
    std::size_t count = accessor.at("count").get<std::size_t>();
    for (const auto& [type, components] :
         {std::pair<const char*, std::size_t>{"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}})
        if (accessor.at("type") == type) count *= components;
    const auto& view = document.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const std::size_t begin = buffer + view.value("byteOffset", std::size_t{0});
    switch (accessor.at("componentType").get<int>()) {
        case 5121:
            return project_as<std::uint8_t>(bytes, begin, count);
        case 5123:
            return project_as<std::uint16_t>(bytes, begin, count);
        case 5125:
            return project_as<std::uint32_t>(bytes, begin, count);
        case 5126:
            return project_as<float>(bytes, begin, count);
        default:
            throw std::runtime_error("unknown type of components");
    }
}

/// Return the value of an attribute of an XML element; "" if it has none.
std::string attribute(std::string_view element, const std::string& name) {
    const std::size_t at = element.find(" " + name + "=\"");
    if (at == element.npos) return {};
    const std::size_t begin = at + name.size() + 3;
    return std::string(element.substr(begin, element.find('"', begin) - begin));
}

/// Return a projection of an array that an element of a .vtp file describes. @param data  Offset of
/// the appended data; an array begins with its size in bytes.
std::string project_array(std::string_view element, const std::string& bytes, std::size_t data) {
    const std::size_t at = data + std::stoul(attribute(element, "offset"));
    const auto size = static_cast<std::size_t>(number_at<std::uint64_t>(bytes, at));
    const std::size_t begin = at + sizeof(std::uint64_t);
    const std::string type = attribute(element, "type");
    if (type == "Float64") return project_as<double>(bytes, begin, size / 8);
    if (type == "Float32") return project_as<float>(bytes, begin, size / 4);
    if (type == "Int32") return project_as<std::int32_t>(bytes, begin, size / 4);
    if (type == "UInt8") return project_as<std::uint8_t>(bytes, begin, size);
    throw std::runtime_error("unknown type " + type);
}

}  // namespace

void Outputs::add_picture(const std::string& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_file(&image, out(file).c_str()), 0) << image.message;
    image.format = PNG_FORMAT_RGB;
    std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(image));
    ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
    // Weights repeat after a prime number of pixels.
    std::array<double, 1021> weights{};
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = weight(301, i);
    constexpr std::size_t kBands = 16;
    std::array<double, kBands> sums{};
    const std::size_t row = std::size_t{3} * image.width;
    for (std::size_t y = 0; y < image.height; ++y) {
        double sum = 0.0;
        for (std::size_t i = y * row; i < (y + 1) * row; ++i)
            sum += weights[i % weights.size()] * (255 - pixels[i]);
        sums[y * kBands / image.height] += sum;
    }
    log_ += fmt::format("picture {}: {} x {}, bands", file, image.width, image.height);
    for (const double sum : sums) log_ += fmt::format(" {:.2f}", sum / 255.0);
    log_ += "\n";
}

void Outputs::add_vtp(const std::string& file) {
    const std::string bytes = read_text(out(file));
    const std::size_t end = bytes.find("<AppendedData");
    ASSERT_NE(end, std::string::npos) << file;
    const std::size_t data = bytes.find('_', end) + 1;
    log_ += "vtp " + file + "\n";
    for (std::size_t at = 0; at < end;) {
        const std::size_t next = bytes.find('\n', at) + 1;
        const std::string line = bytes.substr(at, next - at);
        log_ += line;
        if (attribute(line, "format") == "appended")
            log_ += "  " + project_array(line, bytes, data) + "\n";
        at = next;
    }
}

void Outputs::add_glb(const std::string& file) {
    const std::string bytes = read_text(out(file));
    constexpr std::size_t kHeader = 20, kChunk = 8;
    const auto size = number_at<std::uint32_t>(bytes, 12);
    auto document = nlohmann::json::parse(bytes.substr(kHeader, size));
    log_ += "glb " + file + "\n";
    for (const auto& [key, value] : document.items()) {
        if (!value.is_array()) {
            log_ += fmt::format("{}: {}\n", key, value.dump());
            continue;
        }
        for (std::size_t i = 0; i < value.size(); ++i)
            log_ += fmt::format("{} {}: {}\n", key, i, value[i].dump());
    }
    const auto& accessors = document.at("accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i)
        log_ +=
            fmt::format("accessor {}: {}\n", i,
                        project_accessor(document, accessors[i], bytes, kHeader + size + kChunk));
}

}  // namespace hawser::golden
