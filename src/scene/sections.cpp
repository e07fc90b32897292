// SPDX-License-Identifier: Apache-2.0
#include "scene/sections.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

/// A section: its key and the reader of its entries.
struct SectionReader {
    const char* key;
    SectionItem (*read)(const Description& out, const Scope& scope, const Json& json,
                        const SourceLocation& location);
};
constexpr SectionReader kReaders[] = {
#define HAWSER_SECTION_ENTRY(key, item, entries, doc) {#key, read_##item},
    HAWSER_SCENE_SECTIONS(HAWSER_SECTION_ENTRY)
#undef HAWSER_SECTION_ENTRY
};

}  // namespace

void expand_sections(Description& out, const Scope& scope) {
    for (const SectionReader& section : kReaders) {
        const auto list = scope.content->find(section.key);
        if (list == scope.content->end()) continue;
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Json& json = (*list)[i];
            if (json.is_null()) continue;  // Left out: mistakes.h.
            const SourceLocation location = scope.location / section.key / i;
            (void)attempt(out.mistakes, [&] {
                SectionItem item = section.read(out, scope, json, location);
                item.name = scope.prefix + json["name"].get<std::string>();
                item.location = location;
                const auto same = [&](const SectionItem& other) { return other.name == item.name; };
                if (std::any_of(out.sections.begin(), out.sections.end(), same))
                    throw_error(location / "name",
                                "the name " + in_quotes(item.name) + " exists already");
                out.sections.push_back(std::move(item));
            });
        }
    }
}

void add_sections(World& world, const Description& from) {
    for (const SectionItem& item : from.sections)
        (void)attempt(from.mistakes, [&] {
            try {
                item.add(world, item.prefix, item.prefix + item.name);
            } catch (const DefError& error) {
                throw_error(item.location, error.what());
            }
        });
}

std::string interaction_name(const Description& out, const Scope& scope, const Json& json,
                             const char* key, const SourceLocation& location) {
    const InteractionId id =
        resolve_interaction(out, scope, json[key].get<std::string>(), location / key);
    return out.interactions[static_cast<std::size_t>(id.index)].name;
}

std::string input_name(const Description& out, const Scope& scope, const Json& json,
                       const char* key, const SourceLocation& location) {
    const auto& local = json[key].get_ref<const std::string&>();
    std::vector<std::string> known;
    for (const InputDef& def : out.inputs) {
        if (def.name == scope.prefix + local) return def.name;
        if (def.name.starts_with(scope.prefix))
            known.push_back(def.name.substr(scope.prefix.size()));
    }
    throw_error(location / key, "there is no input " + in_quotes(local) + suggestion(local, known));
}

}  // namespace hawser::scene
