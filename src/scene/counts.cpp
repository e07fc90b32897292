// SPDX-License-Identifier: Apache-2.0
#include "scene/counts.h"

#include "scene/checks.h"
#include "scene/description.h"

#include <fmt/format.h>

#include <map>
#include <string>

namespace hawser::scene {
namespace {

/// Least numbers of bodies and interactions for a part of a document. They are doubles, which do
/// not overflow.
struct Count {
    double bodies = 0.0, interactions = 0.0;
    void add(const Count& other, double times = 1.0) {
        bodies += times * other.bodies;
        interactions += times * other.interactions;
    }
};

double size_of(const Json& from, const char* key) {
    const auto at = from.find(key);
    return at != from.end() && at->is_array() ? static_cast<double>(at->size()) : 0.0;
}

double integer_or(const Json& from, const char* key, double otherwise) {
    const auto at = from.find(key);
    return at != from.end() && at->is_number_integer() ? at->get<double>() : otherwise;
}

double elements_of_cable(const Json& cable) {
    double elements = integer_or(cable, "elements", 1.0);
    const auto sections = cable.find("sections");
    if (sections == cable.end() || !sections->is_array()) return elements;
    elements = 0.0;
    for (const Json& section : *sections)
        elements += section.is_object() ? integer_or(section, "elements", 1.0) : 1.0;
    return elements;
}

double fixed_ends(const Json& cable) {
    double out = 0.0;
    for (const char* key : {"from", "to"})
        if (const auto end = cable.find(key); end != cable.end() && end->is_object())
            out += end->contains("at") ? 1.0 : 0.0;
    return out;
}

class PartCounter {
  public:
    explicit PartCounter(const Json& root)
        : templates_(root.find("templates")), lines_(root.find("line_types")), end_(root.end()) {}

    /// Count the bodies and interactions of a part of the document. @param largest  Set to the path
    /// of the entry with the largest count.
    Count of(const Json& part, int depth, std::string* largest = nullptr) {
        Count out{size_of(part, "bodies"), size_of(part, "interactions")};
        double most = out.bodies + out.interactions;
        const auto add = [&](const Count& count, const std::string& path) {
            out.add(count);
            if (largest == nullptr || count.bodies + count.interactions <= most) return;
            most = count.bodies + count.interactions;
            *largest = path;
        };
        if (const auto cables = part.find("cables"); cables != part.end() && cables->is_array())
            for (std::size_t i = 0; i < cables->size(); ++i) {
                const Json& cable = (*cables)[i];
                if (!cable.is_object()) continue;
                const double elements = elements_of_cable(cable);
                // Bodies: nodes between the ends, and fixed ends. Interactions: a joint or a
                // stretch for each element, a bend for each node.
                const Count count{elements - 1.0 + fixed_ends(cable),
                                  elements + (has_bends(cable) ? elements - 1.0 : 0.0)};
                add(count, "/cables/" + std::to_string(i) +
                               (cable.contains("elements") ? "/elements" : ""));
            }
        const auto instances = part.find("instances");
        if (instances == part.end() || !instances->is_array()) return out;
        for (std::size_t i = 0; i < instances->size(); ++i) {
            const Json& instance = (*instances)[i];
            if (!instance.is_object()) continue;
            const auto name = instance.find("template");
            if (name != instance.end() && name->is_string())
                add(of_template(name->get<std::string>(), depth + 1),
                    "/instances/" + std::to_string(i));
        }
        return out;
    }

  private:
    [[nodiscard]] bool has_bends(const Json& cable) const {
        const auto name = cable.find("line_type");
        if (name == cable.end() || !name->is_string() || lines_ == end_ || !lines_->is_object())
            return false;
        const auto line = lines_->find(name->get_ref<const std::string&>());
        return line != lines_->end() && line->is_object() && number_or(*line, "EI", 0.0) > 0.0;
    }

    /// Count the bodies and interactions of a template, once. A template that contains itself is
    /// rejected during expansion.
    Count of_template(const std::string& name, int depth) {
        if (const auto known = counted_.find(name); known != counted_.end()) return known->second;
        if (depth > kMaxNesting || templates_ == end_ || !templates_->is_object()) return {};
        const auto content = templates_->find(name);
        if (content == templates_->end() || !content->is_object()) return {};
        counted_[name] = {};
        return counted_[name] = of(*content, depth);
    }

    Json::const_iterator templates_, lines_, end_;
    std::map<std::string, Count> counted_;
};

}  // namespace

void check_counts(const Document& document, std::int64_t max_bodies,
                  std::int64_t max_interactions) {
    const Json& root = document.root;
    Count all;
    double copies = 1.0;
    if (const auto repeat = root.find("repeat"); repeat != root.end() && repeat->is_object())
        copies = integer_or(*repeat, "copies", 1.0);
    std::string largest;
    all.add(PartCounter(root).of(root, 0, &largest), std::max(copies, 1.0));
    const SourceLocation location{document.location.file, document.location.path + largest};
    const auto check = [&](double count, std::int64_t most, const char* what) {
        if (count > static_cast<double>(most))
            throw_error(location,
                        fmt::format("the scene asks for {:.0f} {}, copies included, more than {} "
                                    "(settings.max_{})",
                                    count, what, most, what));
    };
    check(all.bodies, max_bodies, "bodies");
    check(all.interactions, max_interactions, "interactions");
}

}  // namespace hawser::scene
