// SPDX-License-Identifier: Apache-2.0
#include <hawser/experimental/splits.h>
#include <hawser/inspect.h>

#include "support.h"

#include <algorithm>

namespace hawser::scene::test {
namespace {

std::string grouped(const std::string& settings, const std::string& group,
                    const std::string& groups) {
    return R"({"version": 1, "name": "t", "settings": {)" + settings + R"(},
      "line_types": {"wire": {"mass_per_length": 20, "EA": 1e6}},
      "bodies": [{"name": "a", "position": [0, 0, 10], "mass": 1e5, "box": [5, 2, 1])" +
           group + R"(}],
      "cables": [{"name": "c", "line_type": "wire", "from": {"body": "a", "point": [5, 0, 0]},
                  "to": {"free": [45, 0, 10]}, "elements": 8)" +
           groups + "}]}";
}

TEST(Groups, of_bodies_and_cables) {
    const Description d =
        flat(grouped(R"("coupling": "compliant", "predictor": "clique", "parts": 7)",
                     R"(, "group": 3)", R"(, "groups": ["near", 12])"));
    EXPECT_EQ(d.settings.coupling, Coupling::compliant);
    EXPECT_EQ(d.settings.predictor, Predictor::clique);
    EXPECT_EQ(d.parts, 7);
    EXPECT_EQ(body(d, "a").group, "3");
    EXPECT_EQ(body(d, "c/1").group, "near");
    EXPECT_EQ(body(d, "c/4").group, "near");
    EXPECT_EQ(body(d, "c/5").group, "12");
    EXPECT_EQ(body(d, "c/8").group, "12");
}

TEST(Groups, cut_where_they_meet) {
    const Scene s = load_text(grouped(R"("coupling": "kinematic")", R"(, "group": "near")",
                                      R"(, "groups": ["near", "far"])"),
                              "test.json");
    ASSERT_EQ(s.world.splits().cuts().size(), 1U);
    EXPECT_EQ(s.world.interaction_def(s.world.splits().cuts()[0].interaction).name, "c/s4");
    EXPECT_EQ(s.world.splits().cuts()[0].coupling, Coupling::kinematic);
}

TEST(Groups, come_from_the_partitioner_where_the_scene_has_none) {
    const std::string text = grouped(R"("coupling": "kinematic", "parts": 2)", "", "");
    EXPECT_FALSE(load_text(text, "test.json").world.splits().cuts().empty());
    Options exact;
    exact.set = {"settings.coupling=exact"};
    EXPECT_TRUE(load_text(text, "test.json", exact).world.splits().cuts().empty());
}

TEST(Groups, are_of_both_kinds_where_the_scene_says_so) {
    // Without "parts", the other bodies form one group without a name …
    const std::string own = R"(, "group": "near")";
    const Scene hand = load_text(grouped(R"("coupling": "kinematic")", own, ""), "test.json");
    EXPECT_EQ(hand.world.settings().parts, 0);
    // … and with "parts" they are distributed.
    const Scene both =
        load_text(grouped(R"("coupling": "kinematic", "parts": 3, "regroup_every": 7)", own, ""),
                  "test.json");
    EXPECT_EQ(both.world.settings().parts, 3);
    EXPECT_EQ(both.world.settings().regroup_every, 7);
    const std::vector<std::int32_t> groups = both.world.splits().groups();
    const BodyId hull = both.world.find_body("a");
    EXPECT_EQ(groups[static_cast<std::size_t>(hull.index)], 0);
    EXPECT_GT(*std::max_element(groups.begin(), groups.end()), 0);
    const Scene none =
        load_text(grouped(R"("coupling": "kinematic", "parts": 0)", "", ""), "test.json");
    EXPECT_TRUE(none.world.splits().cuts().empty());
}

TEST(Groups, refuse_what_they_are_not) {
    EXPECT_NE(refusal(grouped(R"("coupling": "loose")", "", "")), "");
    EXPECT_NE(refusal(grouped(R"("predictor": "guess")", "", "")), "");
    EXPECT_NE(refusal(grouped(R"("parts": -1)", "", "")), "");
    EXPECT_NE(refusal(grouped(R"("parts": 4097)", "", "")), "");
    EXPECT_NE(refusal(grouped(R"("regroup_every": -1)", "", "")), "");
    EXPECT_NE(refusal(grouped("", R"(, "group": [1])", "")), "");
    EXPECT_NE(refusal(grouped("", "", R"(, "groups": [])")), "");
    // Islands of a split cannot sleep.
    EXPECT_NE(refusal(grouped(R"("coupling": "kinematic", "sleep_after": 1)", "", "")), "");
}

}  // namespace
}  // namespace hawser::scene::test
