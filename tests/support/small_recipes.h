// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file small_recipes.h
/// Worlds of a few bodies, one of each type, for properties that every world must have.

#include "support/recipe.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace hawser::test {

struct Case {
    const char* name;
    std::function<Recipe()> make;
};

inline const Case kSmallRecipes[] = {
    {"pendulum", [] { return pendulum(); }},  {"link_chain", [] { return link_chain(12); }},
    {"wire", [] { return wire(20); }},        {"mixed_1", [] { return mixed(1); }},
    {"mixed_2", [] { return mixed(2, 10); }}, {"mixed_3", [] { return mixed(3, 14); }},
};

inline std::string name_of(const testing::TestParamInfo<Case>& each) { return each.param.name; }

}  // namespace hawser::test
