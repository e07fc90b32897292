// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sampled.h
/// Verify some steps of a run (certificate.h): the first ones, three of every 600, three after an
/// event, and the last ones. The choice depends on the run alone, never on a clock.
///
/// Omitted are loads of the sea, which cost forty times a step, steps that report themselves as
/// unsolved, and states. The monitors of the world check those two in every step, and their message
/// has time, place and remedy (docs/limits.md). Momentum and bounds are compared
/// to 1e-5, whereas `hawser run --verify` compares to 1e-9.

#include "verify/certificate.h"

#include <cstdint>
#include <optional>
#include <string>

namespace hawser::verify {

class SampledVerifier : public Observer {
  public:
    /// Create a verifier. @param last  Last step of the run.
    SampledVerifier(const World& world, std::int64_t last);
    void before_step(const World& world) override;
    void after_step(const World& world, std::span<const Event> events) override;
    [[nodiscard]] std::string objection() const override { return objection_; }
    [[nodiscard]] std::int64_t steps() const noexcept { return steps_; }

  private:
    std::optional<Verifier> verifier_;  ///< Empty if groups of bodies may be split.
    std::int64_t last_ = 0, interval_begin_ = 0, steps_ = 0;
    int steps_left_ = 0;  ///< Remaining steps of the present interval.
    bool events_happened_ = false;
    std::string objection_;
};

}  // namespace hawser::verify
