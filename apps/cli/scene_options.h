// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_options.h
/// Options that change a scene while it is read, common to several commands.

#include <hawser/scene.h>

#include "record/scene_info.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hawser::cli {

/// Parts that a scene is shown in where --parts does not say.
inline constexpr int kParts = 4;

struct SceneOptions {
    std::string file;
    std::optional<double> step;
    std::optional<std::string> form, nonsmooth, coupling, predictor;
    std::optional<int> sweeps, parts;
    std::optional<double> sleep;  ///< [s]
    int threads = 1;
    double budget_ms = 0.0, budget_mflop = 0.0;  ///< 0: none. `run` has options for them.
    int scale = 1;
    std::vector<std::string> set;
    std::vector<std::string> controls;  ///< Files of --control; `run` and `view` have it.

    /// @param required  Whether the scene must be named.
    void add_to(CLI::App& command, bool required = true);
    /// Options that change the scene, as far as its start depends on them.
    void add_changes_to(CLI::App& command);
    /// @throws scene::SceneError of the first mistake, which says how many more there are.
    [[nodiscard]] scene::Scene load() const;
    /// All mistakes in place of the first; nothing where there are any.
    [[nodiscard]] std::optional<scene::Scene> load(std::vector<scene::SceneError>& mistakes) const;
    /// --control: inputs over time, as CSV, and operations, as JSON.
    void add_control_to(CLI::App& command);
    /// The file of inputs over time among them; "": none. @throws std::runtime_error of two.
    [[nodiscard]] std::string control() const;
    /// The file of operations; "": none. @throws std::runtime_error of two.
    [[nodiscard]] std::string operations() const;
    /// As the readers of scenes and exercises take them.
    [[nodiscard]] scene::Options options() const;
};

}  // namespace hawser::cli
