// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Does what a scene's timeline says.

#include <hawser/timeline.h>

#include <cstddef>
#include <span>

namespace hawser::session {

/// What is due by it was done before the step that led to the present state [s].
[[nodiscard]] double last_done(const World& world) noexcept;

class Timeline {
  public:
    /// Operations before the step that led to the present state have been done.
    void skip(std::span<const scene::Operation> all, const World& world) noexcept;
    /// Those that are due, in order. @throws DefError with time and operation where one cannot be
    /// done.
    void take(std::span<const scene::Operation> all, World& world);
    /// Whether one of those that have been done has set an input or signal after a time [s].
    [[nodiscard]] bool sets(std::span<const scene::Operation> all, const std::string& name,
                            double after) const;
    /// Those that the last take() has done.
    [[nodiscard]] std::span<const scene::Operation> done(
        std::span<const scene::Operation> all) const noexcept {
        return all.subspan(begun_, next_ - begun_);
    }

  private:
    std::size_t next_ = 0;   ///< The first that is not done yet.
    std::size_t begun_ = 0;  ///< That was so before the last take().
};

}  // namespace hawser::session
