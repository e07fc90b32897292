// SPDX-License-Identifier: Apache-2.0
/// Power bus of a vessel (hawser/vessel_power.h).
#include "vessel/power.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hawser::vessel {
namespace {

constexpr double kUnlimited = 1e300;
/// Withheld fraction of a demand above which a consumer counts as shed. It exceeds the rounding of
/// sums.
constexpr double kShedShare = 1e-9;

}  // namespace

SignalRef::SignalRef(const std::string& name)
    : system_(name.substr(0, name.find('.'))), name_(name.substr(name.find('.') + 1)) {}

double SignalRef::value(const World& world) noexcept {
    const auto& all = world.system_signals();
    const auto fits = [&](const SystemSignal& s) { return s.name == name_ && s.system == system_; };
    if (index_ < all.size() && fits(all[index_])) return *all[index_].value;
    for (index_ = 0; index_ < all.size(); ++index_)
        if (fits(all[index_])) return *all[index_].value;
    return 0.0;
}

PowerBus::PowerBus(const VesselDef& def)
    : available_fraction_(def.power.share),
      tie_(def.power.tied ? 1.0 : 0.0),
      of_propulsor_(def.propulsors.size(), -1) {
    for (const SwitchboardDef& b : def.power.boards) {
        Board board;
        board.part.name = b.name;
        for (const GeneratorDef& g : b.generators)
            board.generators.push_back({.name = g.name, .power = g.power});
        boards_.push_back(std::move(board));
    }
    for (const ConsumerDef& c : def.power.consumers) {
        Consumer out{.name = c.name, .priority = c.priority, .efficiency = c.efficiency};
        for (std::size_t b = 0; b < boards_.size(); ++b)
            if (boards_[b].part.name == c.board) out.board = b;
        for (std::size_t p = 0; p < def.propulsors.size(); ++p)
            if (def.propulsors[p].name == c.name) out.propulsor = static_cast<int>(p);
        if (out.propulsor >= 0)
            of_propulsor_[static_cast<std::size_t>(out.propulsor)] =
                static_cast<int>(consumers_.size());
        if (!c.signal.empty()) {
            out.signal = static_cast<int>(signal_refs_.size());
            signal_refs_.emplace_back(c.signal);
        }
        (is_load(out) ? out.load : out.rated) = c.power;
        consumers_.push_back(std::move(out));
    }
    order_.resize(consumers_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
        return consumers_[a].priority < consumers_[b].priority;
    });
}

const PowerBus::Consumer* PowerBus::find(std::size_t propulsor) const noexcept {
    const int i = of_propulsor_[propulsor];
    return i < 0 ? nullptr : &consumers_[static_cast<std::size_t>(i)];
}

double PowerBus::rated_power(std::size_t propulsor) const noexcept {
    const Consumer* c = find(propulsor);
    return c == nullptr ? 0.0 : c->rated;
}

void PowerBus::demand(std::size_t propulsor, double power) noexcept {
    const int i = of_propulsor_[propulsor];
    if (i < 0) return;
    Consumer& c = consumers_[static_cast<std::size_t>(i)];
    c.demand = std::max(0.0, power) / c.efficiency;
}

double PowerBus::granted_power(std::size_t propulsor) const noexcept {
    const Consumer* c = find(propulsor);
    if (c == nullptr) return kUnlimited;
    // Without shedding the consumer is not limited, not even by rounding.
    return c->shedding == 0 ? kUnlimited : c->granted * c->efficiency;
}

double PowerBus::capacity(const Board& board) noexcept {
    if (failed(board.part)) return 0.0;
    double sum = 0.0;
    for (const Part& g : board.generators)
        if (!failed(g)) sum += g.power;
    return sum;
}

bool PowerBus::have_common_board(const Consumer& a, const Consumer& b) const noexcept {
    if (failed(boards_[a.board].part) || failed(boards_[b.board].part)) return false;
    return tie_ >= 0.5 || a.board == b.board;
}

double PowerBus::available_fraction(std::size_t propulsor,
                                    const std::vector<double>& full) const noexcept {
    const Consumer* c = find(propulsor);
    if (c == nullptr) return 1.0;
    if (failed(boards_[c->board].part)) return 0.0;
    double left = 0.0, asked = 0.0;
    for (const Board& b : boards_)
        if (tie_ >= 0.5 || &b == &boards_[c->board]) left += available_fraction_ * capacity(b);
    for (const Consumer& other : consumers_) {
        if (other.priority > c->priority || !have_common_board(other, *c)) continue;
        const double present = is_load(other) ? other.load : other.demand;
        if (other.priority < c->priority)
            left -= present;
        else if (other.propulsor >= 0)
            asked += full[static_cast<std::size_t>(other.propulsor)] / other.efficiency;
        else
            asked += present;
    }
    return asked > left ? std::max(0.0, left) / asked : 1.0;
}

void PowerBus::distribute(double capacity, int board) noexcept {
    const auto served = [&](const Consumer& c) {
        return board < 0 ? !failed(boards_[c.board].part)
                         : c.board == static_cast<std::size_t>(board);
    };
    double left = available_fraction_ * capacity, taken = 0.0;
    for (std::size_t first = 0; first < order_.size();) {
        const int priority = consumers_[order_[first]].priority;
        double total_demand = 0.0;
        std::size_t end = first;
        for (; end < order_.size() && consumers_[order_[end]].priority == priority; ++end)
            if (served(consumers_[order_[end]])) total_demand += consumers_[order_[end]].demand;
        const double part = total_demand > left ? left / total_demand : 1.0;
        for (std::size_t i = first; i < end; ++i) {
            Consumer& c = consumers_[order_[i]];
            if (served(c)) c.granted = part * c.demand;
        }
        left = std::max(0.0, left - total_demand);
        taken += part * total_demand;
        first = end;
    }
    for (std::size_t b = 0; b < boards_.size(); ++b) {
        if (board >= 0 ? b != static_cast<std::size_t>(board) : failed(boards_[b].part)) continue;
        boards_[b].load = taken;
        boards_[b].spare = available_fraction_ * capacity - taken;
    }
}

void PowerBus::report_failures(Prestep& now, BodyId body) noexcept {
    const auto report = [&](Part& part) {
        const bool down = failed(part);
        if (down && part.reported == 0) now.tell(EventKind::failure, body, part.failed);
        part.reported = down ? 1 : 0;
    };
    for (Board& b : boards_) {
        report(b.part);
        for (Part& g : b.generators) report(g);
    }
}

void PowerBus::grant_power(Prestep& now, BodyId body) noexcept {
    report_failures(now, body);
    for (Consumer& c : consumers_) {
        if (c.signal >= 0)
            c.demand = std::abs(signal_refs_[static_cast<std::size_t>(c.signal)].value(now.world)) /
                       c.efficiency;
        else if (c.propulsor < 0)
            c.demand = c.load;
        c.granted = 0.0;
    }
    for (Board& b : boards_) b.load = b.spare = 0.0;
    if (tie_ >= 0.5) {
        double sum = 0.0;
        for (const Board& b : boards_) sum += capacity(b);
        distribute(sum, -1);
    } else {
        for (std::size_t b = 0; b < boards_.size(); ++b)
            distribute(capacity(boards_[b]), static_cast<int>(b));
    }
    for (Consumer& c : consumers_) {
        c.shed = c.demand - c.granted;
        const bool shedding = c.shed > kShedShare * c.demand;
        if (!shedding) c.shed = 0.0;
        if (shedding && c.shedding == 0) now.tell(EventKind::shed, body, c.shed);
        c.shedding = shedding ? 1 : 0;
    }
}

void PowerBus::visit_state(StateVisitor& v) {
    if (!any()) return;
    v.visit(tie_);
    for (Board& b : boards_) {
        v.visit(b.load);
        v.visit(b.spare);
        v.visit(b.part.failed);
        v.visit(b.part.reported);
        for (Part& g : b.generators) {
            v.visit(g.failed);
            v.visit(g.reported);
        }
    }
    for (Consumer& c : consumers_) {
        for (double* x : {&c.load, &c.demand, &c.granted, &c.shed}) v.visit(*x);
        v.visit(c.shedding);
    }
}

void PowerBus::check_state(StateRules& rules) const {
    for (const Board& b : boards_) {
        rules.flag(b.part.reported, "whether a failed switchboard was reported is no flag");
        for (const Part& g : b.generators)
            rules.flag(g.reported, "whether a failed generator was reported is no flag");
    }
    for (const Consumer& c : consumers_)
        rules.flag(c.shedding, "whether a consumer is shed is no flag");
}

void PowerBus::signals(SignalTable& table) {
    if (boards_.size() > 1) table.input("tie", "1", tie_, 0.0, 1.0);
    for (Board& b : boards_) {
        table.input(b.part.name + "_failed", "1", b.part.failed, 0.0, 1.0);
        table.output(b.part.name + "_load", "W", b.load);
        table.output(b.part.name + "_spare", "W", b.spare);
        for (Part& g : b.generators) table.input(g.name + "_failed", "1", g.failed, 0.0, 1.0);
    }
    for (Consumer& c : consumers_) {
        if (is_load(c)) table.input(c.name, "W", c.load, 0.0, 1e12);
        table.output(c.name + "_shed", "W", c.shed);
    }
}

}  // namespace hawser::vessel
