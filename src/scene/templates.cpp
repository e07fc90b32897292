// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

namespace hawser::scene {
namespace {

const Json& parameter(const std::string& name, const Json& parameters,
                      const SourceLocation& location) {
    const auto entry = parameters.find(name);
    if (entry != parameters.end()) {
        return *entry;
    }
    std::vector<std::string> known;
    for (const auto& [key, value] : parameters.items()) {
        known.push_back(key);
    }
    throw_error(location,
                "the template has no parameter " + in_quotes(name) + suggestion(name, known));
}

Json substitute_text(const std::string& text, const Json& parameters,
                     const SourceLocation& location) {
    std::string result;
    std::size_t done = 0;
    while (true) {
        const auto open = text.find("${", done);
        if (open == std::string::npos) {
            return result + text.substr(done);
        }
        const auto close = text.find('}', open);
        if (close == std::string::npos) {
            throw_error(location, "\"${\" without \"}\" in " + in_quotes(text));
        }
        const Json& value =
            parameter(text.substr(open + 2, close - open - 2), parameters, location);
        if (open == 0 && close + 1 == text.size()) {
            return value;  // Alone: keeps its type.
        }
        result += text.substr(done, open - done);
        result += value.is_string() ? value.get<std::string>() : value.dump();
        done = close + 1;
    }
}

}  // namespace

Json substitute(const Json& value, const Json& parameters, const SourceLocation& location) {
    if (value.is_string()) {
        return is_placeholder(value)
                   ? substitute_text(value.get_ref<const std::string&>(), parameters, location)
                   : value;
    }
    if (value.is_object()) {
        Json result = Json::object();
        for (const auto& [key, entry] : value.items()) {
            result[key] = substitute(entry, parameters, location / key);
        }
        return result;
    }
    if (value.is_array()) {
        Json result = Json::array();
        for (std::size_t i = 0; i < value.size(); ++i) {
            result.push_back(substitute(value[i], parameters, location / i));
        }
        return result;
    }
    return value;
}

}  // namespace hawser::scene
