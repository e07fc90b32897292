// SPDX-License-Identifier: Apache-2.0
#include "scene/timeline.h"

#include "scene/description.h"
#include "scene/winches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace hawser::scene {
namespace {

constexpr const char* kGearNames[] = {"splice", "shackle", "swivel", "triplate", "pelican_hook"};

int end_of(const Json& json, const char* key, const char* fallback) {
    return text_or(json, key, fallback) == "last" ? 1 : 0;
}

JoinDef read_gear(const Json& json) {
    JoinDef def;
    def.name = text_or(json, "name", "");
    const std::string word = text_or(json, "gear", "splice");
    def.gear = static_cast<Gear>(std::find(std::begin(kGearNames), std::end(kGearNames), word) -
                                 std::begin(kGearNames));
    def.mass = number_or(json, "mass", def.mass);
    def.length = number_or(json, "length", def.length);
    def.EA = number_or(json, "EA", def.EA);
    def.breaking_load = number_or(json, "breaking_load", def.breaking_load);
    def.radius = number_or(json, "radius", def.radius);
    def.reach = number_or(json, "reach", def.reach);
    return def;
}

/// Reads operations in their order. Tracks the wires and hooks that exist at each operation.
class Reader {
  public:
    Reader(const World& world, const InputWords& words, std::span<const SignalInput> levers)
        : world_(world), words_(words), signal_inputs_(levers) {
        for (const WireId id : world.wires().ids()) {
            const auto elements = world.wires().elements(id);
            Length& one = wires_[world.wires().name(id)];
            one.stored[0] = stored_at(elements.front());
            if (elements.size() > 1) one.stored[1] = stored_at(elements.back());
            one.most = world.wires().length(id) + one.stored[0] + one.stored[1];
        }
    }

    Operation read(const Json& json, const SourceLocation& location) {
        Operation out;
        out.at = json["at"].get<double>();
        out.description = text_or(json, "description", "");
        if (json.contains("set"))
            read_set(out, json["set"], location / "set");
        else if (json.contains("cut"))
            read_cut(out, json, location);
        else if (json.contains("detach"))
            read_end(out, OperationKind::detach, json["detach"], location / "detach");
        else if (json.contains("attach"))
            read_attach(out, json["attach"], location / "attach");
        else if (json.contains("join"))
            read_join(out, json["join"], location / "join");
        else if (json.contains("release"))
            read_release(out, json, location);
        else
            throw_error(location,
                        "an operation needs one of the keys \"set\", \"cut\", \"detach\", "
                        "\"attach\", \"join\" and \"release\"");
        return out;
    }

  private:
    [[nodiscard]] std::string wire(const Json& json, const char* key,
                                   const SourceLocation& location) const {
        const std::string name = json[key].get<std::string>();
        if (wires_.contains(name)) return name;
        std::vector<std::string> known;
        for (const auto& [each, length] : wires_) known.push_back(each);
        throw_error(location / key,
                    "there is no wire " + in_quotes(name) + " then" + suggestion(name, known));
    }

    /// Return a number. Words are valid for a winch's mode, and for the load of a crane, given by
    /// the body's name.
    [[nodiscard]] double value_of(const std::string& input, const Json& json,
                                  const SourceLocation& location) const {
        if (json.is_number()) return json.get<double>();
        const std::string word = json.get<std::string>();
        if (const auto own = words_.find(input); own != words_.end()) {
            const std::vector<std::string>& known = own->second;
            const auto found = std::find(known.begin(), known.end(), word);
            if (found != known.end()) return static_cast<double>(found - known.begin()) + 1.0;
            throw_error(location, "it has no load " + in_quotes(word) + suggestion(word, known));
        }
        if (!input.ends_with(".mode")) throw_error(location, "expected a number, found a text");
        const auto modes = winch_modes();
        const auto found = std::find(modes.begin(), modes.end(), word);
        if (found != modes.end()) return static_cast<double>(found - modes.begin());
        const std::vector<std::string> known{modes.begin(), modes.end()};
        throw_error(location, "there is no mode " + in_quotes(word) + suggestion(word, known));
    }

    void read_set(Operation& out, const Json& json, const SourceLocation& location) const {
        out.kind = OperationKind::set;
        std::vector<std::string> known;
        for (const InputId id : world_.inputs()) known.push_back(world_.input_def(id).name);
        for (const SystemSignal& s : world_.system_signals())
            if (s.input) known.push_back(s.system + "." + s.name);
        for (const SignalInput& lever : signal_inputs_) known.push_back(lever.name);
        for (const auto& [name, value] : json.items()) {
            if (std::find(known.begin(), known.end(), name) == known.end())
                throw_error(location / name,
                            "there is no input " + in_quotes(name) + suggestion(name, known));
            out.set.push_back(resolve_signal(name, value, location / name));
        }
    }

    /// Return the name and value with which an operation sets an input. For an input that sets a
    /// signal, return the signal and its value.
    [[nodiscard]] std::pair<std::string, double> resolve_signal(
        const std::string& name, const Json& json, const SourceLocation& location) const {
        const auto lever = std::find_if(signal_inputs_.begin(), signal_inputs_.end(),
                                        [&](const SignalInput& l) { return l.name == name; });
        if (lever == signal_inputs_.end()) {
            const double value = value_of(name, json, location);
            for (const SystemSignal& s : world_.system_signals())
                if (s.system + "." + s.name == name) check_range(value, s.min, s.max, location);
            return {name, value};
        }
        const double value = value_of(lever->signal, json, location);
        check_range(value, lever->min, lever->max, location);
        return {lever->signal, lever->factor * value};
    }

    /// Reject a value that a signal would clamp, because it is probably a mistake.
    static void check_range(double value, double min, double max, const SourceLocation& location) {
        if (!(value >= min && value <= max))
            throw_error(location,
                        fmt::format("{:.6g} is not within the input's range, {:.6g} to {:.6g}",
                                    value, min, max));
    }

    void read_cut(Operation& out, const Json& json, const SourceLocation& location) {
        out.kind = OperationKind::cut;
        out.wire = wire(json, "cut", location);
        if (!json.contains("s"))
            throw_error(location, "a cut needs the key \"s\", where along the wire");
        out.s = json["s"].get<double>();
        Length& length = wires_[out.wire];
        const double stored = length.stored[0] + length.stored[1];
        if (out.s >= length.most)
            throw_error(
                location / "s",
                fmt::format("the wire {} is {:.6g} m long then{}", in_quotes(out.wire), length.most,
                            stored > 0.0 ? ", with all that its winches have stored" : ""));
        // The first piece keeps the drum at the first end, the second piece the drum at the last
        // end.
        Length rest{.most = length.most - out.s, .stored = {0.0, length.stored[1]}};
        length.most = std::min(length.most, out.s + length.stored[0]);
        length.stored[1] = 0.0;
        wires_[next_piece(out.wire)] = rest;
    }

    /// Return the length that the drum at the end of a wire can still pay out [m]. For a drum
    /// without this account, return a length above any possible one.
    [[nodiscard]] double stored_at(InteractionId element) const {
        const InteractionDef& def = world_.interaction_def(element);
        if (!kind_info(def.kind).is(kWoundUp)) return 0.0;
        const std::string& drum = world_.body_def(def.body[2]).name;
        const std::string winch = drum.substr(0, drum.rfind('/'));
        for (const SystemSignal& s : world_.system_signals())
            if (s.system == winch && s.name == "wire_left") return *s.value;
        return 1e30;
    }

    /// Return the name that WorldWires::cut() will assign to the next piece of a wire: "tow/2",
    /// "tow/3" …
    [[nodiscard]] std::string next_piece(const std::string& of) const {
        std::string base = of;
        const std::size_t slash = of.rfind('/');
        if (slash != std::string::npos && slash + 1 < of.size() &&
            of.find_first_not_of("0123456789", slash + 1) == std::string::npos)
            base.resize(slash);
        int k = 2;
        while (wires_.contains(base + "/" + std::to_string(k))) ++k;
        return base + "/" + std::to_string(k);
    }

    void read_end(Operation& out, OperationKind kind, const Json& json,
                  const SourceLocation& location) const {
        out.kind = kind;
        out.wire = wire(json, "wire", location);
        out.end = end_of(json, "end", "last");
    }

    void read_join_gear(Operation& out, const Json& json, const SourceLocation& location) {
        out.gear = read_gear(json);
        if (out.gear.gear == Gear::triplate && !(out.gear.mass > 0.0))
            throw_error(location, "a triplate needs \"mass\"");
        const std::string& name = out.gear.name;
        if (name.empty()) return;
        if (world_.find_interaction(name).valid() ||
            std::find(named_.begin(), named_.end(), name) != named_.end())
            throw_error(location / "name",
                        "the interaction " + in_quotes(name) + " exists already");
        named_.push_back(name);
        if (out.gear.gear == Gear::pelican_hook) hooks_.push_back(name);
    }

    void read_attach(Operation& out, const Json& json, const SourceLocation& location) {
        read_end(out, OperationKind::attach, json, location);
        out.body = json["body"].get<std::string>();
        out.point = vector_or(json, "point", Vec3::Zero());
        const BodyId id = world_.find_body(out.body);
        if (!id.valid()) {
            std::vector<std::string> known;
            for (const BodyId each : world_.bodies())
                if (!world_.body_def(each).name.empty())
                    known.push_back(world_.body_def(each).name);
            throw_error(location / "body",
                        "there is no body " + in_quotes(out.body) + suggestion(out.body, known));
        }
        const BodyKind kind = world_.body_def(id).kind;
        if (kind == BodyKind::lump || kind == BodyKind::scalar)
            throw_error(location / "body",
                        "the body " + in_quotes(out.body) +
                            " has no orientation: a wire's end is attached to a rigid, "
                            "kinematic or fixed one");
        read_join_gear(out, json, location);
    }

    void read_join(Operation& out, const Json& json, const SourceLocation& location) {
        read_end(out, OperationKind::join, json, location);
        out.other = wire(json, "to", location);
        out.other_end = end_of(json, "to_end", "first");
        read_join_gear(out, json, location);
        if (out.gear.gear != Gear::splice) return;
        if (out.other == out.wire)
            throw_error(location / "to", "a splice would close it to a ring; give \"gear\"");
        Length& joined = wires_[out.wire];
        const Length& other = wires_[out.other];
        joined.most += other.most;
        for (const std::size_t end : {0U, 1U}) joined.stored[end] += other.stored[end];
        wires_.erase(out.other);
    }

    void read_release(Operation& out, const Json& json, const SourceLocation& location) const {
        out.kind = OperationKind::release;
        out.interaction = json["release"].get<std::string>();
        if (std::find(hooks_.begin(), hooks_.end(), out.interaction) == hooks_.end())
            throw_error(location / "release", "there is no pelican hook " +
                                                  in_quotes(out.interaction) + " then" +
                                                  suggestion(out.interaction, hooks_));
    }

    const World& world_;
    const InputWords& words_;
    const std::span<const SignalInput> signal_inputs_;
    struct Length {
        double most = 0.0;              ///< Largest possible length at that time [m].
        double stored[2] = {0.0, 0.0};  ///< Part of it on drums at its ends, now or before [m].
    };
    std::map<std::string, Length> wires_;
    std::vector<std::string> hooks_, named_;
};

}  // namespace

std::span<const char* const> gear_words() noexcept { return kGearNames; }

std::vector<Operation> read_timeline(const World& world, const Document& document,
                                     const InputWords& words, std::span<const SignalInput> levers) {
    const auto list = document.root.find("timeline");
    if (list == document.root.end()) return {};
    const SourceLocation location = document.location / "timeline";
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < list->size(); ++i)
        if (!(*list)[i].is_null()) order.push_back(i);  // Left out: mistakes.h.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return (*list)[a]["at"].get<double>() < (*list)[b]["at"].get<double>();
    });
    Reader reader(world, words, levers);
    std::vector<Operation> out;
    const bool others = !document.operations.file.empty();
    for (const std::size_t i : order) {
        const SourceLocation at = others && i >= document.own_operations
                                      ? document.operations / (i - document.own_operations)
                                      : location / i;
        (void)attempt(document.mistakes, [&] { out.push_back(reader.read((*list)[i], at)); });
    }
    return out;
}

}  // namespace hawser::scene
