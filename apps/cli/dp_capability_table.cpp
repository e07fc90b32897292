// SPDX-License-Identifier: Apache-2.0
#include "dp_capability_table.h"

#include <hawser/dp_capability.h>
#include <hawser/dp_ship_file.h>
#include <hawser/vessel.h>

#include "draw/dp_polar.h"
#include "draw/svg.h"
#include "record/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace hawser::cli {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::vector<scene::NamedDpShip> ships_of(const SceneOptions& options) {
    if (scene::is_dp_ship_file(options.file)) return {scene::load_dp_ship(options.file)};
    const scene::Scene scene = options.load();
    std::vector<scene::NamedDpShip> out;
    for (const VesselDef* vessel : vessels_of(scene.world))
        if (vessel->dp_capability) out.push_back({vessel->name, *vessel->dp_capability});
    return out;
}

void print_thrusters(const DpShip& ship) {
    fmt::print("  thruster         nominal ahead, astern [kN]\n");
    for (const DpThruster& t : ship.thrusters)
        fmt::print("  {:<16} {:.3f}, {:.3f}\n", t.name, 1e-3 * dp_nominal_thrust(t, false),
                   1e-3 * dp_nominal_thrust(t, true));
}

std::string utilisation(double u) {
    return std::isfinite(u) ? fmt::format("{:.3f}", u) : std::string("none");
}

void print_headings(const DpCapability& c) {
    fmt::print(
        "  from [deg]       number, utilisation, at the next number; numbers without each of:\n");
    std::string names;
    for (const DpFailure& f : c.failures) names += (names.empty() ? "" : ", ") + f.name;
    fmt::print("  {:<16} {}\n", "", names);
    for (const DpHeading& h : c.headings)
        fmt::print("  {:<16.4g} {:>2}  {}  {:<6} {}\n", h.from * kDegrees, h.number,
                   utilisation(h.utilisation), h.number < kDpNumbers ? utilisation(h.next) : "",
                   fmt::join(h.failed_numbers, ", "));
}

void print_numbers(const DpShip& ship, const DpCapability& c) {
    fmt::print("  from [deg]       utilisation at numbers 1 to {}\n", kDpNumbers);
    for (const DpHeading& h : c.headings) {
        fmt::print("  {:<16.4g}", h.from * kDegrees);
        for (int n = 1; n <= kDpNumbers; ++n)
            fmt::print(" {}", utilisation(dp_utilisation(ship, n, h.from).value));
        fmt::print("\n");
    }
}

void write_plot(const DpCapability& c, const std::string& name, const std::string& output,
                bool several) {
    std::filesystem::path file(output);
    if (file.extension() != ".svg" || several) {
        if (file.extension() == ".svg") file = file.parent_path();
        if (!file.empty()) std::filesystem::create_directories(file);
        file /= "dp_capability_" + name + ".svg";
    }
    const draw::Drawing drawing =
        draw::plot_dp_capability(c, name + ": " + c.text(), "DNV-ST-0111, December 2021, Level 1");
    if (const std::string error = record::write_file(file, draw::to_svg(drawing)); !error.empty())
        throw std::runtime_error(error);
    fmt::print("wrote {}\n", file.string());
}

}  // namespace

bool print_dp_capability(const SceneOptions& scene, const DpOptions& options,
                         const std::string& output) {
    const std::vector<scene::NamedDpShip> ships = ships_of(scene);
    if (ships.empty()) {
        fmt::print(stderr, "hawser: {}: no vessel has the key dp_capability\n", scene.file);
        return false;
    }
    for (const scene::NamedDpShip& each : ships) {
        const DpCapability c = dp_capability(each.ship, options.step_deg / kDegrees);
        fmt::print("{}\n", each.name);
        print_thrusters(each.ship);
        print_headings(c);
        if (options.numbers) print_numbers(each.ship, c);
        fmt::print("  {}\n", c.text());
        if (!output.empty()) write_plot(c, each.name, output, ships.size() > 1);
    }
    return true;
}

}  // namespace hawser::cli
