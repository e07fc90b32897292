// SPDX-License-Identifier: Apache-2.0
#include "scene/mistakes.h"

#include <utility>

namespace hawser::scene {

void Mistakes::add_mistake(const SceneError& error) {
    SceneError noted(error.file, error.path, error.message + note);
    // Mistakes of a template that is used twice are listed once.
    if (list_.size() < kMaxMistakes && seen_messages_.insert(error.what()).second) {
        list_.push_back(std::move(noted));
    }
}

bool Mistakes::is_omitted(OmittedPart what, const std::string& name) const {
    if (omitted_.contains({what, "*"}) || omitted_.contains({what, name})) {
        return true;
    }
    for (std::size_t slash = name.find('/'); slash != std::string::npos;
         slash = name.find('/', slash + 1)) {
        if (omitted_.contains({what, name.substr(0, slash)})) {
            return true;
        }
    }
    return false;
}

void report_missing(const Mistakes* mistakes, OmittedPart what, const std::string& name,
                    const SourceLocation& location, const std::string& message) {
    if (mistakes != nullptr && mistakes->is_omitted(what, name)) {
        throw Consequence(location.file, location.path, message);
    }
    throw_error(location, message);
}

}  // namespace hawser::scene
