// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file acting.h
/// Systems for tests whose actions are a function.

#include <hawser/hawser.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {

/// Calls a function in each step; its state is a list of numbers and a counter.
class Acting final : public System {
  public:
    using Act = std::function<void(Acting&, Prestep&, Loads&)>;
    Acting(std::string name, Act act, std::size_t numbers = 0)
        : state(numbers, 0.0), name_(std::move(name)), act_(std::move(act)) {}
    [[nodiscard]] std::string_view name() const noexcept override { return name_; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        ++calls;
        act_(*this, now, loads);
    }
    void visit_state(StateVisitor& visitor) override {
        visitor.visit(calls);
        visitor.visit(std::span(state));
    }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<Acting>(name_, act_, state.size());
    }

    std::int64_t calls = 0;
    std::vector<double> state;

  private:
    std::string name_;
    Act act_;
};

inline Acting& act(World& w, std::string name, Acting::Act f, std::size_t numbers = 0) {
    return static_cast<Acting&>(
        w.add_system(std::make_unique<Acting>(std::move(name), std::move(f), numbers)));
}

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Return (v, ω) of a body.
inline Vec6 motion(const World& w, BodyId body) {
    const Twist t = w.velocity(body);
    Vec6 out;
    out << t.linear, t.angular;
    return out;
}

/// Return a rigid body without weight.
inline BodyDef floating(const Vec3& x, double mass, const Vec3& inertia) {
    BodyDef def;
    def.position = x;
    def.mass = mass;
    def.inertia = inertia.asDiagonal();
    def.gravity = false;
    return def;
}

/// Return G Gᵀ of a matrix drawn from a seed, with full coupling.
inline Mat6 coupled(unsigned seed, double scale) {
    Mat6 g;
    for (int i = 0; i < 36; ++i) {
        seed = seed * 1664525u + 1013904223u;
        g(i / 6, i % 6) = static_cast<double>(seed >> 8) / (1 << 24) - 0.5;
    }
    return scale * g * g.transpose();
}

}  // namespace hawser::test
