// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file mistakes.h
/// List all mistakes of a document. Reading is the same with and without a list. Without a list the
/// first mistake is thrown. With a list it is added to the list, and the faulty part is omitted.
/// References to an omitted part are no additional mistakes. Example: an interaction may name a
/// body that was omitted because of its mass.

#include "scene/error.h"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {

/// Kinds of omitted parts that other parts may name.
enum class OmittedPart { body, interaction, cable, line_type, instance_template, material };

/// A part cannot be read because another part was omitted.
struct Consequence : SceneError {
    using SceneError::SceneError;
};

class Mistakes {
  public:
    /// Capacity of the list.
    static constexpr std::size_t kMaxMistakes = 1000;

    [[nodiscard]] const std::vector<SceneError>& list() const { return list_; }
    [[nodiscard]] bool is_empty() const { return list_.empty(); }
    void add_mistake(const SceneError& error);

    /// Record an omitted name. It represents all names that begin with it and a slash (parts of a
    /// cable or of an instance).
    void record_omitted(OmittedPart what, const std::string& name) { omitted_.emplace(what, name); }
    /// Record an omitted part with unknown name.
    void record_omitted_unnamed(OmittedPart what) { omitted_.emplace(what, "*"); }
    [[nodiscard]] bool is_omitted(OmittedPart what, const std::string& name) const;
    /// True if shapes, bodies or cables are missing.
    [[nodiscard]] bool has_omitted_parts() const { return !omitted_.empty(); }

    std::string note;  ///< End of new messages: " (in the instance …)".

  private:
    std::vector<SceneError> list_;
    std::set<std::string> seen_messages_;
    std::set<std::pair<OmittedPart, std::string>> omitted_;
};

/// Run `work`. Add its mistake to the list, or throw it if there is no list. @return false if a
/// mistake was added.
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
        mistakes->add_mistake(error);
        return false;
    }
}

/// Report a name that does not exist. @throws Consequence if it was omitted, else SceneError.
[[noreturn]] void report_missing(const Mistakes* mistakes, OmittedPart what,
                                 const std::string& name, const SourceLocation& location,
                                 const std::string& message);

}  // namespace hawser::scene
