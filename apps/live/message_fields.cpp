// SPDX-License-Identifier: Apache-2.0
#include "live/message_fields.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>
#include <vector>

namespace hawser::live {

namespace {
constexpr double kMaxCoordinate = 1e7;  // [m], as in World::set_pose()
}  // namespace

std::string_view shortened(std::string_view text, std::size_t most) {
    if (text.size() <= most) return text;
    // Bytes 10xxxxxx continue a character: cut before its first byte.
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0u) == 0x80u) --most;
    return text.substr(0, most);
}

std::string json_string(std::string_view text) {
    return Json(std::string(text)).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kMaxQuotedBytes = 60;
    std::string out = "\"" + std::string(shortened(text, kMaxQuotedBytes));
    return out + (text.size() > kMaxQuotedBytes ? "…\"" : "\"");
}

double number(const Json& from, const char* key, double least, double most) {
    const auto at = from.find(key);
    if (at == from.end()) throw Refused(std::string(key) + " is missing");
    if (!at->is_number()) throw Refused(std::string(key) + " is to be a number");
    const double value = at->get<double>();
    if (!(value >= least && value <= most))
        throw Refused(std::string(key) + " is to be from " + Json(least).dump() + " to " +
                      Json(most).dump());
    return value;
}

double number_or(const Json& from, const char* key, double least, double most, double otherwise) {
    return from.contains(key) ? number(from, key, least, most) : otherwise;
}

double read_integer(const Json& from, const char* key, double least, double most) {
    const double value = number(from, key, least, most);
    if (value != std::floor(value)) throw Refused(std::string(key) + " is to be a whole number");
    return value;
}

bool read_switch(const Json& from, const char* key) {
    const auto at = from.find(key);
    if (at == from.end()) throw Refused(std::string(key) + " is missing");
    if (!at->is_boolean()) throw Refused(std::string(key) + " is to be true or false");
    return at->get<bool>();
}

std::array<double, 3> vector(const Json& from, const char* key) {
    const auto at = from.find(key);
    if (at == from.end() || !at->is_array() || at->size() != 3)
        throw Refused(std::string(key) + " is to be three numbers");
    std::array<double, 3> out{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Json& entry = (*at)[k];
        if (!entry.is_number()) throw Refused(std::string(key) + " is to be three numbers");
        out[k] = entry.get<double>();
        if (!(std::abs(out[k]) <= kMaxCoordinate))
            throw Refused(std::string(key) + " is farther away than 10,000 km");
    }
    return out;
}

Json parse_message(std::string_view text) {
    std::vector<std::set<std::string>> open;  // keys of the enclosing objects
    std::string twice;
    Json out = Json::parse(
        text,
        [&](int, Json::parse_event_t event, Json& value) {
            if (event == Json::parse_event_t::object_start) open.emplace_back();
            if (event == Json::parse_event_t::object_end) open.pop_back();
            if (event == Json::parse_event_t::key) {
                const auto& key = value.get_ref<const std::string&>();
                if (!open.back().insert(key).second && twice.empty()) twice = key;
            }
            return true;
        },
        false);
    if (!out.is_discarded() && !twice.empty())
        throw Refused("the key " + in_quotes(twice) + " is given twice");
    return out;
}

}  // namespace hawser::live
