// SPDX-License-Identifier: Apache-2.0
#include "scene/format.h"
#include "scene/schema.h"

#include <fmt/format.h>

#include <set>

namespace hawser::scene {
namespace {

using Type = Shape::Type;

/// Escape vertical bars, which would end a cell of a table.
std::string cell(std::string text) {
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) {
        text.replace(at, 1, "\\|");
    }
    return text;
}

class Page {
  public:
    void object(const Shape& shape, const std::string& title, const std::string& level) {
        if (!written_types_.insert(shape.id).second) {
            return;
        }
        text_ += fmt::format("\n{} {}\n\n{}\n", level, title, shape.doc);
        table(shape.fields);
        for (const auto& group : shape.alternatives) {
            text_ += "\nAt most one of ";
            for (std::size_t i = 0; i < group.size(); ++i) {
                text_ += fmt::format("{}`{}`", i == 0 ? "" : ", ", group[i]);
            }
            text_ += ".\n";
        }
        for (const Field& field : shape.fields) {
            inner(*field.shape);
        }
    }

    void kinds() {
        text_ +=
            "\n## Interactions\n\nAn interaction names its kind, its bodies and the parameters of "
            "that kind. Every kind also takes `name`, `compliance` and `damping_time`.\n";
        for (const KindInfo& kind : interaction_kinds()) {
            text_ += fmt::format("\n### {}\n\n{}\n\nBodies: {}. Rows: {}. {}{}\n", kind.name,
                                 kind.doc, kind.bodies, kind.rows,
                                 kind.uses_points ? "Takes `at` or `points`. " : "",
                                 kind.uses_frames ? "Takes `axis`, `axes` or `frames`." : "");
            if (!kind.params.empty()) {
                parameters(kind);
            }
        }
    }

    std::string text_ =
        "<!-- Generated from src/scene/format.cpp and the table of kinds; do not edit. -->\n"
        "# Scene reference\n\nEvery key of a scene file, version 1. An explanation with examples "
        "is in [scenes.md](scenes.md). SI units; degrees only in keys that end in `_deg`. Unknown "
        "keys are errors.\n";

  private:
    void table(const std::vector<Field>& fields) {
        text_ += "\n| key | value | unit | default | |\n|---|---|---|---|---|\n";
        for (const Field& f : fields) {
            text_ += fmt::format("| `{}`{} | {} | {} | {} | {} |\n", f.name,
                                 f.required ? " (required)" : "", cell(value(*f.shape)),
                                 f.unit == "1" ? "" : cell(f.unit), cell(f.fallback), cell(f.doc));
        }
    }

    static std::string value(const Shape& shape) {
        if (shape.type == Type::number || shape.type == Type::integer) {
            const bool open = shape.above_min && shape.min == 0.0;
            return fmt::format("{}, {} to {:.10g}", shape.what,
                               open ? "above 0" : fmt::format("{:.10g}", shape.min), shape.max);
        }
        if (shape.type != Type::word) {
            return shape.what;
        }
        std::string words;
        for (const std::string& word : shape.words) {
            words += (words.empty() ? "`" : ", `") + word + "`";
        }
        return words;
    }

    void parameters(const KindInfo& kind) {
        text_ += "\n| parameter | unit | default | range | input | |\n|---|---|---|---|---|---|\n";
        for (const ParamInfo& p : kind.params) {
            const std::string fallback = is_taken_from_pose(kind, p.name) ? "the initial value"
                                         : p.fallback == p.fallback
                                             ? fmt::format("{:.10g}", p.fallback)
                                             : "required";
            text_ += fmt::format("| `{}` | {} | {} | {:.10g} to {:.10g} | {} | {} |\n", p.name,
                                 p.unit, fallback, p.min, p.max, p.input ? "yes" : "", cell(p.doc));
        }
    }

    /// Write the nested objects of an object as sections after it, in the order of their keys.
    void inner(const Shape& shape) {
        if (shape.type == Type::object) {
            std::string title = shape.what.substr(shape.what.find(' ') + 1);
            if (shape.what.find(' ') == std::string::npos) {
                title = shape.what;
            }
            title.front() = static_cast<char>(std::toupper(title.front()));
            object(shape, title, "##");
        }
        if (shape.type == Type::switched && shape.id != "interaction") {
            std::string title = shape.id;
            title.front() = static_cast<char>(std::toupper(title.front()));
            title += ": ";
            for (const auto& [kind, option] : shape.cases) {
                std::string heading = title;
                heading += kind;
                object(*option, heading, "##");
            }
        }
        if (shape.item) {
            inner(*shape.item);
        }
        for (const ShapePtr& option : shape.options) {
            inner(*option);
        }
    }

    std::set<std::string> written_types_;
};

}  // namespace

std::string reference_text() {
    Page page;
    page.object(*format().scene, "A scene file", "##");
    page.kinds();
    page.object(*format().part, "An included file", "##");
    page.object(*format().state, "A state file", "##");
    return page.text_ + "\nNext page: [Hydrodynamic coefficient files](hydro_files.md)\n";
}

}  // namespace hawser::scene
