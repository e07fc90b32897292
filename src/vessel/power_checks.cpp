// SPDX-License-Identifier: Apache-2.0
/// Checks of a power bus (hawser/vessel_power.h).
#include "base/number.h"
#include "vessel/power.h"

#include <algorithm>
#include <string>
#include <vector>

namespace hawser::vessel {
namespace {

constexpr double kMaxPower = 1e12;

class PowerFields {
  public:
    explicit PowerFields(const VesselDef& def) : def_(def) {}
    [[noreturn]] void fail(const std::string& field, const std::string& why) const {
        throw DefError("vessel '" + def_.name + "': power/" + field + ": " + why);
    }
    void power(const std::string& field, double value, bool zero) const {
        if (!(value >= 0.0 && value <= kMaxPower) || (!zero && value == 0.0))
            fail(field, number(value) + "; give a power above 0 and at most 1e12 W");
    }
    /// Check that no other part of the vessel has this name.
    void claim_name(const std::string& field, const std::string& name) {
        if (name.empty()) fail(field, "give a name");
        if (name.find('.') != std::string::npos) fail(field, "a name has no dot");
        if (std::find(names_in_use.begin(), names_in_use.end(), name) != names_in_use.end())
            fail(field, "the name '" + name + "' is taken");
        names_in_use.push_back(name);
    }
    std::vector<std::string> names_in_use;

  private:
    const VesselDef& def_;
};

std::string path_of(const char* list, std::size_t i, const char* field) {
    return std::string(list) + "/" + std::to_string(i) + "/" + field;
}

const PropulsorDef* propulsor_of(const VesselDef& def, const std::string& name) {
    for (const PropulsorDef& p : def.propulsors)
        if (p.name == name) return &p;
    return nullptr;
}

void check_consumer(PowerFields& f, const VesselDef& def, std::size_t i) {
    const ConsumerDef& c = def.power.consumers[i];
    const auto field = [&](const char* name) { return path_of("consumers", i, name); };
    const auto& boards = def.power.boards;
    if (std::none_of(boards.begin(), boards.end(),
                     [&](const SwitchboardDef& b) { return b.name == c.board; })) {
        std::string known;
        for (const SwitchboardDef& b : boards)
            known.append(known.empty() ? "" : ", ").append(b.name);
        f.fail(field("board"), "there is no switchboard '" + c.board + "'; give one of " + known);
    }
    if (!(c.efficiency > 0.0 && c.efficiency <= 1.0))
        f.fail(field("efficiency"), number(c.efficiency) + "; give a number above 0 and at most 1");
    if (c.priority < 1 || c.priority > 1000) f.fail(field("priority"), "give 1 to 1000");
    const PropulsorDef* p = propulsor_of(def, c.name);
    for (std::size_t k = 0; k < i; ++k)
        if (def.power.consumers[k].name == c.name)
            f.fail(field("name"), "'" + c.name + "' is a consumer already");
    if (p == nullptr) {
        f.claim_name(field("name"), c.name);
        f.power(field("power"), c.power, true);
        if (!c.signal.empty() && c.signal.find('.') == std::string::npos)
            f.fail(field("signal"), "give SYSTEM.SIGNAL");
        return;
    }
    if (!c.signal.empty()) f.fail(field("signal"), "a propulsor has its own demand");
    const bool ideal = !(p->propeller.diameter > 0.0);
    if (ideal) f.power(field("power"), c.power, false);
    if (!ideal && c.power != 0.0)
        f.fail(field("power"), "a propeller takes the power of its shaft; leave it out");
}

}  // namespace

void check_power(const VesselDef& def) {
    const PowerDef& power = def.power;
    PowerFields f(def);
    if (power.boards.empty()) {
        if (!power.consumers.empty()) f.fail("boards", "consumers need a switchboard");
        return;
    }
    if (!(power.share > 0.0 && power.share <= 1.0))
        f.fail("share", number(power.share) + "; give a number above 0 and at most 1");
    for (const PropulsorDef& p : def.propulsors) f.names_in_use.push_back(p.name);
    for (const RudderDef& r : def.rudders) f.names_in_use.push_back(r.name);
    for (const char* own : {"rudder", "rps", "tie"}) f.names_in_use.emplace_back(own);
    for (std::size_t b = 0; b < power.boards.size(); ++b) {
        const SwitchboardDef& board = power.boards[b];
        f.claim_name(path_of("boards", b, "name"), board.name);
        if (board.generators.empty())
            f.fail(path_of("boards", b, "generators"), "give one generator or more");
        for (std::size_t g = 0; g < board.generators.size(); ++g) {
            const std::string list = path_of("boards", b, "generators");
            f.claim_name(path_of(list.c_str(), g, "name"), board.generators[g].name);
            f.power(path_of(list.c_str(), g, "power"), board.generators[g].power, false);
        }
    }
    for (std::size_t i = 0; i < power.consumers.size(); ++i) check_consumer(f, def, i);
}

}  // namespace hawser::vessel
