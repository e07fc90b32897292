// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file verdict.h
/// Bars of a benchmark: printed, counted for the exit code, and stored for its JSON.

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>

namespace hawser::bench {

class Verdict {
  public:
    /// Record a bar. @param bar  Name of the bar, equal in every run. @param of  Object: a case, a
    /// scene; may be empty. @param what  Figures for a reader.
    void require(std::string bar, std::string of, bool met, std::string what) {
        fmt::print("  {:<6}  {}{}{}\n", met ? "ok" : "MISSED", of, of.empty() ? "" : ": ", what);
        list_.push_back({{"bar", std::move(bar)},
                         {"of", std::move(of)},
                         {"met", met},
                         {"what", std::move(what)}});
        all_met_ = all_met_ && met;
    }
    [[nodiscard]] bool all_met() const noexcept { return all_met_; }
    [[nodiscard]] int exit_code() const noexcept { return all_met_ ? 0 : 1; }
    [[nodiscard]] const nlohmann::json& json() const noexcept { return list_; }

  private:
    nlohmann::json list_ = nlohmann::json::array();
    bool all_met_ = true;
};

}  // namespace hawser::bench
