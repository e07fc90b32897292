// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coarsening.h
/// By how much wires are coarser so that steps keep to their budget (docs/methods.md, 11): the
/// first thing that is left out.
///
/// A step demands x, what it took over what it may, more than 1 where it was cut. x is reckoned
/// with as rates are (deadline.h): its mean and twice its deviation. Where that is above 1 wires
/// become coarser by a level. Nodes go one by one: another level follows only where the mean is
/// above 1 and has stopped falling; peaks above it are for iterations to be cut. Where the mean
/// stays below kRoom they become finer again by one level. Steps that analysed something teach
/// nothing: nodes that go do that.
///
/// While wires could be coarser and are not, and for kAct steps after, steps are solved whole.
///
/// Limits: what is learned is no part of the state. The level is recorded (Degradation::wires).

#include "context/deadline.h"

namespace hawser::stepper {

class Coarsening {
  public:
    static constexpr int kMost = 4;         ///< Levels.
    static constexpr int kAct = 60;         ///< Steps in which a mean that falls is seen to.
    static constexpr double kFalls = 0.97;  ///< Of it, by then.
    static constexpr int kStay = 240;       ///< Steps before a level gives way to the one below.
    static constexpr double kRoom = 0.6;    ///< That takes up to 1.5 times as much.

    bool possible = false;  ///< Some system would leave out more at a higher level.
    [[nodiscard]] int level() const noexcept { return level_; }
    /// Nothing else is to be left out yet.
    [[nodiscard]] bool comes_first() const noexcept {
        return possible && (level_ == 0 || (level_ == 1 && rises_ && since_ < kAct));
    }
    /// A step without analysis is done. @param demand  x.
    void learn(double demand) noexcept {
        rate_.learn(demand);
        mean_ = rate_.samples() == 1 ? demand : mean_ + 0.125 * (demand - mean_);
        if (rate_.samples() < Rate::kSettled) return;
        bool stands = level_ == 0;
        if (++since_ % kAct == 0) {
            stands = stands || mean_ > kFalls * before_;
            before_ = mean_;
        }
        const double demanded = level_ == 0 ? rate_.high() : mean_;
        if (stands && possible && level_ < kMost && demanded > 1.0)
            go_to(level_ + 1);
        else if (level_ > 0 && since_ >= kStay && mean_ < kRoom)
            go_to(level_ - 1);
    }

  private:
    void go_to(int level) noexcept {
        rises_ = level > level_;
        level_ = level;
        since_ = 0;
        before_ = mean_;
    }
    Rate rate_;
    double mean_ = 0.0, before_ = 0.0;
    int level_ = 0;
    bool rises_ = true;  ///< It has come from the level below.
    int since_ = 0;      ///< Steps at this level.
};

}  // namespace hawser::stepper
