// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Does what a scene's timeline says, and keeps what a restored session needs to have the same
/// world: a state belongs to a world of the same bodies and interactions.

#include <hawser/timeline.h>

#include "record/changes.h"

#include <cstddef>
#include <span>
#include <vector>

namespace hawser::session {

class Timeline {
  public:
    /// Operations before the step that led to the present state have been done.
    void skip(std::span<const scene::Operation> all, const World& world) noexcept;
    /// Those that are due, in order. @param recorder  Listener of the world, or null.
    /// @throws DefError with time and operation where one cannot be done.
    void take(std::span<const scene::Operation> all, World& world, record::ChangeBytes* recorder);
    /// States and changes of all that changed what the world is made of.
    [[nodiscard]] std::span<const std::byte> history() const noexcept { return history_; }
    void set_history(std::vector<std::byte> history) noexcept { history_ = std::move(history); }

  private:
    void change_structure(const scene::Operation& operation, World& world,
                          record::ChangeBytes* recorder);

    std::size_t next_ = 0;  ///< The first that is not done yet.
    std::vector<std::byte> history_;
};

}  // namespace hawser::session
