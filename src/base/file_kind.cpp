// SPDX-License-Identifier: Apache-2.0
#include "base/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>
#include <vector>

namespace hawser::base {
namespace {

constexpr std::string_view kBlankCharacters = " \t\r\n";
constexpr std::size_t kLookedAt = 65536;  // Bytes of text that are searched for headings.

struct Signature {
    std::string_view bytes;
    FileKind kind;
};
constexpr std::array<Signature, 13> kSignatures = {{
    {"HAWSERRC", FileKind::recording},
    {"HAWSERST", FileKind::snapshot},
    {"\xff\xfe", FileKind::utf16},
    {"\xfe\xff", FileKind::utf16},
    {"\x1f\x8b", FileKind::compressed},
    {"PK\x03\x04", FileKind::compressed},
    {"\x28\xb5\x2f\xfd", FileKind::compressed},
    {"\xfd"
     "7zXZ",
     FileKind::compressed},
    {"\x89PNG", FileKind::picture},
    {"\xff\xd8\xff", FileKind::picture},
    {"\x89HDF", FileKind::hdf5},
    {"CDF", FileKind::netcdf},
    {"glTF", FileKind::gltf},
}};

struct Words {
    FileKind kind;
    const char* is;      ///< Text "this is …".
    const char* remedy;  ///< Text of the remedy; FILE stands for the file name.
};
constexpr const char* kAsBodies =
    "Hawser does not read it; write its links as \"bodies\" and its joints as \"interactions\" of "
    "a scene (docs/scenes.md)";
constexpr std::array<Words, 26> kWordsOfKinds = {{
    {FileKind::empty, "an empty file", "write a scene (docs/scenes.md) or give another file"},
    {FileKind::scene, "a scene", "`hawser run FILE` runs it"},
    {FileKind::exercise, "an exercise",
     "`hawser exercise FILE` runs it, `hawser view FILE` shows it"},
    {FileKind::recording, "a recording",
     "`hawser view FILE` plays it, `hawser replay FILE` repeats it, `hawser plot FILE` draws it"},
    {FileKind::snapshot, "a saved state", "`hawser run SCENE --restore FILE` goes on from it"},
    {FileKind::pose_state, "a settled state",
     "name it in its scene: \"state\": {\"file\": \"FILE\"}"},
    {FileKind::operations, "a list of operations", "`hawser run SCENE --control FILE` does them"},
    {FileKind::control, "a control file (CSV)", "`hawser run SCENE --control FILE` applies it"},
    {FileKind::summary, "the summary of a run", "give the scene that was run"},
    {FileKind::moordyn, "an input file of MoorDyn",
     "Hawser does not read it; write its line types as \"line_types\" and its lines as \"cables\" "
     "of a scene (docs/scenes.md)"},
    {FileKind::orcaflex, "a model of OrcaFlex",
     "Hawser does not read it; write its lines as \"cables\" of a scene (docs/scenes.md)"},
    {FileKind::urdf, "a URDF model", kAsBodies},
    {FileKind::xacro, "a xacro file (URDF)", kAsBodies},
    {FileKind::mjcf, "a model of MuJoCo (MJCF)", kAsBodies},
    {FileKind::sdf, "a model of Gazebo (SDF)", kAsBodies},
    {FileKind::xml, "XML", "a scene is JSON (docs/scenes.md)"},
    {FileKind::gltf, "a glTF model",
     "Hawser writes it by `hawser export` and does not read it; a scene is JSON (docs/scenes.md)"},
    {FileKind::yaml, "YAML", "convert it to JSON, with the keys of docs/scenes.md"},
    {FileKind::toml, "TOML or INI", "convert it to JSON, with the keys of docs/scenes.md"},
    {FileKind::json_comments, "JSON with comments",
     "remove them: JSON has none; \"description\" takes notes"},
    {FileKind::json_comma, "JSON with a comma behind a last entry", "remove the comma"},
    {FileKind::utf16, "text in UTF-16", "save it as UTF-8"},
    {FileKind::compressed, "a compressed file", "unpack it first"},
    {FileKind::picture, "a picture", "give another file"},
    {FileKind::hdf5, "HDF5", "of hydrodynamic coefficients a scene names it under \"sea\""},
    {FileKind::netcdf, "netCDF", "of hydrodynamic coefficients a scene names it under \"sea\""},
}};

bool is_name_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Scans JSON text, each string as a whole. Stops at the first comment or superfluous comma.
struct JsonScan {
    std::optional<std::size_t> comment, after_comma;
    /// Keys at the top level, with the first character of their value.
    std::vector<std::pair<std::string, char>> keys;
    bool in_object = false, in_array = false;

    explicit JsonScan(std::string_view text) {
        std::size_t depth = 0, last_comma = std::string_view::npos;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const char c = text[i];
            if (kBlankCharacters.find(c) != std::string_view::npos) continue;
            const bool slash = c == '/' && i + 1 < text.size();
            if ((slash && (text[i + 1] == '/' || text[i + 1] == '*')) || c == '#') {
                comment = i;
                return;
            }
            if (c == '"') {
                const std::size_t end = string_end(text, i);
                if (depth == 1 && in_object) add_key(text, i, end);
                i = end;
            } else if (c == '{' || c == '[') {
                if (depth++ == 0) (c == '{' ? in_object : in_array) = true;
            } else if (c == '}' || c == ']') {
                if (last_comma != std::string_view::npos) {
                    after_comma = last_comma;
                    return;
                }
                if (depth > 0) --depth;
            }
            last_comma = c == ',' ? i : std::string_view::npos;
        }
    }
    [[nodiscard]] bool has(std::string_view key, char value = '\0') const {
        return std::any_of(keys.begin(), keys.end(), [&](const auto& k) {
            return k.first == key && (value == '\0' || k.second == value);
        });
    }

  private:
    static std::size_t string_end(std::string_view text, std::size_t i) {
        for (++i; i < text.size() && text[i] != '"'; ++i)
            if (text[i] == '\\') ++i;
        return i;
    }
    void add_key(std::string_view text, std::size_t begin, std::size_t end) {
        const std::size_t colon = text.find_first_not_of(kBlankCharacters, end + 1);
        if (colon == std::string_view::npos || text[colon] != ':') return;
        const std::size_t value = text.find_first_not_of(kBlankCharacters, colon + 1);
        keys.emplace_back(text.substr(begin + 1, end - begin - 1),
                          value == std::string_view::npos ? '\0' : text[value]);
    }
};

FileKind kind_of_json(std::string_view text) {
    const JsonScan scan(text);
    if (scan.comment) return FileKind::json_comments;
    if (scan.after_comma) return FileKind::json_comma;
    if (scan.in_array)
        return text.find("\"at\"") != std::string_view::npos ? FileKind::operations
                                                             : FileKind::unknown;
    if (scan.has("exercise")) return FileKind::exercise;
    if (scan.has("state_hash") && scan.has("scene_hash")) return FileKind::summary;
    if (scan.has("asset", '{') && (scan.has("meshes") || scan.has("nodes"))) return FileKind::gltf;
    const bool whole = scan.has("settings") || scan.has("interactions") || scan.has("cables");
    if (scan.has("bodies", '{') && !whole) return FileKind::pose_state;
    if (scan.has("bodies", '[') || scan.has("cables", '[') || scan.has("templates", '{'))
        return FileKind::scene;
    return FileKind::unknown;
}

/// Return the kind of XML text from the name of the first element after declarations and comments.
FileKind kind_of_xml(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        at = text.find('<', at);
        if (at == std::string_view::npos) return FileKind::xml;
        if (text.substr(at).starts_with("<!--")) {
            at = text.find("-->", at);
        } else if (at + 1 < text.size() && (text[at + 1] == '?' || text[at + 1] == '!')) {
            ++at;
        } else {
            break;
        }
    }
    const std::size_t end = text.find_first_of(" \t\r\n/>", at);
    const std::string_view name = at < text.size() ? text.substr(at + 1, end - at - 1) : "";
    if (name == "robot")
        return text.find("xmlns:xacro") != std::string_view::npos ? FileKind::xacro
                                                                  : FileKind::urdf;
    if (name == "mujoco" || name == "mujocoinclude") return FileKind::mjcf;
    if (name == "sdf" || name == "gazebo") return FileKind::sdf;
    return FileKind::xml;
}

/// True if the text has a heading such as "--- LINE TYPES ---", or starts like a MoorDyn file.
bool is_moordyn(std::string_view text) {
    if (text.substr(0, 400).find("MoorDyn") != std::string_view::npos && text.starts_with("--"))
        return true;
    for (const std::string_view heading :
         {"LINE TYPES", "LINE DICTIONARY", "ROD TYPES", "LINE PROPERTIES", "POINT PROPERTIES",
          "CONNECTION PROPERTIES"}) {
        const std::size_t at = text.find(heading);
        if (at == std::string_view::npos) continue;
        const std::size_t line = text.rfind('\n', at) + 1;  // npos + 1 is 0
        if (text.substr(line, at - line).find("---") != std::string_view::npos) return true;
    }
    return false;
}

/// Return the kind of text from its first line with content.
FileKind kind_of_lines(std::string_view text) {
    if (text.starts_with("%YAML") || text.starts_with("---"))
        return text.substr(0, 400).find("OrcaFlex") != std::string_view::npos ? FileKind::orcaflex
                                                                              : FileKind::yaml;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const std::size_t last = line.find_last_not_of(kBlankCharacters);
        if (last == std::string_view::npos || line[0] == '#' || line[0] == ';') continue;
        line = line.substr(0, last + 1);
        if (line == "time" || line.starts_with("time,")) return FileKind::control;
        if (line.front() == '[' && line.back() == ']' && line.size() > 2 && is_name_start(line[1]))
            return FileKind::toml;
        const std::size_t mark = line.find_first_of(":=");
        if (mark == std::string_view::npos || !is_name_start(line[0])) return FileKind::unknown;
        const bool name =
            std::all_of(line.begin(), line.begin() + static_cast<long>(mark), [](char c) {
                return is_name_start(c) || c == ' ' || c == '-' || c == '.' ||
                       std::isdigit(static_cast<unsigned char>(c)) != 0;
            });
        if (!name) return FileKind::unknown;
        if (line[mark] == '=') return FileKind::toml;
        return mark + 1 == line.size() || line[mark + 1] == ' ' ? FileKind::yaml
                                                                : FileKind::unknown;
    }
    return FileKind::unknown;
}

}  // namespace

FileKind file_kind(std::string_view content) {
    for (const Signature& s : kSignatures)
        if (content.starts_with(s.bytes)) return s.kind;
    if (content.find('\0') != std::string_view::npos) return FileKind::binary;
    if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
    const std::size_t begin = content.find_first_not_of(kBlankCharacters);
    if (begin == std::string_view::npos) return FileKind::empty;
    const std::string_view text = content.substr(begin);
    const std::string_view head = text.substr(0, kLookedAt);
    if (text[0] == '<') return kind_of_xml(head);
    if (is_moordyn(head)) return FileKind::moordyn;
    const FileKind by_lines = kind_of_lines(head);
    if (by_lines != FileKind::unknown) return by_lines;
    return kind_of_json(text);
}

std::string file_kind_error(std::string_view content, std::string_view expected,
                            const std::string& file) {
    const FileKind kind = file_kind(content);
    const auto words = std::find_if(kWordsOfKinds.begin(), kWordsOfKinds.end(),
                                    [&](const Words& w) { return w.kind == kind; });
    if (kind == FileKind::binary)
        return "this is a binary file (a NUL byte at offset " + std::to_string(content.find('\0')) +
               "), not " + std::string(expected);
    if (words == kWordsOfKinds.end() || expected == words->is) return "";
    std::string remedy = words->remedy;
    if (const std::size_t at = remedy.find("FILE"); at != std::string::npos)
        for (std::size_t i = at; i != std::string::npos; i = remedy.find("FILE", i + file.size()))
            remedy.replace(i, 4, file);
    std::string where;
    if (kind == FileKind::json_comments || kind == FileKind::json_comma) {
        const JsonScan scan(content);
        const std::size_t at = scan.comment ? *scan.comment : *scan.after_comma;
        const auto front = content.substr(0, at);
        where = " (line " + std::to_string(1 + std::count(front.begin(), front.end(), '\n')) +
                ", column " + std::to_string(at - (front.rfind('\n') + 1) + 1) + ")";
    }
    return "this is " + std::string(words->is) + where + ", not " + std::string(expected) + "; " +
           remedy;
}

std::string file_kind_error_or(std::string_view content, std::string_view expected,
                               const std::string& file, const char* fallback) {
    const std::string other = file_kind_error(content, expected, file);
    return other.empty() ? fallback : other;
}

}  // namespace hawser::base
