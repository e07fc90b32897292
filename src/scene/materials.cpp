// SPDX-License-Identifier: Apache-2.0
#include <hawser/material_fields.h>

#include "scene/description.h"
#include "scene/field_reader.h"

#include <algorithm>

namespace hawser::scene {
namespace {

MaterialId find_material(const Description& out, const std::string& name,
                         const SourceLocation& location) {
    if (name == "default") {
        return MaterialId{0};
    }
    std::vector<std::string> known{"default"};
    for (std::size_t i = 0; i < out.materials.size(); ++i) {
        if (out.materials[i].name == name) {
            return MaterialId{static_cast<std::int32_t>(i) + 1};
        }
        known.push_back(out.materials[i].name);
    }
    report_missing(out.mistakes, OmittedPart::material, name, location,
                   "there is no material " + in_quotes(name) + suggestion(name, known));
}

/// Call f(name, place) for a word or for each word of a list.
template <class F>
void each_name(const Json& names, const SourceLocation& location, const F& f) {
    if (names.is_string()) {
        f(names.get<std::string>(), location);
        return;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        f(names[i].get<std::string>(), location / i);
    }
}

using MaterialPairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

void expand_pair(Description& out, const Json& json, MaterialPairs& seen,
                 const SourceLocation& location) {
    const auto one = [&](std::size_t k) {
        return find_material(out, json["between"][k].get<std::string>(), location / "between" / k);
    };
    MaterialPairDef pair;
    pair.a = one(0);
    pair.b = one(1);
    const std::pair<std::int32_t, std::int32_t> key = std::minmax(pair.a.index, pair.b.index);
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
        throw_error(location, "these two materials have a pair already");
    }
    seen.push_back(key);
    read_fields(pair.values, json, kMaterialFields);
    out.material_pairs.push_back(pair);
}

}  // namespace

void expand_materials(Description& out, const Document& document) {
    const auto list = document.root.find("materials");
    if (list != document.root.end()) {
        for (const auto& [name, value] : list->items()) {
            const auto elsewhere = document.materials.find(name);
            const SourceLocation location = elsewhere != document.materials.end()
                                                ? elsewhere->second
                                                : document.location / "materials" / name;
            const bool good = attempt(out.mistakes, [&] {
                if (!is_valid_name(name)) {
                    throw_error(location,
                                in_quotes(name) + " is not a name: letters, digits and _ . + -");
                }
                if (name == "default") {
                    throw_error(location,
                                "the material \"default\" is always there; choose another name");
                }
            });
            if (!good) {
                continue;
            }
            MaterialDef def;
            def.name = name;
            read_fields(def, value, kMaterialFields);
            out.materials.push_back(std::move(def));
        }
    }
    const auto pairs = document.root.find("material_pairs");
    if (pairs == document.root.end()) {
        return;
    }
    MaterialPairs seen;
    for (std::size_t i = 0; i < pairs->size(); ++i) {
        const Json& json = (*pairs)[i];
        if (json.is_null()) {
            continue;  // Left out: mistakes.h.
        }
        const SourceLocation location = document.location / "material_pairs" / i;
        (void)attempt(out.mistakes, [&] { expand_pair(out, json, seen, location); });
    }
}

void read_surface(ShapeDef& def, Description& out, const Json& json,
                  const SourceLocation& location) {
    if (json.contains("material")) {
        def.material =
            find_material(out, json["material"].get<std::string>(), location / "material");
    }
    if (json.contains("groups")) {
        def.group = out.groups(json["groups"], location / "groups");
    }
    if (json.contains("touches")) {
        def.touches = out.touched(json["touches"], location / "touches");
    }
}

std::uint32_t Description::groups(const Json& names, const SourceLocation& location) {
    std::uint32_t bits = 0;
    each_name(names, location, [&](const std::string& name, const SourceLocation& at) {
        auto found = std::find(group_names_.begin(), group_names_.end(), name);
        if (found == group_names_.end()) {
            if (group_names_.size() >= kMaxGroups) {
                throw_error(at, "the scene has more than 32 groups, \"default\" included");
            }
            found = group_names_.insert(found, name);
        }
        const std::uint32_t bit = 1U << (found - group_names_.begin());
        named_groups_ |= bit;
        bits |= bit;
    });
    return bits;
}

std::uint32_t Description::touched(const Json& names, const SourceLocation& location) {
    const std::uint32_t before = named_groups_;
    std::uint32_t bits = 0;
    each_name(names, location, [&](const std::string& name, const SourceLocation& at) {
        const std::uint32_t bit = groups(name, at);
        touched_at_.emplace_back(bit, at);
        bits |= bit;
    });
    named_groups_ = before;  // A group named here gets no members.
    return bits;
}

void Description::check_groups() const {
    std::vector<std::string> known{"default"};
    for (std::size_t g = 1; g < group_names_.size(); ++g) {
        if ((named_groups_ >> g & 1U) != 0) {
            known.push_back(group_names_[g]);
        }
    }
    for (const auto& [bit, location] : touched_at_) {
        if (bit == 1U || (named_groups_ & bit) != 0) {
            continue;
        }
        std::size_t g = 0;
        while (bit >> g != 1U) {
            ++g;
        }
        (void)attempt(mistakes, [&] {
            throw_error(location, "no shape is in the group " + in_quotes(group_names_[g]) +
                                      suggestion(group_names_[g], known));
        });
    }
}

}  // namespace hawser::scene
