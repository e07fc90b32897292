// SPDX-License-Identifier: Apache-2.0
#include "draw/font.h"

#include <cstddef>
#include <map>
#include <string_view>

namespace hawser::draw {

namespace {

struct TableEntry {
    char32_t code;
    int advance;  // 1/1024 em
    std::string_view outline;
};

constexpr TableEntry kGlyphTable[] = {
#include "draw/font_table.inc"
};

constexpr int kCurveFlag = 2048;
constexpr int kCoordinateOffset = 512;
constexpr double kUnitsPerEm = 1024.0;
constexpr int kPiecesPerCurve = 5;  // Smooth at the sizes of captions and titles.

int number(std::string_view digits) { return (digits[0] - '#') * 64 + (digits[1] - '#'); }

struct OutlinePoint {
    Point at;
    bool control = false;
};

Point middle(Point a, Point b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }

// Flatten a TrueType contour. Two consecutive control points imply a point on the curve between
// them.
std::vector<Point> flatten(const std::vector<OutlinePoint>& contour) {
    std::vector<OutlinePoint> full;
    const std::size_t n = contour.size();
    std::size_t first = 0;
    while (first < n && contour[first].control) ++first;
    for (std::size_t k = 0; k < n; ++k) {
        const OutlinePoint& a = contour[(first + k) % n];
        const OutlinePoint& b = contour[(first + k + 1) % n];
        full.push_back(a);
        if (a.control && b.control) full.push_back({middle(a.at, b.at), false});
    }
    std::vector<Point> out;
    for (std::size_t k = 0; k < full.size(); ++k) {
        const OutlinePoint& p = full[k];
        if (!p.control) {
            out.push_back(p.at);
            continue;
        }
        if (out.empty()) continue;
        const Point a = out.back();
        const Point c = full[(k + 1) % full.size()].at;
        for (int i = 1; i < kPiecesPerCurve; ++i) {
            const double t = double(i) / kPiecesPerCurve;
            const double u = 1.0 - t;
            out.push_back({u * u * a.x + 2 * u * t * p.at.x + t * t * c.x,
                           u * u * a.y + 2 * u * t * p.at.y + t * t * c.y});
        }
    }
    return out;
}

Glyph decode(const TableEntry& entry) {
    Glyph glyph;
    glyph.advance = entry.advance / kUnitsPerEm;
    std::vector<OutlinePoint> contour;
    for (std::size_t i = 0; i + 4 <= entry.outline.size(); i += 4) {
        const int x = number(entry.outline.substr(i));
        const int y = number(entry.outline.substr(i + 2));
        contour.push_back({{((x & (kCurveFlag - 1)) - kCoordinateOffset) / kUnitsPerEm,
                            ((y & (kCurveFlag - 1)) - kCoordinateOffset) / kUnitsPerEm},
                           (x & kCurveFlag) != 0});
        if ((y & kCurveFlag) != 0) {
            glyph.contours.push_back(flatten(contour));
            contour.clear();
        }
    }
    return glyph;
}

std::map<char32_t, Glyph> decode_all() {
    std::map<char32_t, Glyph> glyphs;
    for (const TableEntry& entry : kGlyphTable) glyphs.emplace(entry.code, decode(entry));
    return glyphs;
}

}  // namespace

const Glyph& glyph(char32_t code) {
    static const std::map<char32_t, Glyph> glyphs = decode_all();
    static const Glyph missing{0.6,
                               {{{0.08, 0.0}, {0.52, 0.0}, {0.52, 0.7}, {0.08, 0.7}},
                                {{0.13, 0.05}, {0.13, 0.65}, {0.47, 0.65}, {0.47, 0.05}}}};
    const auto found = glyphs.find(code);
    return found == glyphs.end() ? missing : found->second;
}

}  // namespace hawser::draw
