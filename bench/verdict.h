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
    void ask(std::string bar, std::string of, bool met, std::string what) {
        fmt::print("  {:<6}  {}{}{}\n", met ? "ok" : "MISSED", of, of.empty() ? "" : ": ", what);
        list_.push_back({{"bar", std::move(bar)},
                         {"of", std::move(of)},
                         {"met", met},
                         {"what", std::move(what)}});
        good_ = good_ && met;
    }
    [[nodiscard]] bool good() const noexcept { return good_; }
    [[nodiscard]] int exit_code() const noexcept { return good_ ? 0 : 1; }
    [[nodiscard]] const nlohmann::json& json() const noexcept { return list_; }

  private:
    nlohmann::json list_ = nlohmann::json::array();
    bool good_ = true;
};

}  // namespace hawser::bench
