// SPDX-License-Identifier: Apache-2.0
#include "scene/line_types.h"

#include "scene/field_reader.h"
#include "scene/sea_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::scene {
namespace {

/// Return the line type of an object. @param of  A cable or a section of one.
const Json& find_line_type(const Json& of, const Document& document,
                           const SourceLocation& location) {
    const Json& line = of["line_type"];
    if (line.is_object()) {
        return line;
    }
    const auto& name = line.get_ref<const std::string&>();
    std::vector<std::string> known;
    if (const auto types = document.root.find("line_types"); types != document.root.end()) {
        if (const auto entry = types->find(name); entry != types->end()) {
            return *entry;
        }
        for (const auto& [key, value] : types->items()) {
            known.push_back(key);
        }
    }
    report_missing(document.mistakes, OmittedPart::line_type, name, location / "line_type",
                   "there is no line type " + in_quotes(name) + suggestion(name, known));
}

/// Read the water coefficients of a line type. @throws SceneError.
LineWater read_line_water_of(const Json& line, const SourceLocation& location) {
    LineWater w;
    if (!line.contains("cd_normal")) return w;
    w.diameter = number_or(line, "diameter", 0.0);
    if (!(w.diameter > 0.0))
        throw_error(location / "line_type",
                    "its line type has \"cd_normal\", drag on its diameter, but no \"diameter\"");
    read_line_water(line, w);
    return w;
}

LayoutSection read_section(const Json& of, bool links, const Document& document,
                           const SourceLocation& location) {
    const Json& line = find_line_type(of, document, location);
    LayoutSection s;
    if (of["line_type"].is_string()) {
        s.line.line_type = of["line_type"].get<std::string>();
    }
    read_fields(s.line, line, kSectionFields);
    read_fields(s, line, kLayoutFields);
    s.color = text_or(line, "color", "");
    s.water = read_line_water_of(line, location);
    if (!links && !(s.line.EA > 0.0)) {
        throw_error(location / "line_type", "a cable of lumps needs \"EA\" in its line type");
    }
    if (s.line.link > 0.0 && s.line.EI > 0.0) {
        throw_error(
            location / "line_type",
            "its line type has \"link\", so that it is chain, which does not resist bending; "
            "leave out \"EI\"");
    }
    return s;
}

/// Return the number of elements nearest to the requested number, so that each has a whole number
/// of links.
std::size_t nearest_count(std::size_t links, std::size_t asked) {
    for (std::size_t off = 0; off < links; ++off)
        for (const std::size_t n : {asked - std::min(off, asked - 1), asked + off})
            if (links % n == 0) return n;
    return 1;
}

}  // namespace

bool rounded_to_links(double length, double link) noexcept {
    constexpr double kDigits = 1e-6;  // round-off of the decimals of a file
    const double each = length / link;
    return each > 0.5 && std::abs(each - std::round(each)) <= kDigits * each;
}

void read_line_types(CableLayout& c, const Json& cable, const Document& document,
                     const SourceLocation& location) {
    const auto sections = cable.find("sections");
    if (sections == cable.end()) {
        if (!cable.contains("line_type")) {
            throw_error(
                location,
                "a cable needs the key \"line_type\" (a line type, by name or as an object), or "
                "\"sections\"");
        }
        c.sections = {read_section(cable, c.links, document, location)};
    } else {
        if (c.links) {
            throw_error(location / "sections",
                        "a cable of links is of one line type; give \"line_type\"");
        }
        for (std::size_t i = 0; i < sections->size(); ++i) {
            const Json& json = (*sections)[i];
            LayoutSection s = read_section(json, false, document, location / "sections" / i);
            s.line.length = json["length"].get<double>();
            s.line.elements = json["elements"].get<std::size_t>();
            c.elements += s.line.elements;
            c.sections.push_back(std::move(s));
        }
    }
    double diameter = 0.0;
    for (const LayoutSection& s : c.sections) diameter = std::max(diameter, s.line.diameter);
    c.radius = number_or(cable, "radius", 0.5 * diameter);
    if (c.links && !(c.radius > 0.0)) {
        throw_error(location,
                    "a cable of links needs \"radius\", or \"diameter\" in its line type");
    }
}

void read_line_water(const Json& json, LineWater& w) { read_fields(w, json, kLineWaterFields); }

void measure_elements(CableLayout& c) noexcept {
    if (c.sections.size() == 1) c.sections.front().line.length = c.length;
    for (LayoutSection& s : c.sections)
        s.element = s.line.length / static_cast<double>(s.line.elements);
}

void check_links(const CableLayout& c, const Json& cable, const SourceLocation& location) {
    for (std::size_t i = 0; i < c.sections.size() && !c.links; ++i) {
        const LayoutSection& s = c.sections[i];
        if (!(s.line.link > 0.0)) continue;
        if (rounded_to_links(s.element, s.line.link)) continue;
        const double each = s.element / s.line.link;
        const bool listed = cable.contains("sections");
        const SourceLocation at = listed ? location / "sections" / i : location;
        const double links = std::max(std::round(s.line.length / s.line.link), 1.0);
        const std::size_t count = nearest_count(static_cast<std::size_t>(links), s.line.elements);
        throw_error(
            at, fmt::format("its elements have {:.6g} links each, and chain parts between links "
                            "only; give \"length\" {:.12g} ({} links) and \"elements\" {}",
                            each, links * s.line.link, links, count));
    }
}

}  // namespace hawser::scene
