// SPDX-License-Identifier: Apache-2.0
#include "scene/cable_shape.h"

#include "scene/catenary.h"
#include "scene/line_types.h"

#include <hawser/catenary.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::scene {
namespace {

double polyline_length(const std::vector<Vec3>& nodes) {
    double length = 0.0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        length += (nodes[i] - nodes[i - 1]).norm();
    }
    return length;
}

/// Strain of links by their own weight, so small that their lengths do not change.
constexpr double kLinkStrain = 1e-8;

/// Largest distance between the given start of a free end and its rest position, relative to the
/// length.
constexpr double kFreeEnd = 1e-3;

/// Computes the shape of a cable in equilibrium.
class AtRest {
  public:
    AtRest(CableLayout& c, const Description& out, const Scope& scope, const Json& cable,
           const std::optional<StillSea>& sea, const SourceLocation& location)
        : layout_(c), location_(location) {
        const Vec3& gravity = out.settings.gravity;
        if (gravity.isZero(0.0)) {
            throw_error(location / "shape", "a cable at rest needs gravity");
        }
        def_.down = gravity;
        const bool wet = sea && in_water(c);
        if (wet) def_.water = sea->level;
        for (const LayoutSection& s : c.sections) {
            CatenarySection part;
            part.weight = s.line.mass_per_length * s.submerged_factor * gravity.norm();
            if (wet) {
                part.buoyancy = sea->density * s.water.area() * gravity.norm();
                part.diameter = s.water.diameter;
                part.EI = s.line.EI;
            }
            parts_.push_back(part);
        }
        // The shape is computed from an attached end.
        is_reversed_ = c.from.kind == CableEnd::Kind::free;
        if (is_reversed_ && c.to.kind == CableEnd::Kind::free) {
            throw_error(location / "shape", "a cable at rest needs an end that is held");
        }
        def_.from = is_reversed_ ? c.to.world : c.from.world;
        def_.to = is_reversed_ ? c.from.world : c.to.world;
        if (const auto bed = cable.find("seabed"); bed != cable.end()) {
            const Vec3 point = scope.frame.point({0.0, 0.0, (*bed)["height"].get<double>()});
            // The seabed for nodes is higher by the contact radius, because nodes are centres of
            // contact shapes.
            const double radius = c.touches ? c.contact.radius : 0.0;
            def_.seabed = FlatSeabed{height(point) + radius, number_or(*bed, "friction", 0.0)};
        }
    }

    /// Return the largest length with a straight shape. The cable then hangs vertically from ends
    /// above the bottom, and lies straight along it.
    [[nodiscard]] double seabed_length() const {
        const Vec3 d = def_.to - def_.from;
        const double up = height(def_.to) - height(def_.from);
        const double span = std::sqrt(std::max(0.0, d.squaredNorm() - up * up));
        const double bottom = def_.seabed.value_or(FlatSeabed{}).height;
        double high = span;
        for (const Vec3& end : {def_.from, def_.to}) high += std::max(0.0, height(end) - bottom);
        double low = std::max(d.norm(), 0.5 * high);
        for (int i = 0; i < 50 && high - low > 1e-7 * high; ++i) {
            const double middle = 0.5 * (low + high);
            (solve(middle, false, false).status == CatenaryStatus::slack ? high : low) = middle;
        }
        return low;
    }

    void lay_out() {
        const bool free_end = is_reversed_ || layout_.to.kind == CableEnd::Kind::free;
        Catenary rest = free_end ? free_end_at_rest() : solve(layout_.length, false);
        if (rest.status == CatenaryStatus::below_seabed) {
            throw_error(
                location_ / "seabed",
                fmt::format("an end of the cable is below the seabed: at {:.6g} m and {:.6g} m, "
                            "where nodes on it are at {:.6g} m",
                            height(layout_.from.world), height(layout_.to.world),
                            def_.seabed.value_or(FlatSeabed{}).height));
        }
        if (rest.status == CatenaryStatus::unbalanced) {
            throw_error(location_ / "shape",
                        fmt::format("no shape at rest was found: {:.3g} N are left at "
                                    "a node; does it float over a seabed?",
                                    rest.residual));
        }
        layout_.laid_from = rest.laid_from;
        layout_.laid_to = rest.laid_to;
        if (is_reversed_) {
            std::reverse(rest.nodes.begin(), rest.nodes.end());
            layout_.laid_from = layout_.length - rest.laid_to;
            layout_.laid_to = layout_.length - rest.laid_from;
        }
        layout_.nodes = std::move(rest.nodes);
        if (free_end) {
            (is_reversed_ ? layout_.from : layout_.to).world =
                is_reversed_ ? layout_.nodes.front() : layout_.nodes.back();
        }
    }

  private:
    [[nodiscard]] double height(const Vec3& p) const { return -p.dot(def_.down.normalized()); }

    [[nodiscard]] Catenary solve(double length, bool free, bool bends = true) const {
        CatenaryDef def = def_;
        def.free = free;
        for (std::size_t i = 0; i < layout_.sections.size(); ++i) {
            const CableSection& line = layout_.sections[i].line;
            const double here = layout_.sections.size() == 1 ? length : line.length;
            CatenarySection part = parts_[i];
            const double rigid = std::max(std::abs(part.weight), 1.0) * here / kLinkStrain;
            part.length = here;
            part.EA = layout_.links ? rigid : line.EA;
            part.elements = static_cast<int>(line.elements);
            if (!bends) part.EI = 0.0;
            def.sections.push_back(part);
        }
        if (is_reversed_) std::reverse(def.sections.begin(), def.sections.end());
        try {
            return catenary(def);
        } catch (const DefError& error) {
            throw_error(location_ / "shape", error.what());
        }
    }

    /// Return the shape of a cable with a free end. The end is on the bottom, where friction fixes
    /// it, or the cable hangs from the other end.
    [[nodiscard]] Catenary free_end_at_rest() const {
        if (def_.seabed &&
            std::abs(height(def_.to) - def_.seabed->height) <= kFreeEnd * layout_.length) {
            Catenary rest = solve(layout_.length, false);
            if (rest.status != CatenaryStatus::unbalanced && rest.tension.back() == 0.0) {
                return rest;
            }
        }
        Catenary rest = solve(layout_.length, true);
        const Vec3& end = rest.nodes.back();
        if ((end - def_.to).norm() > kFreeEnd * layout_.length) {
            throw_error(location_ / (is_reversed_ ? "from" : "to") / "free",
                        fmt::format("at rest its free end is at [{:.6g}, {:.6g}, {:.6g}]; start it "
                                    "there, or give the cable another shape",
                                    end.x(), end.y(), end.z()));
        }
        return rest;
    }

    CableLayout& layout_;
    SourceLocation location_;
    CatenaryDef def_;
    std::vector<CatenarySection> parts_;  ///< Properties of the sections, without their lengths.
    bool is_reversed_ = false;
};

/// Compute the shape of a chain of equal rigid elements.
void hang_rigid_elements(CableLayout& c, const Description& out, const SourceLocation& location) {
    if (out.settings.gravity.isZero(0.0)) {
        throw_error(location / "shape", "a catenary needs gravity");
    }
    if (c.sections.size() > 1) {
        throw_error(
            location / "shape",
            "a \"catenary\" is of one line type; give \"hanging\", which is at rest with its "
            "stretch");
    }
    const Vec3& a = c.from.world;
    const Vec3& b = c.to.world;
    auto hanging =
        hanging_nodes(a, b, c.length, static_cast<int>(c.elements), out.settings.gravity);
    if (!hanging) {
        throw_error(
            location / "shape",
            fmt::format("no catenary of {} m in {} elements joins the ends, {:.6g} m "
                        "apart; the length must not be less than the distance, and the "
                        "ends must not be nearly on one vertical: \"hanging\" may be all that",
                        c.length, c.elements, (b - a).norm()));
    }
    c.nodes = std::move(*hanging);
}

/// Place nodes at equal distances along a polyline.
void place_along_polyline(CableLayout& c, const std::vector<Vec3>& corners,
                          const SourceLocation& location) {
    const double total = polyline_length(corners);
    if (!(total > 0.0)) {
        throw_error(location / "path", "all of its points coincide");
    }
    c.nodes = {corners.front()};
    std::size_t leg = 0;
    double before = 0.0;  // along the corners up to this leg
    for (std::size_t i = 1; i < c.elements; ++i) {
        const double at = total * c.length_fraction(i);
        double length = (corners[leg + 1] - corners[leg]).norm();
        while (at > before + length && leg + 2 < corners.size()) {
            before += length;
            ++leg;
            length = (corners[leg + 1] - corners[leg]).norm();
        }
        const double part = length > 0.0 ? (at - before) / length : 0.0;
        c.nodes.push_back(corners[leg] + part * (corners[leg + 1] - corners[leg]));
    }
    c.nodes.push_back(corners.back());
}

void straight_or_listed(CableLayout& c, const Scope& scope, const Json& cable) {
    const Vec3& a = c.from.world;
    const Vec3& b = c.to.world;
    const Json* points = listed_points(cable);
    c.nodes.resize(c.elements + 1);
    for (std::size_t i = 0; i <= c.elements; ++i) {
        c.nodes[i] = a + (b - a) * c.length_fraction(i);
    }
    c.nodes.back() = b;
    for (std::size_t i = 1; points != nullptr && i < c.elements; ++i) {
        c.nodes[i] = scope.frame.point(vector_of((*points)[i - 1]));
    }
    if (points != nullptr && !cable.contains("length") && !cable.contains("sections")) {
        c.length = polyline_length(c.nodes);
    }
}

void add_offsets(CableLayout& c, const Scope& scope, const Json& cable,
                 const SourceLocation& location) {
    const auto offsets = cable.find("offsets");
    if (offsets == cable.end()) {
        return;
    }
    if (offsets->size() + 1 != c.elements) {
        throw_error(location / "offsets",
                    fmt::format("expected {} offsets, one fewer than the elements, found {}",
                                c.elements - 1, offsets->size()));
    }
    for (std::size_t i = 1; i < c.elements; ++i) {
        c.nodes[i] += scope.frame.direction(vector_of((*offsets)[i - 1]));
    }
}

}  // namespace

const Json* listed_points(const Json& cable) {
    const auto shape = cable.find("shape");
    return shape != cable.end() && shape->is_array() ? &*shape : nullptr;
}

void place_nodes(CableLayout& c, const Description& out, const Scope& scope, const Json& cable,
                 const std::optional<StillSea>& sea, const SourceLocation& location) {
    const auto shape = cable.find("shape");
    const std::string kind =
        shape != cable.end() && shape->is_string() ? shape->get<std::string>() : "straight";
    const bool seabed = cable.contains("seabed");
    const bool sections = cable.contains("sections");
    const bool has_length = sections || cable.contains("length");
    c.length = number_or(cable, "length", (c.to.world - c.from.world).norm());
    if (sections) {
        c.length = 0.0;
        for (const LayoutSection& s : c.sections) c.length += s.line.length;
        measure_elements(c);
    }
    if (seabed && kind != "catenary" && kind != "hanging" && kind != "laid") {
        throw_error(location / "seabed",
                    "only the shapes \"catenary\", \"hanging\" and \"laid\" lie on it");
    }
    if (kind == "laid" && !seabed) {
        throw_error(location / "shape", "a cable that is laid needs \"seabed\"");
    }
    if (cable.contains("path") != (kind == "path")) {
        throw_error(location / "path", "the shape \"path\" goes with the key \"path\"");
    }
    // In the sea a part may be wet; the chain of rigid elements has no buoyancy.
    const bool at_rest = kind == "hanging" || kind == "laid";
    if (at_rest || (kind == "catenary" && (seabed || (sea && in_water(c))))) {
        AtRest rest(c, out, scope, cable, sea, location);
        if (kind == "laid" && !has_length) {
            c.length = rest.seabed_length();
        }
        rest.lay_out();
    } else if (kind == "catenary") {
        hang_rigid_elements(c, out, location);
    } else if (kind == "path") {
        std::vector<Vec3> corners{c.from.world};
        for (const Json& point : cable["path"]) {
            corners.push_back(scope.frame.point(vector_of(point)));
        }
        corners.push_back(c.to.world);
        place_along_polyline(c, corners, location);
        if (!has_length) {
            c.length = polyline_length(c.nodes);
        }
    } else {
        straight_or_listed(c, scope, cable);
    }
    add_offsets(c, scope, cable, location);
}

}  // namespace hawser::scene
