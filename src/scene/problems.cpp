// SPDX-License-Identifier: Apache-2.0
#include "scene/shape.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace hawser::scene {
namespace {

using Type = Shape::Type;

constexpr std::size_t kMaxText = 4096;

/// Collects the mistakes in a value, up to a given number.
class Finder {
  public:
    explicit Finder(std::size_t most) : most_(most) {}

    void find(const Json& value, const Shape& shape, bool placeholders);
    std::vector<Problem> problems;

  private:
    [[nodiscard]] bool is_full() const { return problems.size() >= most_; }
    void add_problem(std::string message) {
        if (!is_full()) {
            problems.push_back({path_, std::move(message)});
        }
    }
    void expected(const Shape& shape, const Json& value) {
        add_problem("expected " + shape.what + ", found " + describe(value));
    }
    /// Run `work` with the path of the present value extended by one token.
    template <class Work>
    void at(const std::string& token, const Work& work) {
        const std::size_t length = path_.size();
        path_ += token;
        work();
        path_.resize(length);
    }
    void number(const Json& value, const Shape& shape);
    void text(const Json& value, const Shape& shape);
    void list(const Json& value, const Shape& shape, bool placeholders);
    void alternatives(const Json& value, const Shape& shape);
    void object(const Json& value, const Shape& shape, bool placeholders);
    void map(const Json& value, const Shape& shape, bool placeholders);
    void choice(const Json& value, const Shape& shape, bool placeholders);
    void check_switched(const Json& value, const Shape& shape, bool placeholders);

    std::size_t most_;
    std::string path_;
};

std::string range_text(const Shape& shape) {
    const bool low = std::isfinite(shape.min);
    const bool high = std::isfinite(shape.max);
    const char* than = shape.above_min ? "greater than" : "at least";
    if (low && high) {
        return fmt::format("{} {:.10g} and at most {:.10g}", than, shape.min, shape.max);
    }
    return low ? fmt::format("{} {:.10g}", than, shape.min)
               : fmt::format("at most {:.10g}", shape.max);
}

void Finder::number(const Json& value, const Shape& shape) {
    const bool fits_type =
        shape.type == Type::integer ? value.is_number_integer() : value.is_number();
    if (!fits_type) {
        return expected(shape, value);
    }
    const double number = value.get<double>();
    if (!std::isfinite(number)) {
        return add_problem("expected a finite number, found " + describe(value));
    }
    const bool low = shape.above_min ? number <= shape.min : number < shape.min;
    if (low || number > shape.max) {
        add_problem("must be " + range_text(shape) + ", found " + describe(value));
    }
}

void Finder::text(const Json& value, const Shape& shape) {
    if (!value.is_string()) {
        return expected(shape, value);
    }
    const auto& text = value.get_ref<const std::string&>();
    if (shape.type == Type::name && !is_valid_name(text)) {
        return add_problem("expected " + shape.what +
                           " (letters, digits and _ . + -, at most 100, starting with a letter, a "
                           "digit or _), found " +
                           describe(value));
    }
    if (text.empty() || text.size() > kMaxText) {
        return add_problem("expected " + shape.what + " of 1 to 4096 bytes, found " +
                           std::to_string(text.size()) + " bytes");
    }
    if (shape.type == Type::word &&
        std::find(shape.words.begin(), shape.words.end(), text) == shape.words.end()) {
        add_problem("expected " + shape.what + ", found " + describe(value) +
                    suggestion(text, shape.words));
    }
}

void Finder::list(const Json& value, const Shape& shape, bool placeholders) {
    if (!value.is_array()) {
        return expected(shape, value);
    }
    if (value.size() < shape.min_items || value.size() > shape.max_items) {
        return add_problem("expected " + shape.what + ", found " + std::to_string(value.size()) +
                           (value.size() == 1 ? " entry" : " entries"));
    }
    for (std::size_t i = 0; i < value.size() && !is_full(); ++i) {
        at(fmt::format("/{}", i), [&] { find(value[i], *shape.item, placeholders); });
    }
}

void Finder::alternatives(const Json& value, const Shape& shape) {
    for (const auto& group : shape.alternatives) {
        const std::string* first = nullptr;
        for (const std::string& name : group) {
            if (!value.contains(name)) {
                continue;
            }
            if (first != nullptr) {
                add_problem("give either " + in_quotes(*first) + " or " + in_quotes(name) +
                            ", not both");
                break;
            }
            first = &name;
        }
    }
}

void Finder::object(const Json& value, const Shape& shape, bool placeholders) {
    if (!value.is_object()) {
        return expected(shape, value);
    }
    for (const auto& [key, entry] : value.items()) {
        const auto field = std::find_if(shape.fields.begin(), shape.fields.end(),
                                        [&key = key](const Field& f) { return f.name == key; });
        at(pointer_token(key), [&, &key = key, &entry = entry] {
            if (field != shape.fields.end()) {
                return find(entry, *field->shape, placeholders);
            }
            std::vector<std::string> known;
            for (const Field& f : shape.fields) {
                known.push_back(f.name);
            }
            add_problem(shape.what + " has no key " + in_quotes(key) + suggestion(key, known));
        });
        if (is_full()) {
            return;
        }
    }
    for (const Field& field : shape.fields) {
        if (field.required && !value.contains(field.name)) {
            add_problem(shape.what + " needs the key " + in_quotes(field.name) + " (" +
                        field.shape->what + ")");
        }
    }
    alternatives(value, shape);
}

void Finder::map(const Json& value, const Shape& shape, bool placeholders) {
    if (!value.is_object()) {
        return expected(shape, value);
    }
    for (const auto& [key, entry] : value.items()) {
        at(pointer_token(key), [&, &key = key, &entry = entry] {
            if (key.empty() || key.size() > kMaxText) {
                add_problem("a key must have 1 to 4096 bytes");
            } else {
                find(entry, *shape.item, placeholders);
            }
        });
        if (is_full()) {
            return;
        }
    }
}

/// Report the mistakes in the option that the author most likely meant: the option whose first
/// mistake is deepest in the value.
void Finder::choice(const Json& value, const Shape& shape, bool placeholders) {
    const Shape* best = nullptr;
    std::ptrdiff_t best_depth = -1;
    for (const ShapePtr& option : shape.options) {
        if (!is_of_type(value, *option)) {
            continue;
        }
        const auto problem = find_problem(value, *option, placeholders);
        if (!problem) {
            return;
        }
        auto depth = 2 * std::count(problem->path.begin(), problem->path.end(), '/');
        if (value.is_array() && !value.empty() && option->item &&
            is_of_type(value[0], *option->item)) {
            ++depth;  // The list has entries of the right type.
        }
        if (depth > best_depth) {
            best_depth = depth;
            best = option.get();
        }
    }
    if (best == nullptr) {
        expected(shape, value);
    } else {
        find(value, *best, placeholders);
    }
}

void Finder::check_switched(const Json& value, const Shape& shape, bool placeholders) {
    if (!value.is_object()) {
        return expected(shape, value);
    }
    const auto selector = value.find(shape.key);
    if (selector == value.end()) {
        return add_problem(shape.what + " needs the key " + in_quotes(shape.key));
    }
    std::vector<std::string> known;
    for (const auto& [name, fields] : shape.cases) {
        if (*selector == name) {
            return object(value, *fields, placeholders);
        }
        known.push_back(name);
    }
    const std::string hint =
        selector->is_string() ? suggestion(selector->get_ref<const std::string&>(), known) : "";
    at(pointer_token(shape.key), [&] {
        add_problem("there is no " + shape.key + " " + describe(*selector) + " of " + shape.what +
                    hint);
    });
}

void Finder::find(const Json& value, const Shape& shape, bool placeholders) {
    placeholders = placeholders || shape.holds_placeholders;
    const bool container =
        shape.type == Type::object || shape.type == Type::map || shape.type == Type::switched;
    if (placeholders && !shape.literal && !container && is_placeholder(value)) {
        return;
    }
    switch (shape.type) {
        case Type::any:
            return;
        case Type::number:
        case Type::integer:
            return number(value, shape);
        case Type::boolean:
            if (!value.is_boolean()) {
                expected(shape, value);
            }
            return;
        case Type::text:
        case Type::name:
        case Type::word:
            return text(value, shape);
        case Type::list:
            return list(value, shape, placeholders);
        case Type::object:
            return object(value, shape, placeholders);
        case Type::map:
            return map(value, shape, placeholders);
        case Type::choice:
            return choice(value, shape, placeholders);
        case Type::switched:
            return check_switched(value, shape, placeholders);
    }
}

}  // namespace

std::vector<Problem> find_problems(const Json& value, const Shape& shape, std::size_t most) {
    Finder finder(most);
    finder.find(value, shape, false);
    return std::move(finder.problems);
}

std::optional<Problem> find_problem(const Json& value, const Shape& shape, bool placeholders) {
    Finder finder(1);
    finder.find(value, shape, placeholders);
    return finder.problems.empty() ? std::nullopt
                                   : std::optional<Problem>(std::move(finder.problems.front()));
}

}  // namespace hawser::scene
