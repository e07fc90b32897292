// SPDX-License-Identifier: Apache-2.0
#include "reference.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hawser::bench {
namespace {

struct Slot {
    std::size_t i = 0;
    double weight = 0.0;  ///< Weight of sample i + 1.
};

// Frame times are sums of 1/60 and samples are rounded in the file: they may differ by this.
constexpr double kSlack = 1e-6;  // [s]

Slot slot(const std::vector<double>& t, double time) {
    const auto above = std::upper_bound(t.begin(), t.end(), time);
    const auto i = std::clamp<std::ptrdiff_t>(above - t.begin() - 1, 0,
                                              static_cast<std::ptrdiff_t>(t.size()) - 2);
    const auto k = static_cast<std::size_t>(i);
    return {k, std::clamp((time - t[k]) / (t[k + 1] - t[k]), 0.0, 1.0)};
}

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
}

}  // namespace

bool Reference::covers(double time) const {
    return t.size() >= 2 && time >= t.front() - kSlack && time <= t.back() + kSlack;
}

Vec3 Reference::block_at(double time) const {
    const Slot s = slot(t, time);
    return (1.0 - s.weight) * block[s.i] + s.weight * block[s.i + 1];
}

double Reference::tension_at(std::size_t ship, double time) const {
    const Slot s = slot(t, time);
    return (1.0 - s.weight) * tension[ship][s.i] + s.weight * tension[ship][s.i + 1];
}

Reference load_reference(const std::string& folder, const Scene& scene) {
    Reference ref;
    const std::string path = folder + "/" + scene.name + ".csv";
    std::ifstream in(path);
    if (!in) return ref;
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = split(line);
    std::vector<std::size_t> tension_columns;
    std::size_t x = 0;
    for (std::size_t c = 1; c < names.size(); ++c) {
        if (names[c] == "x") x = c;
        if (names[c].rfind("tension", 0) == 0) tension_columns.push_back(c);
    }
    if (names.empty() || names[0] != "t" || (x == 0 && tension_columns.empty()) ||
        x + 2 >= names.size() + (x == 0 ? 3 : 0) ||
        (!tension_columns.empty() && tension_columns.size() != scene.towed.size()))
        throw std::runtime_error(path + ": expected the columns t,x,y,z or t,tension_1,...");
    ref.tension.resize(tension_columns.size());
    for (int number = 2; std::getline(in, line); ++number) {
        if (line.empty()) continue;
        std::vector<double> v;
        try {
            for (const std::string& cell : split(line)) v.push_back(std::stod(cell));
        } catch (const std::exception&) {
            v.clear();
        }
        if (v.size() != names.size() || (!ref.t.empty() && v[0] <= ref.t.back()))
            throw std::runtime_error(path + ": line " + std::to_string(number) + ": expected " +
                                     std::to_string(names.size()) +
                                     " numbers, the time increasing");
        ref.t.push_back(v[0]);
        if (x > 0) ref.block.emplace_back(v[x], v[x + 1], v[x + 2]);
        for (std::size_t k = 0; k < tension_columns.size(); ++k)
            ref.tension[k].push_back(v[tension_columns[k]]);
    }
    if (ref.t.size() < 2) throw std::runtime_error(path + ": fewer than two samples");
    return ref;
}

}  // namespace hawser::bench
