// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pid.h
/// PID controller as a system (system.h). It measures the force of an interaction and sets an input
/// of the world, for example to keep the tension of a line by a winch.
///
/// The value u of the input follows from the error e = target − measured:
/// ```
///     u = bias + gain (e + (1/reset) ∫ e dt − rate d(measured)/dt)        clamped to [low, high]
/// ```
/// The derivative is that of the measured value, filtered with the time constant `filter`, so that
/// a sudden change of the target causes no peak. While u is clamped, the integral does not grow in
/// the direction that would drive u further beyond the limit (conditional integration). Source: K.
/// J. Åström, T. Hägglund, *PID Controllers: Theory, Design, and Tuning*, 1995, 3.5.
///
/// Limits: the measured force is that of the last step, a delay of one step. Gains that are stable
/// in continuous time may be unstable if the step is a large fraction of the time constant of the
/// loop.

#include <hawser/interactions.h>
#include <hawser/system.h>
#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace hawser {

/// Definition of a PID controller. Pid copies it.
struct PidDef {
    std::string name = "pid";  ///< Unique name among systems.
    InteractionId measured{};  ///< Interaction with the measured force. Required.
    int row = 0;               ///< Index of the measured row of World::force().
    double sign = -1.0;        ///< Factor of the measured force, 1 or −1. −1: the tension of a line
                               ///< is positive.
    InputId driven{};          ///< Input that the controller sets. Required.
    double target = 0.0;       ///< Set value of the force [N or N m].
    double bias = 0.0;         ///< Offset of u, in the unit of the input.
    double gain = 0.0;         ///< Proportional gain [input/N].
    double reset = 1e30;       ///< Integral time [s]; large values disable the integral.
    double rate = 0.0;         ///< Derivative time [s].
    double filter = 0.0;       ///< Time constant of the derivative's filter [s]; 0: none.
    double low = -1e30;        ///< Lower limit of u, in the unit of the input.
    double high = 1e30;        ///< Upper limit of u, in the unit of the input.
};

/// PID controller. Signals: input `target` [N]; outputs `measured` [N], `output` [input].
class Pid final : public System {
  public:
    explicit Pid(PidDef def) : def_(std::move(def)), target_(def_.target) {}

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void holds(HoldTable& table) const override {
        table.hold(def_.measured);
        table.hold(def_.driven);
    }
    void prestep(Prestep& now, Loads&) noexcept override {
        // NaN ends the step.
        if (!read(now.world)) return now.set_input(def_.driven, std::nan(""));
        if (started_ == 0) smooth_ = measured_;
        const double share = now.step / (now.step + def_.filter);
        const double change = share * (measured_ - smooth_) / now.step;
        smooth_ += share * (measured_ - smooth_);
        const double error = target_ - measured_, more = error * now.step / def_.reset;
        const double wanted =
            def_.bias + def_.gain * (error + integral_ + more - def_.rate * change);
        output_ = std::clamp(wanted, def_.low, def_.high);
        const bool further = (wanted - output_) * def_.gain * error > 0.0;
        if (!further) integral_ += more;
        started_ = 1;
        now.set_input(def_.driven, output_);
    }
    void visit_state(StateVisitor& v) override {
        for (double* x : {&target_, &measured_, &smooth_, &integral_, &output_}) v.visit(*x);
        v.visit(started_);
    }
    void check_state(const World&, StateRules& rules) const override {
        rules.require(started_ == 0 || started_ == 1, "whether it has started is no flag");
        rules.require(started_ == 0 || (output_ >= def_.low && output_ <= def_.high),
                      "the output is out of range");
    }
    void signals(SignalTable& table) override {
        table.input("target", "N", target_, -1e30, 1e30);
        table.output("measured", "N", measured_);
        table.output("output", "", output_);
    }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<Pid>(def_);
    }

  private:
    /// @return false if the interaction or row does not exist.
    bool read(const World& world) noexcept {
        try {
            const std::span<const double> force = world.force(def_.measured);
            const auto row = static_cast<std::size_t>(def_.row);
            if (row >= force.size()) return false;
            measured_ = def_.sign * force[row];
        } catch (const DefError&) {
            return false;
        }
        return true;
    }

    PidDef def_;
    double target_, measured_ = 0.0, smooth_ = 0.0;  ///< Measured value and its filtered value for
                                                     ///< the derivative.
    double integral_ = 0.0;                          ///< (1/reset) ∫ e dt.
    double output_ = 0.0;
    std::int32_t started_ = 0;
};

}  // namespace hawser
