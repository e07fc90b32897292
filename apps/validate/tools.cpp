// SPDX-License-Identifier: Apache-2.0
#include "validate/tools.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace hawser::validate {
namespace {

std::filesystem::path scene_file(const std::string& name) {
    namespace fs = std::filesystem;
    std::vector<fs::path> folders;
    if (const char* given = std::getenv("HAWSER_SCENES")) folders.emplace_back(given);
    folders.emplace_back("scenes");
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        folders.push_back(program.parent_path() / "../share/hawser/scenes");
        folders.push_back(program.parent_path() / "../../../scenes");  // build/<preset>/bin
    }
    for (const fs::path& folder : folders) {
        const fs::path file = folder / (name + ".json");
        if (fs::exists(file, error)) return file;
    }
    throw std::runtime_error(
        fmt::format("scene {}.json not found; run in the project's folder or set HAWSER_SCENES "
                    "to its folder of scenes",
                    name));
}

}  // namespace

scene::Scene open_scene(const std::string& name, double step, const std::vector<std::string>& set) {
    scene::Options options;
    options.step = step;
    options.set = set;
    return scene::load_file(scene_file(name), options);
}

void advance(World& world, long steps) {
    for (long i = 0; i < steps; ++i) {
        const Status status = world.step();
        if (status != Status::ok) {
            throw std::runtime_error(
                fmt::format("step at {:.6g} s: {}", world.time(), to_string(status)));
        }
    }
}

long steps_to(const World& world, double time) {
    const double steps = (time - world.time()) / world.settings().step;
    if (std::abs(steps - std::round(steps)) > 1e-6) {
        throw std::runtime_error(fmt::format("{} s is not a whole number of steps", time));
    }
    return std::lround(steps);
}

BodyId body(const World& world, const std::string& name) {
    const BodyId id = world.find_body(name);
    if (!id.valid()) throw std::runtime_error("no body " + name);
    return id;
}

InteractionId interaction(const World& world, const std::string& name) {
    const InteractionId id = world.find_interaction(name);
    if (!id.valid()) throw std::runtime_error("no interaction " + name);
    return id;
}

std::vector<double> list(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

double tension(const World& world, InteractionId id) { return -world.force(id)[0]; }

double interpolate(std::span<const double> s, double at) {
    const long last = static_cast<long>(s.size()) - 3;
    const long i = std::clamp(static_cast<long>(std::floor(at)), 1L, std::max(1L, last));
    const double t = at - static_cast<double>(i);
    const auto y = [&](long k) { return s[static_cast<std::size_t>(i + k)]; };
    return y(-1) * (-t * (t - 1) * (t - 2) / 6) + y(0) * ((t + 1) * (t - 1) * (t - 2) / 2) +
           y(1) * (-(t + 1) * t * (t - 2) / 2) + y(2) * ((t + 1) * t * (t - 1) / 6);
}

std::vector<double> upward_zeros(std::span<const double> signal, double step) {
    std::vector<double> zeros;
    for (std::size_t i = 1; i + 2 < signal.size(); ++i) {
        if (!(signal[i] < 0.0 && signal[i + 1] >= 0.0)) continue;
        double low = static_cast<double>(i), high = low + 1.0;
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (low + high);
            (interpolate(signal, middle) < 0.0 ? low : high) = middle;
        }
        zeros.push_back(0.5 * (low + high) * step);
    }
    return zeros;
}

AngleCounter::AngleCounter(Vec3 axis, const Quat& start) : axis_(std::move(axis)), last_(start) {}

double AngleCounter::update(const Quat& now) {
    const Quat turn = now * last_.conjugate();
    angle_ += std::remainder(2.0 * std::atan2(turn.vec().dot(axis_), turn.w()), 2.0 * kPi);
    last_ = now;
    return angle_;
}

double elliptic_k(double k) {
    double a = 1.0, b = std::sqrt(1.0 - k * k);
    for (int i = 0; i < 20 && a != b; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return kPi / (2.0 * a);
}

double jacobi_sn(double u, double k) {
    // Abramowitz and Stegun 16.4: phi_N = 2^N a_N u, sin(2 phi_{n-1} - phi_n) = c_n/a_n sin phi_n.
    constexpr int kLevels = 8;
    double a[kLevels + 1] = {1.0}, c[kLevels + 1] = {k};
    double b = std::sqrt(1.0 - k * k);
    for (int n = 0; n < kLevels; ++n) {
        a[n + 1] = 0.5 * (a[n] + b);
        c[n + 1] = 0.5 * (a[n] - b);
        b = std::sqrt(a[n] * b);
    }
    double phi = std::ldexp(a[kLevels] * u, kLevels);
    for (int n = kLevels; n > 0; --n) phi = 0.5 * (phi + std::asin(c[n] / a[n] * std::sin(phi)));
    return std::sin(phi);
}

}  // namespace hawser::validate
