// SPDX-License-Identifier: Apache-2.0
#include "scene/error.h"

#include "base/edit_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hawser::scene {
namespace {

std::string error_text(const std::string& file, const std::string& path,
                       const std::string& message) {
    return path.empty() ? file + ": " + message : file + ": " + path + ": " + message;
}

// Names longer than this are not compared: the cost grows with the square.
constexpr std::size_t kLongestCompared = 64;
constexpr std::size_t kLongestList = 24;

}  // namespace

SceneError::SceneError(std::string file_, std::string path_, std::string message_)
    : std::runtime_error(error_text(file_, path_, message_)),
      file(std::move(file_)),
      path(std::move(path_)),
      message(std::move(message_)) {}

std::string pointer_token(std::string_view key) {
    std::string token = "/";
    for (const char c : key) {
        if (c == '~') {
            token += "~0";
        } else if (c == '/') {
            token += "~1";
        } else {
            token += c;
        }
    }
    return token;
}

SourceLocation SourceLocation::operator/(std::string_view key) const {
    return {file, path + pointer_token(key)};
}

SourceLocation SourceLocation::operator/(std::size_t index) const {
    return {file, fmt::format("{}/{}", path, index)};
}

void throw_error(const SourceLocation& location, const std::string& message) {
    throw SceneError(location.file, location.path, message);
}

std::string library_words(const DefError& error) {
    const std::string text = error.what();
    // Skip "kind 'NAME': ", or "kind: " if the object has no name.
    const std::string_view ends = text.find(" '") < text.find(": ") ? "': " : ": ";
    const auto at = text.find(ends);
    return at == std::string::npos ? text : text.substr(at + ends.size());
}

FieldWords field_words(const DefError& error) {
    const std::string words = library_words(error);
    constexpr const char* kOfPaths = "abcdefghijklmnopqrstuvwxyz_/0123456789EA";
    const auto ends = words.find(": ");
    if (ends == std::string::npos || words.find_first_not_of(kOfPaths) != ends) return {"", words};
    return {words.substr(0, ends), words.substr(ends + 2)};
}

void throw_field_error(const SourceLocation& location, const FieldWords& said) {
    throw_error(
        {location.file, said.path.empty() ? location.path : location.path + "/" + said.path},
        said.words);
}

std::string suggestion(std::string_view name, std::span<const std::string> known) {
    const std::string* best = nullptr;
    // About half of the letters may differ; a more different name probably means another object.
    std::size_t best_distance = std::max<std::size_t>(2, (name.size() + 2) / 2) + 1;
    if (name.size() <= kLongestCompared) {
        for (const std::string& candidate : known) {
            const std::size_t gap = candidate.size() > name.size() ? candidate.size() - name.size()
                                                                   : name.size() - candidate.size();
            if (gap >= best_distance) {
                continue;
            }
            const std::size_t distance = base::edit_distance(name, candidate);
            if (distance < best_distance) {
                best_distance = distance;
                best = &candidate;
            }
        }
    }
    if (best != nullptr) {
        return "; did you mean " + in_quotes(*best) + "?";
    }
    if (known.empty() || known.size() > kLongestList) {
        return "";
    }
    std::string list = "; known: ";
    for (std::size_t i = 0; i < known.size(); ++i) {
        list += (i == 0 ? "" : ", ") + known[i];
    }
    return list;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kMaxShownLength = 60;
    std::string shown(text.substr(0, kMaxShownLength));
    if (text.size() > kMaxShownLength) {
        shown += "…";
    }
    return "\"" + shown + "\"";
}

}  // namespace hawser::scene
