// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file mistakes.h
/// All mistakes of a document in one go. Reading is the same with and without a list: without one
/// the first mistake is thrown, with one it is taken down and what it is in is left out. What then
/// is missing is no mistake of its own: an interaction of a body with a wrong mass names a body
/// that is there, as far as the writer is concerned.

#include "scene/error.h"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {

/// What can be left out, and be named from elsewhere.
enum class Lost { body, interaction, cable, line_type, instance_template, material };

/// Something cannot be read because something else was left out.
struct Consequence : SceneError {
    using SceneError::SceneError;
};

class Mistakes {
  public:
    /// Nobody corrects more in one go.
    static constexpr std::size_t kMost = 1000;

    [[nodiscard]] const std::vector<SceneError>& list() const { return list_; }
    [[nodiscard]] bool none() const { return list_.empty(); }
    void take(const SceneError& error);

    /// Left out: this name and all that begin with it and a slash (parts of a cable, an instance).
    void lose(Lost what, const std::string& name) { lost_.emplace(what, name); }
    /// Left out, and no one knows its name.
    void lose_any(Lost what) { lost_.emplace(what, "*"); }
    [[nodiscard]] bool is_lost(Lost what, const std::string& name) const;
    /// Shapes, bodies or cables are missing.
    [[nodiscard]] bool incomplete() const { return !lost_.empty(); }

    std::string note;  ///< Ending of messages met now: " (in the instance …)".

  private:
    std::vector<SceneError> list_;
    std::set<std::string> seen_;
    std::set<std::pair<Lost, std::string>> lost_;
};

/// Run `work`. A mistake in it is taken down where there is a list, else thrown on.
/// @return false where it was taken down.
template <class Work>
bool attempt(Mistakes* mistakes, const Work& work) {
    if (mistakes == nullptr) {
        work();
        return true;
    }
    try {
        work();
        return true;
    } catch (const Consequence&) {
        return false;
    } catch (const SceneError& error) {
        mistakes->take(error);
        return false;
    }
}

/// What is named is not there. @throws Consequence where it was left out, else SceneError.
[[noreturn]] void refuse_missing(const Mistakes* mistakes, Lost what, const std::string& name,
                                 const Place& place, const std::string& message);

}  // namespace hawser::scene
