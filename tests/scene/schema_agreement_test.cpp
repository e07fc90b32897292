// SPDX-License-Identifier: Apache-2.0
// The checker and the published schema must agree. valijson is an independent implementation of
// JSON Schema. Documents are valid scenes with one value replaced, removed or added, at every
// position.
#include "scene/schema.h"

#include "support.h"

#include "good_scenes.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace hawser::scene::test {
namespace {

class Oracle {
  public:
    Oracle() {
        const Json text = Json::parse(schema_text());
        valijson::SchemaParser parser;
        parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema_);
    }
    bool accepts(const Json& document) {
        // Strong types: "1" is not a number.
        valijson::Validator validator(valijson::Validator::kStrongTypes);
        return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document),
                                  nullptr);
    }

  private:
    valijson::Schema schema_;
};

Oracle& oracle() {
    static Oracle instance;
    return instance;
}

void pointers_of(const Json& value, const std::string& at, std::vector<std::string>& all) {
    all.push_back(at);
    if (value.is_object()) {
        for (const auto& [key, entry] : value.items()) {
            pointers_of(entry, at + pointer_token(key), all);
        }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            pointers_of(value[i], at + "/" + std::to_string(i), all);
        }
    }
}

/// Return the distance between changed values: 1 changes every value.
std::size_t stride() {
    return static_cast<std::size_t>(::hawser::test::kSanitized
                                        ? ::hawser::test::by_tier(120, 40, 10)
                                        : ::hawser::test::by_tier(30, 2, 1));
}

struct Count {
    int documents = 0;
    int refused = 0;
};

void compare(const Json& document, const std::string& what, Count& count) {
    const auto problem = find_problem(document, *format().scene);
    ++count.documents;
    count.refused += problem ? 1 : 0;
    EXPECT_EQ(!problem, oracle().accepts(document))
        << what << (problem ? ": " + problem->path + ": " + problem->message : "");
}

class Agreement : public testing::TestWithParam<std::string_view> {};

TEST_P(Agreement, good_scene_is_accepted_by_both) {
    const Json scene = Json::parse(GetParam());
    const auto problem = find_problem(scene, *format().scene);
    EXPECT_FALSE(problem) << problem->path << ": " << problem->message;
    EXPECT_TRUE(oracle().accepts(scene));
}

TEST_P(Agreement, same_verdict_on_every_single_change) {
    const Json scene = Json::parse(GetParam());
    std::vector<std::string> all;
    pointers_of(scene, "", all);
    const std::vector<Json> replacements{
        nullptr, true,          -1,     0,         0.5,   1e300,          "text",     "${label}",
        "",      Json::array(), {1, 2}, {1, 2, 3}, {"a"}, Json::object(), {{"x", 1}}, "a b"};
    Count count;
    const std::size_t step = stride();
    for (std::size_t i = 1 + ::hawser::test::first_seed(0) % step; i < all.size(); i += step) {
        const Json::json_pointer at(all[i]);
        for (const Json& value : replacements) {
            Json changed = scene;
            changed[at] = value;
            compare(changed, all[i] + " = " + value.dump(), count);
        }
        Json less = scene;
        const Json::json_pointer parent = at.parent_pointer();
        if (less[parent].is_object()) {
            less[parent].erase(at.back());
        } else {
            less[parent].erase(std::stoul(at.back()));
        }
        compare(less, all[i] + " removed", count);
        if (scene[at].is_object()) {
            Json more = scene;
            more[at]["unknown_key"] = 1;
            compare(more, all[i] + " with another key", count);
        }
    }
    RecordProperty("documents", count.documents);
    // Neither result may dominate: the comparison would then prove nothing.
    EXPECT_GT(count.refused, count.documents / 10);
    EXPECT_LT(count.refused, count.documents);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement, testing::ValuesIn(kGoodScenes),
                         [](const auto& item) { return "scene" + std::to_string(item.index); });

TEST(Schema, refers_only_to_its_own_definitions) {
    const Json schema = Json::parse(schema_text());
    std::vector<std::string> all;
    pointers_of(schema, "", all);
    int references = 0;
    for (const std::string& at : all) {
        if (at.ends_with("/$ref")) {
            const auto target = schema[Json::json_pointer(at)].get<std::string>();
            ASSERT_TRUE(target.starts_with("#")) << at;
            EXPECT_TRUE(schema.contains(Json::json_pointer(target.substr(1)))) << target;
            ++references;
        }
    }
    EXPECT_GT(references, 50);
}

}  // namespace
}  // namespace hawser::scene::test
