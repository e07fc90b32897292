// SPDX-License-Identifier: Apache-2.0
#include "scene/checks.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

/// Lists of things with a name, by key.
struct NamedList {
    const char* key;
    std::vector<OmittedPart> omissions;
};
const std::vector<NamedList>& named_lists() {
    static const std::vector<NamedList> lists{
        {"bodies", {OmittedPart::body}},
        {"interactions", {OmittedPart::interaction}},
        {"cables", {OmittedPart::body, OmittedPart::interaction, OmittedPart::cable}},
        {"cranes", {OmittedPart::body, OmittedPart::interaction}},
        {"instances", {OmittedPart::body, OmittedPart::interaction, OmittedPart::cable}},
        {"line_types", {OmittedPart::line_type}},
        {"templates", {OmittedPart::instance_template}},
        {"materials", {OmittedPart::material}}};
    return lists;
}

const std::vector<OmittedPart>& kinds_in(const std::string& key) {
    static const std::vector<OmittedPart> none;
    for (const NamedList& list : named_lists()) {
        if (key == list.key) {
            return list.omissions;
        }
    }
    return none;
}

std::vector<std::string> tokens_of(const std::string& path) {
    std::vector<std::string> tokens;
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find('/', begin + 1), path.size());
        std::string token = path.substr(begin + 1, end - begin - 1);
        // RFC 6901, section 4: "~1" before "~0".
        for (const auto& [code, letter] : {std::pair("~1", "/"), std::pair("~0", "~")}) {
            for (std::size_t at = 0; (at = token.find(code, at)) != std::string::npos; ++at) {
                token.replace(at, 2, letter);
            }
        }
        tokens.push_back(std::move(token));
        begin = end;
    }
    return tokens;
}

/// Remove an entry from a list and record that it is missing.
void remove_entry(Json& list, const std::string& index, const std::vector<OmittedPart>& kinds,
                  const std::string& prefix, Mistakes& mistakes) {
    std::size_t i = 0;
    std::from_chars(index.data(), index.data() + index.size(), i);
    if (i >= list.size() || list[i].is_null()) {
        return;
    }
    const bool named =
        list[i].is_object() && list[i].contains("name") && list[i]["name"].is_string();
    for (const OmittedPart what : kinds) {
        named ? mistakes.record_omitted(what, prefix + list[i]["name"].get<std::string>())
              : mistakes.record_omitted_unnamed(what);
    }
    list[i] = nullptr;
}

void drop(Json& root, const std::string& path, const std::string& prefix, Mistakes& mistakes) {
    const std::vector<std::string> tokens = tokens_of(path);
    if (tokens.empty() || !root.is_object() || !root.contains(tokens[0])) {
        return;
    }
    Json& top = root[tokens[0]];
    const std::vector<OmittedPart>& kinds = kinds_in(tokens[0]);
    if (tokens.size() == 1) {
        for (const OmittedPart what : kinds) {
            mistakes.record_omitted_unnamed(what);
        }
        root.erase(tokens[0]);
    } else if (top.is_array()) {
        remove_entry(top, tokens[1], kinds, prefix, mistakes);
    } else if (top.is_object()) {
        for (const OmittedPart what : kinds) {
            mistakes.record_omitted(what, tokens[1]);
        }
        top.erase(tokens[1]);
    }
}

/// Check a part of the document. @param above  Path from `root` to `value`.
void check_part(Json& root, const Json& value, const Shape& shape, const SourceLocation& location,
                const std::string& above, const std::string& prefix, Mistakes& mistakes) {
    const std::vector<Problem> problems = find_problems(value, shape, Mistakes::kMaxMistakes);
    for (const Problem& problem : problems) {
        mistakes.add_mistake(
            SceneError(location.file, location.path + problem.path, problem.message));
    }
    for (const Problem& problem : problems) {
        drop(root, above + problem.path, prefix, mistakes);
    }
}

}  // namespace

void check_document(Json& root, const Shape& shape, const SourceLocation& location,
                    Mistakes* mistakes) {
    if (mistakes == nullptr) {
        check_shape(root, shape, location);
    } else {
        check_part(root, root, shape, location, "", "", *mistakes);
    }
}

void check_list(Json& content, const char* key, const Shape& shape, const SourceLocation& location,
                const std::string& prefix, Mistakes* mistakes) {
    if (mistakes == nullptr) {
        check_shape(content[key], shape, location);
    } else {
        check_part(content, content[key], shape, location, pointer_token(key), prefix, *mistakes);
    }
}

}  // namespace hawser::scene
