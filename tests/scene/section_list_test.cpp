// SPDX-License-Identifier: Apache-2.0
// Lists of scenes and templates: one table (src/scene/section_list.h).
#include "scene/format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

namespace {

using hawser::scene::Field;
using hawser::scene::Shape;

std::set<std::string> keys_of(const Shape& shape) {
    std::set<std::string> keys;
    for (const Field& field : shape.fields) keys.insert(field.name);
    return keys;
}

const Shape& field_of(const Shape& shape, const std::string& key) {
    const auto found = std::find_if(shape.fields.begin(), shape.fields.end(),
                                    [&](const Field& field) { return field.name == key; });
    return *found->shape;
}

// A template has the lists of a scene and two keys of its own. A scene has in addition parts that
// exist once.
TEST(SectionList, TemplatesHaveTheListsOfScenes) {
    const Shape& scene = *hawser::scene::format().scene;
    const Shape& group = *field_of(scene, "templates").item;
    std::set<std::string> expected{"description", "parameters"};
    for (const auto& list : hawser::scene::list_formats()) {
        expected.insert(list.key);
        EXPECT_EQ(1U, keys_of(scene).count(list.key)) << list.key;
        EXPECT_TRUE(field_of(group, list.key).holds_placeholders) << list.key;
        EXPECT_FALSE(field_of(scene, list.key).holds_placeholders) << list.key;
        EXPECT_EQ(std::string("a list of ") + list.entries,
                  hawser::scene::format().list(list.key)->what);
    }
    EXPECT_EQ(expected, keys_of(group));
    for (const char* once : {"settings", "sea", "timeline", "repeat", "state", "plot"})
        EXPECT_EQ(1U, keys_of(scene).count(once)) << once;
    EXPECT_THROW((void)hawser::scene::format().list("sea"), std::out_of_range);
}

}  // namespace
