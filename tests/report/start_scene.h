// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file start_scene.h
/// Findings of the check of the start of a scene.

#include <hawser/scene.h>

#include "report/start/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hawser::test {

using report::start::Finding;
using report::start::FindingKind;

struct Started {
    scene::Scene scene;
    record::SceneInfo info;
    report::start::Findings found;

    explicit Started(scene::Scene loaded) : scene(std::move(loaded)) {
        info = record::make_scene_info(scene);
        found = report::start::check_start(info, scene.world);
    }

    [[nodiscard]] std::vector<Finding> of(FindingKind kind) const {
        std::vector<Finding> out;
        for (const Finding& f : found.list)
            if (f.kind == kind) out.push_back(f);
        return out;
    }
    [[nodiscard]] std::string text() const { return to_text(found, ""); }
};

/// Check a scene whose document consists of the given members, "version" and "name".
inline Started start_of(const std::string& members) {
    return Started(
        scene::load_text(R"({"version": 1, "name": "start", )" + members + "}", "start.json"));
}

inline Started start_of_file(const std::string& file) { return Started(scene::load_file(file)); }

/// Return the only finding of this kind. Fails and returns an empty one if there are none or
/// several.
inline Finding only(const Started& started, FindingKind kind) {
    const std::vector<Finding> found = started.of(kind);
    EXPECT_EQ(found.size(), 1U) << started.text();
    return found.size() == 1 ? found[0] : Finding{};
}

using Names = std::vector<std::string>;

}  // namespace hawser::test
