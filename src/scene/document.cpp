// SPDX-License-Identifier: Apache-2.0
#include "scene/document.h"

#include "scene/checks.h"

#include <algorithm>
#include <set>

namespace hawser::scene {
namespace {

/// Gathers line types, templates and materials of included files.
class Includer {
  public:
    Includer(Document& document, std::filesystem::path root_folder)
        : document_(document), root_folder_(std::move(root_folder)) {}

    /// Merge the files that `content` includes, and its own entries unless it is the scene itself.
    /// `content` was read from `file`.
    void merge(const Json& content, const std::filesystem::path& file, int depth) {
        const SourceLocation location{file.string(), ""};
        if (depth > 0) {
            insert_content(content, "line_types", location, document_.line_types);
            insert_content(content, "templates", location, document_.templates);
            insert_content(content, "materials", location, document_.materials);
        }
        const auto list = content.find("include");
        if (list == content.end()) {
            return;
        }
        for (std::size_t i = 0; i < list->size(); ++i) {
            const SourceLocation entry = location / "include" / i;
            const bool read = attempt(document_.mistakes, [&] {
                if (!(*list)[i].is_null()) {
                    include((*list)[i].get<std::string>(), file, depth, entry);
                }
            });
            if (!read) {
                omit_file_contents();
            }
        }
    }

  private:
    void include(const std::string& name, const std::filesystem::path& from, int depth,
                 const SourceLocation& entry) {
        if (depth >= kMaxIncludeDepth) {
            throw_error(entry, "includes are nested more than " + std::to_string(kMaxIncludeDepth) +
                                   " deep");
        }
        const auto file = resolve_inside(root_folder_, from.parent_path(), name, entry);
        const auto key = std::filesystem::weakly_canonical(file).string();
        if (std::find(open_.begin(), open_.end(), key) != open_.end()) {
            throw_error(entry, "the file " + in_quotes(name) +
                                   " includes itself, directly or through "
                                   "others");
        }
        if (!included_.insert(key).second) {
            return;  // The file was included before by another route.
        }
        document_.files.push_back(file);
        Json content =
            read_json_file(file, outermost_keys(), document_.mistakes, "a part of a scene");
        check_document(content, *format().part, {file.string(), ""}, document_.mistakes);
        if (!content.is_object()) {
            return omit_file_contents();
        }
        open_.push_back(key);
        merge(content, file, depth + 1);
        open_.pop_back();
    }

    void insert_content(const Json& content, const char* what, const SourceLocation& location,
                        std::map<std::string, SourceLocation, std::less<>>& places) {
        const auto entries = content.find(what);
        if (entries == content.end()) {
            return;
        }
        for (const auto& [name, value] : entries->items()) {
            const SourceLocation at = location / what / name;
            if (document_.root.contains(what) && document_.root[what].contains(name)) {
                const auto other = places.find(name);
                const std::string& other_file =
                    other == places.end() ? document_.location.file : other->second.file;
                (void)attempt(document_.mistakes, [&, &taken = name] {
                    throw_error(at, in_quotes(taken) + " is already defined in " + other_file);
                });
                continue;
            }
            document_.root[what][name] = value;
            places.emplace(name, at);
        }
    }

    void omit_file_contents() {
        for (const OmittedPart what :
             {OmittedPart::line_type, OmittedPart::instance_template, OmittedPart::material}) {
            document_.mistakes->record_omitted_unnamed(what);
        }
    }

    Document& document_;
    std::filesystem::path root_folder_;
    std::vector<std::string> open_;
    std::set<std::string> included_;
};

/// Append the timeline operations of a file to those of the scene. They have been checked in that
/// file.
void add_operations(Document& document, const std::string& file) {
    document.operations = {file, ""};
    document.files.emplace_back(file);
    Json list = read_json_file(file, outermost_keys(), document.mistakes, "a list of operations");
    if (!list.is_array()) check_document_kind(list, file, "a list of operations");
    check_document(list, *format().operations, document.operations, document.mistakes);
    if (!list.is_array()) return;
    Json& timeline = document.root["timeline"];
    if (timeline.is_null()) timeline = Json::array();
    document.own_operations = timeline.size();
    for (Json& operation : list) timeline.push_back(std::move(operation));
}

void apply_options(Document& document, const Options& options) {
    Json& root = document.root;
    const bool changed = !options.set.empty() || options.step || options.form || options.scale != 1;
    if (!options.operations.empty())
        (void)attempt(document.mistakes, [&] { add_operations(document, options.operations); });
    // Options were meant for the whole document: skip them if parts with mistakes were removed.
    if (!changed || (document.mistakes != nullptr && !document.mistakes->is_empty())) {
        return;
    }
    for (const std::string& option : options.set) {
        (void)attempt(document.mistakes, [&] { apply_override(root, option, document.location); });
    }
    if (options.step) {
        root["settings"]["step"] = *options.step;
    }
    if (options.form) {
        const char* const words[] = {"auto", "saddle", "condensed"};
        root["settings"]["form"] = words[static_cast<std::size_t>(*options.form)];
    }
    if (options.scale != 1) {
        (void)attempt(document.mistakes, [&] {
            if (!root.contains("repeat")) {
                throw_error(
                    document.location,
                    "this scene cannot be scaled; it needs the key \"repeat\" with the offset "
                    "from one copy to the next");
            }
            root["repeat"]["copies"] = options.scale;
        });
    }
    check_document(root, *format().scene, document.location, document.mistakes);
}

void read_state(Document& document, const std::filesystem::path& file) {
    const auto state = document.root.find("state");
    if (state == document.root.end()) {
        return;
    }
    const SourceLocation location = document.location / "state";
    document.state = location / "bodies";
    if (state->contains("bodies")) {
        return;
    }
    if (!state->contains("file")) {
        throw_error(location, "needs the key \"file\" or \"bodies\"");
    }
    const auto stored = resolve_inside(file.parent_path(), file.parent_path(),
                                       (*state)["file"].get<std::string>(), location / "file");
    document.files.push_back(stored);
    document.state_file = stored;
    Json content = read_json_file(stored, outermost_keys(), document.mistakes, "a settled state");
    const SourceLocation stored_location{stored.string(), ""};
    check_document(content, *format().state, stored_location, document.mistakes);
    if (!content.is_object() || !content.contains("bodies")) {
        return;
    }
    *state = Json{{"bodies", std::move(content["bodies"])}};
    document.state = stored_location / "bodies";
}

}  // namespace

Document make_document(Json root, const std::filesystem::path& file, const Options& options,
                       Mistakes* mistakes) {
    Document document{.root = std::move(root),
                      .location = {file.string(), ""},
                      .line_types = {},
                      .templates = {},
                      .materials = {},
                      .operations = {},
                      .own_operations = 0,
                      .state = {},
                      .files = {},
                      .state_file = {},
                      .mistakes = mistakes};
    const bool has_content = document.root.is_object() && !document.root.contains("exercise") &&
                             (document.root.contains("version") || document.root.contains("name"));
    if (!has_content) check_document_kind(document.root, document.location.file, "a scene");
    check_document(document.root, *format().scene, document.location, mistakes);
    if (!document.root.is_object()) {
        return document;
    }
    const Json original = document.root.contains("include")
                              ? Json{{"include", document.root["include"]}}
                              : Json::object();
    Includer(document, file.parent_path()).merge(original, file, 0);
    document.root.erase("$schema");
    document.root.erase("include");
    apply_options(document, options);
    if (!attempt(mistakes, [&] { read_state(document, file); })) {
        document.root.erase("state");
    }
    read_hull_files(document, file);
    return document;
}

}  // namespace hawser::scene
