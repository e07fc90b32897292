// SPDX-License-Identifier: Apache-2.0
#include "wire/chain.h"

#include "base/number.h"

#include <hawser/def.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace hawser::wire {
namespace {

[[noreturn]] void throw_wire_error(const std::string& what) {
    throw DefError("a catenary: " + what);
}

void check_sections(const CatenaryDef& def) {
    if (def.sections.empty()) throw_wire_error("give it at least one section");
    for (const CatenarySection& part : def.sections) {
        if (!(part.length > 0.0) || !std::isfinite(part.length))
            throw_wire_error("the length of a section must be positive, in m");
        if (!(part.EA > 0.0) || !std::isfinite(part.EA))
            throw_wire_error("EA of a section must be positive, in N");
        if (!std::isfinite(part.weight))
            throw_wire_error("the weight of a section must be a number");
        if (part.elements < 1) throw_wire_error("a section needs at least one element");
        if (!(part.EI >= 0.0) || !std::isfinite(part.EI))
            throw_wire_error("EI of a section must be 0 or more, in N m^2");
        if (!(part.buoyancy >= 0.0 && part.diameter >= 0.0) ||
            !std::isfinite(part.buoyancy + part.diameter))
            throw_wire_error("the buoyancy and the diameter of a section must be 0 or more");
    }
}

void check_other_fields(const CatenaryDef& def) {
    if (!def.from.allFinite() || !def.to.allFinite()) throw_wire_error("its ends must be points");
    if (!def.down.allFinite() || !(def.down.norm() > 0.0))
        throw_wire_error("down must be a direction");
    if (!(def.tolerance > 0.0)) throw_wire_error("its tolerance must be positive");
    if (def.water && !std::isfinite(*def.water))
        throw_wire_error("the height of its water must be a number");
    if (!def.seabed) return;
    if (!std::isfinite(def.seabed->height))
        throw_wire_error("the height of its seabed must be a number");
    if (!(def.seabed->friction >= 0.0) || !std::isfinite(def.seabed->friction))
        throw_wire_error("the friction of its seabed must be 0 or more");
}

/// Return the material coordinates of all nodes.
std::vector<double> coordinates(const CatenaryDef& def, double total) {
    std::vector<double> out{0.0};
    if (def.nodes.empty()) {
        double begin = 0.0;
        for (const CatenarySection& part : def.sections) {
            for (int i = 1; i <= part.elements; ++i)
                out.push_back(begin + part.length * i / part.elements);
            begin += part.length;
        }
        out.back() = total;
    } else {
        out.insert(out.end(), def.nodes.begin(), def.nodes.end());
        out.push_back(total);
    }
    for (std::size_t i = 1; i < out.size(); ++i)
        if (!(out[i] > out[i - 1]))
            throw_wire_error("its nodes must ascend between 0 and its length of " + number(total) +
                             " m");
    return out;
}

}  // namespace

double Chain::total_weight() const noexcept {
    return std::accumulate(weight.begin(), weight.end(), 0.0);
}

Chain make_chain(const CatenaryDef& def) {
    check_sections(def);
    check_other_fields(def);
    double total = 0.0;
    for (const CatenarySection& part : def.sections) total += part.length;
    Chain out;
    out.s = coordinates(def, total);
    const std::size_t n = out.s.size() - 1;
    out.length.resize(n);
    out.compliance.assign(n, 0.0);
    out.weight.assign(n + 1, 0.0);
    out.buoyancy.assign(n, 0.0);
    out.diameter.assign(n, 0.0);
    out.bend.assign(n + 1, 0.0);
    std::size_t part = 0;
    double end = def.sections[0].length;   // end of the section
    std::vector<double> heavy(n, 0.0);     // weight of the elements
    std::vector<double> flexible(n, 0.0);  // length over EI
    for (std::size_t e = 0; e < n; ++e) {
        out.length[e] = out.s[e + 1] - out.s[e];
        for (double at = out.s[e]; at < out.s[e + 1];) {
            while (at >= end && part + 1 < def.sections.size()) end += def.sections[++part].length;
            const bool last = part + 1 == def.sections.size();
            const double next = last ? out.s[e + 1] : std::min(end, out.s[e + 1]);
            out.compliance[e] += (next - at) / def.sections[part].EA;
            heavy[e] += (next - at) * def.sections[part].weight;
            if (def.water) {
                out.buoyancy[e] += (next - at) * def.sections[part].buoyancy;
                out.diameter[e] = std::max(out.diameter[e], def.sections[part].diameter);
            }
            flexible[e] += (next - at) / def.sections[part].EI;  // infinite without EI
            at = next;
        }
    }
    out.half_first = 0.5 * heavy.front();
    out.half_last = 0.5 * heavy.back();
    for (std::size_t i = 1; i < n; ++i) {
        out.weight[i] = 0.5 * (heavy[i - 1] + heavy[i]);
        out.bend[i] = 2.0 / (flexible[i - 1] + flexible[i]);
    }
    out.heavy = std::move(heavy);
    return out;
}

double weigh_nodes(Chain& chain, const WetHalves& wet) {
    const std::size_t n = chain.elements();
    double change = 0.0;
    const auto first = [&](std::size_t e) {
        return 0.5 * (chain.heavy[e] - wet.first[e] * chain.buoyancy[e]);
    };
    const auto last = [&](std::size_t e) {
        return 0.5 * (chain.heavy[e] - wet.last[e] * chain.buoyancy[e]);
    };
    const auto put = [&](double& weight, double value) {
        change = std::max(change, std::abs(value - weight));
        weight = value;
    };
    for (std::size_t i = 1; i < n; ++i) put(chain.weight[i], last(i - 1) + first(i));
    put(chain.half_first, first(0));
    put(chain.half_last, last(n - 1));
    return change;
}

Chain reversed(const Chain& chain) {
    Chain out = chain;
    for (double& s : out.s) s = chain.s.back() - s;
    for (auto* list : {&out.s, &out.length, &out.compliance, &out.weight, &out.heavy, &out.buoyancy,
                       &out.diameter, &out.bend})
        std::reverse(list->begin(), list->end());
    std::swap(out.half_first, out.half_last);
    return out;
}

double rounding(const Chain& chain, double distance) noexcept {
    const double terms = 8.0 + std::sqrt(static_cast<double>(chain.elements()));
    return 1e-16 * terms * (chain.total_length() + distance);
}

Pulled stretched_element(double length, double compliance, double h, double v) noexcept {
    Pulled out;
    out.tension = std::hypot(h, v);
    if (!(out.tension > 0.0)) return out;
    const double part = length / out.tension + compliance;
    const double cosine = h / out.tension, sine = v / out.tension;
    out.x = part * h;
    out.z = part * v;
    out.x_h = length / out.tension * sine * sine + compliance;
    out.z_v = length / out.tension * cosine * cosine + compliance;
    out.x_v = -length / out.tension * cosine * sine;
    return out;
}

std::vector<Vec3> arc(std::span<const double> lengths, double chord) {
    const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    std::vector<Vec3> out(lengths.size());
    const auto bend = [&](double turn) {
        Vec3 sum = Vec3::Zero();
        double at = -0.5 * total;
        for (std::size_t e = 0; e < lengths.size(); ++e) {
            const double heading = turn * (at + 0.5 * lengths[e]) / total;
            out[e] = lengths[e] * Vec3(std::cos(heading), std::sin(heading), 0.0);
            sum += out[e];
            at += lengths[e];
        }
        return sum;
    };
    double turn = 0.0;
    if (chord < total) {
        double low = 0.0, high = 2.0 * 3.14159265358979323846;
        if (!(bend(high).norm() < chord)) low = high;
        for (int i = 0; i < 60 && low < high; ++i) {
            const double middle = 0.5 * (low + high);
            (bend(middle).norm() < chord ? high : low) = middle;
        }
        turn = low;
    }
    const Vec3 sum = bend(turn);
    const double size = sum.norm();
    // Rotate into the x axis. Shorten the chords if elements of unequal length cannot close.
    const double scale = size > chord ? chord / size : 1.0;
    const double c = size > 0.0 ? sum.x() / size : 1.0, s = size > 0.0 ? sum.y() / size : 0.0;
    for (Vec3& d : out) d = scale * Vec3(c * d.x() + s * d.y(), c * d.y() - s * d.x(), 0.0);
    return out;
}

}  // namespace hawser::wire
