// SPDX-License-Identifier: Apache-2.0
#include "live/command.h"

#include "live/message_fields.h"
#include "record/names.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::live {
namespace {

struct CommandWord {
    CommandKind kind;
    const char* name;
    const char* keys;  ///< Keys in addition to type and id, with blanks around each.
};

constexpr CommandWord kCommandWords[] = {
    {CommandKind::set, "set", " input value inputs "},
    {CommandKind::pause, "pause", " "},
    {CommandKind::resume, "resume", " "},
    {CommandKind::step, "step", " count "},
    {CommandKind::rate, "rate", " value "},
    {CommandKind::drag, "drag", " body point wire s target stiffness "},
    {CommandKind::release, "release", " "},
    {CommandKind::part, "part", " wire s "},
    {CommandKind::save, "save", " name "},
    {CommandKind::restore, "restore", " name "},
    {CommandKind::pick, "pick", " body wire s joint "},
    {CommandKind::seek, "seek", " time "},
    {CommandKind::fault, "fault", " name active "},
    {CommandKind::end, "end", " "},
    {CommandKind::note, "note", " text "},
    {CommandKind::report, "report", " people "},
};

constexpr std::uint64_t kMaxId = std::uint64_t{1} << 53U;
constexpr auto kLargestId = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());

void read_name(const Json& value, const char* key, std::size_t most, Command& out) {
    if (!value.is_string()) throw Refused(std::string(key) + " is to be a name");
    const auto& text = value.get_ref<const std::string&>();
    if (text.empty() || text.size() > most || !out.name.assign(text))
        throw Refused(std::string(key) + " is to have 1 to " + std::to_string(most) + " bytes");
    out.by_name = true;
}

void read_value(const Json& value, Command& out) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
        throw Refused("value is to be a finite number");
    out.value = value.get<double>();
}

void read_set(const Json& from, const Command& begun, std::vector<Command>& out) {
    const auto list = from.find("inputs");
    if ((list != from.end()) == from.contains("input"))
        throw Refused("set needs either input and value, or inputs");
    if (list == from.end()) {
        Command one = begun;
        read_name(from["input"], "input", one.name.kMaximum, one);
        if (!from.contains("value")) throw Refused("value is missing");
        read_value(from["value"], one);
        out.push_back(one);
        return;
    }
    if (!list->is_array() || list->empty() || list->size() > kMaxInputs)
        throw Refused("inputs is to be a list of 1 to 64 pairs of a name and a value");
    for (const Json& pair : *list) {
        if (!pair.is_array() || pair.size() != 2)
            throw Refused("inputs is to be a list of pairs of a name and a value");
        Command one = begun;
        read_name(pair[0], "input", one.name.kMaximum, one);
        read_value(pair[1], one);
        one.answer = false;
        out.push_back(one);
    }
    out.back().answer = true;
}

/// Read the body, wire or joint that a message names.
void read_target(const Json& from, bool joints, bool names, Command& out) {
    constexpr double kMaxPlaces = 2147483647.0;
    const int target_count = static_cast<int>(from.contains("body")) +
                             static_cast<int>(from.contains("wire")) +
                             static_cast<int>(from.contains("joint"));
    if (target_count != 1)
        throw Refused(joints ? "one of body, wire and joint is to be given"
                             : "either body or wire is to be given");
    if (from.contains("body")) {
        out.target_id = static_cast<std::int32_t>(read_integer(from, "body", 0.0, kMaxPlaces));
        if (from.contains("s")) throw Refused("s goes with a wire");
        return;
    }
    if (from.contains("joint")) {
        out.by_joint = true;
        out.target_id = static_cast<std::int32_t>(read_integer(from, "joint", 0.0, kMaxPlaces));
        if (from.contains("s")) throw Refused("s goes with a wire");
        return;
    }
    out.by_wire = true;
    if (names && from["wire"].is_string())
        read_name(from["wire"], "wire", out.name.kMaximum, out);
    else
        out.target_id = static_cast<std::int32_t>(read_integer(from, "wire", 0.0, kMaxPlaces));
    out.value = number(from, "s", 0.0, 1.0);
}

void read_drag(const Json& from, Command& out) {
    constexpr double kMaxStiffness = 1e9;  // Largest stiffness [N/m].
    read_target(from, false, false, out);
    if (from.contains("point")) {
        if (out.by_wire) throw Refused("point goes with a body");
        out.point = vector(from, "point");
    }
    out.target = vector(from, "target");
    out.stiffness = number_or(from, "stiffness", 0.0, kMaxStiffness, 0.0);
}

void read_command(const Json& from, Command one, std::vector<Command>& out) {
    constexpr double kMaxSteps = 1000.0, kMinRate = 0.1, kMaxRate = 10.0, kMaxTime = 1e12;
    constexpr std::size_t kMostName = 64;  // of a restore point
    switch (one.kind) {
        case CommandKind::set:
            return read_set(from, one, out);
        case CommandKind::step:
            one.value = from.contains("count") ? read_integer(from, "count", 1.0, kMaxSteps) : 1.0;
            break;
        case CommandKind::rate:
            one.value = number(from, "value", kMinRate, kMaxRate);
            break;
        case CommandKind::drag:
            read_drag(from, one);
            break;
        case CommandKind::part:
            if (!from.contains("wire")) throw Refused("wire is missing");
            read_target(from, false, true, one);
            break;
        case CommandKind::pick:
            read_target(from, true, false, one);
            break;
        case CommandKind::save:
        case CommandKind::restore:
            if (!from.contains("name")) throw Refused("name is missing");
            read_name(from["name"], "name", kMostName, one);
            break;
        case CommandKind::fault:
            if (!from.contains("name")) throw Refused("name is missing");
            read_name(from["name"], "name", one.name.kMaximum, one);
            one.value = read_switch(from, "active") ? 1.0 : 0.0;
            break;
        case CommandKind::note:
            if (!from.contains("text")) throw Refused("text is missing");
            read_name(from["text"], "text", one.name.kMaximum, one);
            break;
        case CommandKind::report:
            if (from.contains("people"))
                read_name(from["people"], "people", one.name.kMaximum, one);
            break;
        case CommandKind::seek:
            one.value = number(from, "time", 0.0, kMaxTime);
            break;
        default:
            break;
    }
    out.push_back(one);
}

void check_keys(const Json& from, const CommandWord& word) {
    const std::string_view keys = word.keys;
    for (const auto& [key, value] : from.items()) {
        if (key == "type" || key == "id") continue;
        if (key.find(' ') == std::string::npos &&
            keys.find(" " + key + " ") != std::string_view::npos)
            continue;
        throw Refused(std::string(word.name) + " has no key " + in_quotes(key));
    }
}

void read_hello(const Json& from, Request& out) {
    out.hello = true;
    for (const auto& [key, value] : from.items())
        if (key != "type" && key != "version" && key != "token" && key != "id")
            throw Refused("hello has no key " + in_quotes(key));
    out.version = number(from, "version", 0.0, 1e9);
    if (!from.contains("token") || !from["token"].is_string()) throw Refused("hello needs a token");
    out.token = from["token"].get<std::string>();
}

const CommandWord& find_command_word(const std::string& type) {
    const auto* const at = std::find_if(std::begin(kCommandWords), std::end(kCommandWords),
                                        [&](const CommandWord& w) { return type == w.name; });
    if (at != std::end(kCommandWords)) return *at;
    std::vector<std::string> names{"hello"};
    for (const CommandWord& word : kCommandWords) names.emplace_back(word.name);
    throw Refused("there is no message of the type " + in_quotes(type) + "; nearest: \"" +
                  record::nearest_name(type, names) + "\"");
}

void read_message(std::string_view text, Request& out) {
    if (text.size() > kMaxMessage) throw Refused("a message has at most 16 kB");
    const Json from = parse_message(text);
    if (from.is_discarded()) throw Refused("this is not JSON");
    if (!from.is_object()) throw Refused("a message is a JSON object");
    if (from.contains("id")) {
        // The answer repeats an id that is too large, if it is a whole number all the same.
        const Json& id = from["id"];
        if (id.is_number_unsigned() && id.get<std::uint64_t>() <= kLargestId)
            out.id = static_cast<std::int64_t>(id.get<std::uint64_t>());
        // As a double, 2^53 + 1 would become 2^53.
        if (id.is_number_unsigned() && id.get<std::uint64_t>() > kMaxId)
            throw Refused("id is to be from 0 to 9007199254740992");
        out.id = static_cast<std::int64_t>(read_integer(from, "id", 0.0, kMaxWhole));
    }
    const auto type = from.find("type");
    if (type == from.end() || !type->is_string()) throw Refused("a message has a type");
    if (*type == "hello") return read_hello(from, out);
    const CommandWord& word = find_command_word(type->get_ref<const std::string&>());
    out.kind = word.kind;
    check_keys(from, word);
    Command begun;
    begun.kind = word.kind;
    begun.id = out.id;
    read_command(from, begun, out.commands);
}

}  // namespace

std::vector<CommandKind> message_kinds() {
    std::vector<CommandKind> out;
    for (const CommandWord& word : kCommandWords) out.push_back(word.kind);
    return out;
}

const char* to_string(CommandKind kind) noexcept {
    for (const CommandWord& word : kCommandWords)
        if (word.kind == kind) return word.name;
    return kind == CommandKind::left ? "left" : "none";
}

bool parse(std::string_view text, Request& out, std::string& reason) {
    out = Request{};
    try {
        read_message(text, out);
        return true;
    } catch (const Refused& refused) {
        reason = refused.what();
    } catch (const Json::exception&) {  // a check of the JSON reader that no check above covers
        reason = "the message cannot be read";
    }
    out.commands.clear();
    return false;
}

}  // namespace hawser::live
