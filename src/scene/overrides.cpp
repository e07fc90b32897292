// SPDX-License-Identifier: Apache-2.0
#include "scene/document.h"

#include <algorithm>
#include <charconv>

namespace hawser::scene {
namespace {

[[noreturn]] void throw_option_error(const SourceLocation& location, const std::string& option,
                                     const std::string& message) {
    throw_error(location, message + " (option " + in_quotes(option) + ")");
}

Json override_value(const std::string& text) {
    if (Json::accept(text)) {
        return Json::parse(text);
    }
    return text;
}

/// True for printable ASCII. Other characters would change when the text is resolved.
bool is_plain(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

/// Return the entry of a list by the value of its "name", or by its index.
Json* find_entry(Json& list, const std::string& word) {
    for (Json& entry : list) {
        if (entry.is_object() && entry.contains("name") && entry["name"] == word) {
            return &entry;
        }
    }
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), index);
    const bool whole = failure == std::errc() && end == word.data() + word.size();
    return whole && index < list.size() ? &list[index] : nullptr;
}

std::vector<std::string> names_in(const Json& value) {
    std::vector<std::string> names;
    if (value.is_object()) {
        for (const auto& [key, entry] : value.items()) {
            names.push_back(key);
        }
    } else if (value.is_array()) {
        for (const Json& entry : value) {
            if (entry.is_object() && entry.contains("name") && entry["name"].is_string()) {
                names.push_back(entry["name"].get<std::string>());
            }
        }
    }
    return names;
}

}  // namespace

void apply_override(Json& root, const std::string& option, const SourceLocation& location) {
    const auto equals = option.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw_option_error(location, option, "expected path=value, such as settings.step=0.01");
    }
    if (!is_plain(option)) {
        throw_option_error(location, "", "an option must be written in printable ASCII");
    }
    std::string rest = option.substr(0, equals);
    Json* here = &root;
    SourceLocation at = location;
    while (!rest.empty()) {
        // A name may contain dots: use the longest sequence of words that is a name.
        Json* next = nullptr;
        std::size_t end = rest.size();
        while (true) {
            const std::string word = rest.substr(0, end);
            if (here->is_array()) {
                next = find_entry(*here, word);
            } else if (here->is_object() && here->contains(word)) {
                next = &(*here)[word];
            }
            const auto dot = next != nullptr ? std::string::npos
                             : end == 0      ? std::string::npos
                                             : rest.rfind('.', end - 1);
            if (dot == std::string::npos) {
                break;
            }
            end = dot;
        }
        if (next == nullptr) {
            end = std::min(rest.find('.'), rest.size());
            const std::string word = rest.substr(0, end);
            const bool may_add =
                here->is_null() || (here->is_object() && (here == &root || end == rest.size()));
            if (!may_add) {
                throw_option_error(
                    at, option,
                    "there is no " + in_quotes(word) + " here" + suggestion(word, names_in(*here)));
            }
            // The file does not contain this key; the check of the shape rejects unknown keys.
            next = &(*here)[word];
        }
        const std::string word = rest.substr(0, end);
        at = here->is_array() ? at / static_cast<std::size_t>(next - &here->front()) : at / word;
        rest = end < rest.size() ? rest.substr(end + 1) : "";
        here = next;
    }
    *here = override_value(option.substr(equals + 1));
}

}  // namespace hawser::scene
