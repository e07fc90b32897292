// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_options.h
/// Common options of several commands that change a scene while it is read.

#include <hawser/scene.h>

#include "record/scene_info.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hawser::cli {

/// Default number of parts for showing a scene, without --parts.
inline constexpr int kDefaultParts = 4;

struct SceneOptions {
    std::string file;
    std::optional<double> step;
    std::optional<std::string> form, nonsmooth, coupling, predictor;
    std::optional<int> sweeps, parts;
    std::optional<double> sleep;  ///< Value of --sleep [s]
    int threads = 1;
    double budget_ms = 0.0, budget_mflop = 0.0;  ///< Budgets; 0: none. `run` has options for them.
    int scale = 1;
    std::vector<std::string> set;
    std::vector<std::string> controls;  ///< Files of --control; `run` and `view` have it.

    /// Add the command-line options that name a scene. @param required  True if the scene must be
    /// named.
    void add_to(CLI::App& command, bool required = true);
    /// Add the options that change a scene before it starts.
    void add_changes_to(CLI::App& command);
    /// Load the scene. @throws scene::SceneError of the first mistake, with the number of further
    /// mistakes.
    [[nodiscard]] scene::Scene load() const;
    /// Load the scene and collect all mistakes. @return null if there are any.
    [[nodiscard]] std::optional<scene::Scene> load(std::vector<scene::SceneError>& mistakes) const;
    /// Add --control: inputs over time, as CSV, and operations, as JSON.
    void add_control_to(CLI::App& command);
    /// Return the file of inputs over time; "": none. @throws std::runtime_error for two.
    [[nodiscard]] std::string control() const;
    /// Return the file of operations; "": none. @throws std::runtime_error for two.
    [[nodiscard]] std::string operations() const;
    /// Return the options in the form for the readers of scenes and exercises.
    [[nodiscard]] scene::Options options() const;
};

}  // namespace hawser::cli
