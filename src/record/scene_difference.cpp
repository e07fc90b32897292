// SPDX-License-Identifier: Apache-2.0
#include "record/scene_difference.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace hawser::record {

namespace {

using DocumentJson = nlohmann::json;

/// Keys of the document that do not influence a state.
constexpr std::array<std::string_view, 6> kNoMatter = {
    "/name", "/description", "/plot", "/settings/duration", "/state", "/settings/threads"};

/// Numbers that belong to the structure: a state does not fit if they differ.
constexpr std::array<std::string_view, 1> kStructuralNumbers = {"/settings/step"};

class DocumentComparison {
  public:
    explicit DocumentComparison(SceneDifferences& out) : out_(out) {}

    void compare(const DocumentJson& before, const DocumentJson& now, const std::string& path) {
        if (!out_.structure.empty() || before == now || has(kNoMatter, path)) return;
        if (before.is_number() && now.is_number() && !has(kStructuralNumbers, path)) {
            out_.numbers.push_back(fmt::format("{}: {} -> {}", path, before.dump(), now.dump()));
        } else if (before.is_object() && now.is_object()) {
            compare_objects(before, now, path);
        } else if (before.is_array() && now.is_array() && before.size() == now.size()) {
            for (std::size_t i = 0; i < before.size(); ++i)
                compare(before[i], now[i], fmt::format("{}/{}", path, i));
        } else {
            add_difference(path, shortened_value(before), shortened_value(now));
        }
    }

  private:
    template <class List>
    static bool has(const List& list, const std::string& path) {
        return std::find(list.begin(), list.end(), path) != list.end();
    }
    static std::string shortened_value(const DocumentJson& value) {
        if (value.is_array()) return fmt::format("a list of {}", value.size());
        if (value.is_object()) return "an object";
        return value.dump();
    }
    void add_difference(const std::string& path, const std::string& before,
                        const std::string& now) {
        if (out_.structure.empty()) out_.structure = fmt::format("{}: {} -> {}", path, before, now);
    }
    void compare_objects(const DocumentJson& before, const DocumentJson& now,
                         const std::string& path) {
        for (const auto& [key, value] : before.items()) {
            const std::string at = fmt::format("{}/{}", path, key);
            const auto other = now.find(key);
            if (other != now.end())
                compare(value, *other, at);
            else if (!has(kNoMatter, at))
                value.is_number() ? number(at, value.dump(), "not given")
                                  : add_difference(at, shortened_value(value), "not there");
        }
        for (const auto& [key, value] : now.items()) {
            const std::string at = fmt::format("{}/{}", path, key);
            if (before.contains(key) || has(kNoMatter, at)) continue;
            value.is_number() ? number(at, "not given", value.dump())
                              : add_difference(at, "not there", shortened_value(value));
        }
    }
    void number(const std::string& path, const std::string& before, const std::string& now) {
        if (has(kStructuralNumbers, path)) return add_difference(path, before, now);
        out_.numbers.push_back(fmt::format("{}: {} -> {}", path, before, now));
    }

    SceneDifferences& out_;
};

}  // namespace

SceneDifferences compare_scenes(std::string_view before, std::string_view now) {
    SceneDifferences out;
    DocumentComparison(out).compare(DocumentJson::parse(before), DocumentJson::parse(now), "");
    return out;
}

}  // namespace hawser::record
