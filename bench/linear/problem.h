// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file problem.h
/// A matrix of the comparison with all data that are prepared once for every solver.

#include "linear/reference.h"
#include "linear/solver.h"
#include "paper_matrix/paper_matrix.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

struct Problem {
    explicit Problem(BlockSystem system);
    Problem(const Problem&) = delete;
    Problem& operator=(const Problem&) = delete;

    [[nodiscard]] Input input(bool condensed) const {
        return {&system, &form[condensed], matrix[condensed].get(), &inverse};
    }

    BlockSystem system;
    BlockForm form[2];  ///< Saddle, condensed.
    std::unique_ptr<ScalarMatrix> matrix[2];
    std::vector<double> inverse;  ///< Scratch memory of the condensation: 1/Σ.
    std::optional<ReferenceSolution> reference;
};

/// A problem by name, made when it is used.
struct ProblemSource {
    std::string name;
    BlockSystem (*make)(int scale) = nullptr;
    int scale = 1;
    std::optional<PaperOptions> paper{};  ///< If set, contacts can change.
    std::string file{}, blocks{};         ///< Matrix Market file, or a scene.
    bool named_only = false;              ///< Only if the user names it.

    [[nodiscard]] BlockSystem system() const;
};

/// Return the benchmark's matrices for the given scales of paper and scene.
[[nodiscard]] std::vector<ProblemSource> standard_problems(const std::vector<int>& scales,
                                                           const std::string& scene);

/// Make the pattern of a scene's step with bodies and rows, with values of the size in such a step:
/// masses about 1e3 kg, couplings that keep A definite, compliance 1e-6.
[[nodiscard]] BlockSystem scene_system(const std::string& file, int scale);

}  // namespace hawser::bench
