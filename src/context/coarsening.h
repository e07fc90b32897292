// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coarsening.h
/// By how much wires are coarser so that steps keep to their budget (docs/methods.md, 11): the
/// first thing that is left out.
///
/// A step demands x, what it would have taken as a whole over what it may take. x is reckoned with
/// as rates are (deadline.h): its mean and twice its deviation. Where that is above 1 wires become
/// coarser by a level, and by another one once the first has had time to act; where it stays below
/// kRoom they become finer again by one. Steps that analysed something teach nothing: nodes that go
/// do that.
///
/// While wires could be coarser and are not, steps are solved whole.
///
/// Limits: what is learned is no part of the state. The level is recorded (Degradation::wires).

#include "context/deadline.h"

namespace hawser::stepper {

class Coarsening {
  public:
    static constexpr int kMost = 4;       ///< Levels.
    static constexpr int kAct = 60;       ///< Steps that a level has to act before the next.
    static constexpr int kStay = 240;     ///< And before the one below.
    static constexpr double kRoom = 0.6;  ///< A level down takes up to 1.5 times as much.

    bool possible = false;  ///< Some system would leave out more at a higher level.
    [[nodiscard]] int level() const noexcept { return level_; }
    /// Nothing else is to be left out yet.
    [[nodiscard]] bool comes_first() const noexcept { return possible && level_ == 0; }
    /// A step without analysis is done. @param demand  x.
    void learn(double demand) noexcept {
        rate_.learn(demand);
        if (since_ < kStay) ++since_;
        const bool settled = rate_.samples() >= Rate::kSettled;
        if (settled && possible && level_ < kMost && rate_.high() > 1.0 &&
            (level_ == 0 || since_ >= kAct))
            go_to(level_ + 1);
        else if (level_ > 0 && since_ >= kStay && rate_.high() < kRoom)
            go_to(level_ - 1);
    }

  private:
    void go_to(int level) noexcept {
        level_ = level;
        since_ = 0;
    }
    Rate rate_;
    int level_ = 0, since_ = 0;
};

}  // namespace hawser::stepper
