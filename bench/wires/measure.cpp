// SPDX-License-Identifier: Apache-2.0
#include "measure.h"

#include "peers/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace hawser::bench::wires {
namespace {

constexpr double kRamp = 1.0;  ///< Ramp of each force [s].
constexpr double kLost = 0.2;  ///< Displacement of the weight at which a run ends [m].
constexpr double kFar = 0.01;  ///< Displacement in a wait beyond which it slips [m].
/// Displacement in half a wait below which nothing slips [m]: an excess force of 5e-6 gives this
/// displacement.
constexpr double kStill = 3e-4;
constexpr double kSeparation = 0.05;  ///< Gap at which a chain counts as torn [m].

enum class End : std::uint8_t { stands, ran, failed };

/// Runs a rig frame by frame.
class Pulling {
  public:
    Pulling(const WireMethod& method, double turns, int substeps, double exponent)
        : rig_(method.make(turns, substeps)), substeps_(substeps), exponent_(exponent) {}

    /// Run to `time` [s]. Stops if the weight has slipped or the engine failed.
    End run_to(double time) {
        while (t_ < time - 0.5 * kFrame && end_ == End::stands) frame();
        return end_;
    }
    [[nodiscard]] const Rig& rig() const { return *rig_; }
    [[nodiscard]] double cpu() const { return cpu_; }
    [[nodiscard]] double time() const { return t_; }
    [[nodiscard]] double gap() const { return gap_; }
    [[nodiscard]] double median_ms() {
        if (ms_.empty()) return 0.0;
        const auto middle = ms_.begin() + static_cast<std::ptrdiff_t>(ms_.size() / 2);
        std::nth_element(ms_.begin(), middle, ms_.end());
        return *middle;
    }
    void stop_after_distance(double way) { travel_limit_ = way; }
    void forget_times() {
        ms_.clear();
        gap_ = 0.0;
    }

  private:
    static double smooth(double u) {
        u = std::clamp(u, 0.0, 1.0);
        return u * u * (3.0 - 2.0 * u);
    }
    void frame() {
        double cpu = 0.0;
        bool good = true;
        for (int k = 0; k < substeps_ && good; ++k) {
            const double t = t_ + kFrame * (k + 1) / substeps_;
            const double weight = kW * smooth(t / kRamp);
            rig_->load(weight, weight * std::exp(exponent_ * smooth(t / kRamp - 1.0)));
            cpu += measure_time([&] { good = rig_->substep(); }).cpu;
        }
        t_ += kFrame;
        cpu_ += cpu;
        ms_.push_back(1e3 * cpu);
        const double way = rig_->displacement(), gap = rig_->gap();
        gap_ = std::max(gap_, gap);
        if (!good || !std::isfinite(way) || !(gap < kSeparation))
            end_ = End::failed;
        else if (std::abs(way) > travel_limit_)
            end_ = End::ran;
    }

    std::unique_ptr<Rig> rig_;
    int substeps_;
    double exponent_, t_ = 0.0, cpu_ = 0.0, gap_ = 0.0;
    std::vector<double> ms_;
    double travel_limit_ = kLost;
    End end_ = End::stands;
};

class Search {
  public:
    Search(const WireMethod& method, double turns, const WirePlan& plan)
        : m_(method), plan_(plan), turns_(turns) {
        f_.method = method.name;
        f_.turns = turns;
        f_.ours = method.ours;
        euler_ = kRub * 2.0 * kPi * turns;
        guess_ = method.exponent(turns);
        f_.own_error = std::expm1(guess_ - euler_);
    }
    WireFigures run() {
        const std::unique_ptr<Rig> probe = m_.make(turns_, 1);
        f_.has_case = probe != nullptr;
        if (!f_.has_case) return f_;
        f_.settings = probe->settings();
        find_substeps();
        if (!f_.holds) return f_;
        find_ratio();
        creep();
        return f_;
    }

  private:
    /// Find the least number of substeps with which it holds midway to slipping.
    void find_substeps() {
        const double half = 0.5 * std::min(guess_, euler_);
        const bool given = plan_.substeps > 0 && !m_.ours;
        for (int n = given ? plan_.substeps : 1; n <= plan_.max_substeps; n *= 2) {
            Pulling p(m_, turns_, n, half);
            const End end = p.run_to(2.0 * kRamp + 1.0);
            f_.substeps = n;
            f_.settings = p.rig().settings();
            spent_ += p.cpu();
            f_.ms = p.median_ms();
            f_.gap = p.gap();
            f_.holds = end == End::stands && std::abs(p.rig().displacement()) < 0.25 * kLost;
            if (f_.holds || m_.ours) break;
            f_.reason_unusable = describe(end, p);
            if (given || spent_ > plan_.budget) break;
        }
        if (f_.holds) f_.reason_unusable.clear();
    }
    static std::string describe(End end, const Pulling& p) {
        const double way = p.rig().displacement();
        if (end == End::failed)
            return p.gap() >= kSeparation
                       ? fmt::format("comes apart: {:.2g} m after {:.2f} s", p.gap(), p.time())
                       : fmt::format("fails after {:.2f} s", p.time());
        return fmt::format("runs: {:.2g} m in {:.2f} s at half of the exponent", way, p.time());
    }
    bool slips(double exponent) {
        Pulling p(m_, turns_, f_.substeps, exponent);
        const double from = 2.0 * kRamp;
        p.run_to(from);
        const double start = p.rig().displacement();
        p.stop_after_distance(std::abs(start) + kFar);
        p.run_to(from + 0.5 * plan_.wait);
        const double middle = p.rig().displacement();
        const End end = p.run_to(from + plan_.wait);
        spent_ += p.cpu();
        if (end != End::stands) return true;
        const double first = middle - start, second = p.rig().displacement() - middle;
        return std::abs(first + second) > kFar ||
               (std::abs(second) > kStill && std::abs(second) > 2.0 * std::abs(first));
    }
    void find_ratio() {
        // From the method's closed form outwards, then by bisection.
        double low = guess_, high = guess_, reach = 4e-3;
        const double width = m_.ours ? plan_.own_width : plan_.peer_width;
        if (slips(guess_ + reach)) {
            high = guess_ + reach;
            for (low = guess_ - reach; low > 0.0 && slips(low); low = guess_ - reach) {
                high = low;
                reach *= 3.0;
            }
            low = std::max(low, 0.0);
        } else {
            low = guess_ + reach;
            for (high = guess_ + 3.0 * reach; high < 4.0 * guess_ + 1.0 && !slips(high);
                 high = guess_ + 3.0 * reach) {
                low = high;
                reach *= 3.0;
            }
        }
        while (high - low > width && spent_ < plan_.budget) {
            const double mid = 0.5 * (low + high);
            (slips(mid) ? high : low) = mid;
        }
        const double found = 0.5 * (low + high);
        f_.ratio = std::exp(found);
        f_.width = std::expm1(high - low);
        f_.error = std::expm1(found - euler_);
    }
    void creep() {
        Pulling p(m_, turns_, f_.substeps, std::log(0.99 * f_.ratio));
        const double from = 2.0 * kRamp + 1.0;
        p.run_to(from);
        const double start = p.rig().displacement();
        p.forget_times();
        const double began = p.time();
        p.run_to(from + plan_.creep);
        f_.creep = std::abs(p.rig().displacement() - start);
        f_.creep_seconds = p.time() - began;
        f_.gap = p.gap();
        if (p.time() > began) f_.ms = p.median_ms();
    }

    const WireMethod& m_;
    const WirePlan& plan_;
    double turns_, euler_ = 0.0, guess_ = 0.0, spent_ = 0.0;
    WireFigures f_;
};

}  // namespace

WireFigures measure(const WireMethod& method, double turns, const WirePlan& plan) {
    return Search(method, turns, plan).run();
}

}  // namespace hawser::bench::wires
