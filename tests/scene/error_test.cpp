// SPDX-License-Identifier: Apache-2.0
#include "scene/error.h"

#include "base/edit_distance.h"

#include <gtest/gtest.h>

namespace hawser::scene {
namespace {

TEST(EditDistance, counts_single_changes) {
    EXPECT_EQ(base::edit_distance("", ""), 0U);
    EXPECT_EQ(base::edit_distance("mass", "mass"), 0U);
    EXPECT_EQ(base::edit_distance("mass", ""), 4U);
    EXPECT_EQ(base::edit_distance("mass", "mas"), 1U);
    EXPECT_EQ(base::edit_distance("mass", "masss"), 1U);
    EXPECT_EQ(base::edit_distance("mass", "moss"), 1U);
    EXPECT_EQ(base::edit_distance("mass", "msas"), 1U);  // neighbours exchanged
    EXPECT_EQ(base::edit_distance("kitten", "sitting"), 3U);
}

TEST(Suggestion, names_the_nearest_or_lists_a_few) {
    const std::vector<std::string> known{"mass", "position", "velocity"};
    EXPECT_EQ(suggestion("positoin", known), "; did you mean \"position\"?");
    EXPECT_EQ(suggestion("colour", known), "; known: mass, position, velocity");
    EXPECT_EQ(suggestion("mas", {}), "");
    const std::vector<std::string> many(100, "body");
    EXPECT_EQ(suggestion("entirely_different", many), "");
}

TEST(SourceLocation, escapes_the_pointer) {
    const SourceLocation place{"f.json", ""};
    EXPECT_EQ((place / "bodies" / std::size_t{3} / "a/b~c").path, "/bodies/3/a~1b~0c");
    try {
        throw_error(place / "x", "message");
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_STREQ(error.what(), "f.json: /x: message");
        EXPECT_EQ(error.message, "message");
    }
}

}  // namespace
}  // namespace hawser::scene
