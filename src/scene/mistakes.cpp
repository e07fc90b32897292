// SPDX-License-Identifier: Apache-2.0
#include "scene/mistakes.h"

#include <utility>

namespace hawser::scene {

void Mistakes::take(const SceneError& error) {
    SceneError noted(error.file, error.path, error.message + note);
    // Mistakes of a template that is used twice are listed once.
    if (list_.size() < kMaximum && seen_.insert(error.what()).second) {
        list_.push_back(std::move(noted));
    }
}

bool Mistakes::is_lost(Lost what, const std::string& name) const {
    if (lost_.contains({what, "*"}) || lost_.contains({what, name})) {
        return true;
    }
    for (std::size_t slash = name.find('/'); slash != std::string::npos;
         slash = name.find('/', slash + 1)) {
        if (lost_.contains({what, name.substr(0, slash)})) {
            return true;
        }
    }
    return false;
}

void refuse_missing(const Mistakes* mistakes, Lost what, const std::string& name,
                    const Place& place, const std::string& message) {
    if (mistakes != nullptr && mistakes->is_lost(what, name)) {
        throw Consequence(place.file, place.path, message);
    }
    refuse(place, message);
}

}  // namespace hawser::scene
