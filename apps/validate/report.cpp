// SPDX-License-Identifier: Apache-2.0
#include "validate/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace hawser::validate {
namespace {

double length(const std::vector<double>& v) {
    double sum = 0.0;
    for (const double x : v) sum += x * x;
    return std::sqrt(sum);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = a.size() == b.size() ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return std::sqrt(sum);
}

double scale_of(double scale, const std::vector<double>& reference) {
    if (scale > 0.0) return scale;
    const double size = length(reference);
    return size > 0.0 ? size : 1.0;
}

std::string text(const std::vector<double>& v) {
    std::string out;
    for (std::size_t i = 0; i < std::min<std::size_t>(v.size(), 3); ++i) {
        out += fmt::format("{}{:.7g}", i ? " " : "", v[i]);
    }
    return out + (v.size() > 3 ? " ..." : "");
}

/// Return a JSON number. Infinite and undefined numbers have no JSON; they become null.
nlohmann::json number(double x) { return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json(); }

}  // namespace

void Report::begin(std::string id, std::string name) {
    id_ = std::move(id);
    name_ = std::move(name);
}

Check& Report::compare(std::string quantity, std::vector<double> reference,
                       std::vector<double> ours, double tolerance, std::string reason,
                       double scale) {
    Check c;
    c.case_id = id_;
    c.case_name = name_;
    c.quantity = std::move(quantity);
    c.reference = std::move(reference);
    c.ours = std::move(ours);
    c.error = distance(c.ours, c.reference) / scale_of(scale, c.reference);
    c.tolerance = tolerance;
    c.reason = std::move(reason);
    c.passed = c.error <= tolerance;  // false for a NaN
    return checks_.emplace_back(std::move(c));
}

void Report::converge(const std::vector<Target>& targets,
                      const std::function<Result(double)>& simulate, const Steps& study) {
    const std::vector<double>& steps = study.steps;
    std::vector<Result> results;
    for (const double step : steps) results.push_back(simulate(step));
    for (std::size_t q = 0; q < targets.size(); ++q) {
        const Target& t = targets[q];
        Check& c = compare(t.quantity, t.reference, results[study.is_checked].at(q), t.tolerance,
                           t.reason, t.scale);
        c.steps = steps;
        c.min_order = t.min_order;
        for (const Result& r : results) {
            c.errors.push_back(distance(r.at(q), t.reference) / scale_of(t.scale, t.reference));
        }
        c.order =
            std::log(c.errors.front() / c.errors.back()) / std::log(steps.front() / steps.back());
        c.passed = c.passed && c.order >= c.min_order;
    }
}

void Report::fail(std::string message) {
    Check c;
    c.case_id = id_;
    c.case_name = name_;
    c.quantity = "ran to the end";
    c.error = std::numeric_limits<double>::quiet_NaN();
    c.message = std::move(message);
    checks_.push_back(std::move(c));
}

bool Report::passed() const noexcept {
    return std::all_of(checks_.begin(), checks_.end(), [](const Check& c) { return c.passed; });
}

void Report::print(std::size_t first) const {
    for (std::size_t i = first; i < checks_.size(); ++i) {
        const Check& c = checks_[i];
        if (i == first) fmt::print("{} {}\n", c.case_id, c.case_name);
        if (!c.message.empty()) {
            fmt::print("  FAIL  {}\n", c.message);
            continue;
        }
        const std::string order = std::isnan(c.order) ? "-" : fmt::format("{:.2f}", c.order);
        fmt::print("  {}  {:<36} {:>30} {:>30} {:>9.2e} {:>6} {:>8.2g}  {}\n",
                   c.passed ? "ok  " : "FAIL", c.quantity, text(c.reference), text(c.ours), c.error,
                   order, c.tolerance, c.reason);
    }
    std::fflush(stdout);
}

std::string Report::json() const {
    nlohmann::json list = nlohmann::json::array();
    for (const Check& c : checks_) {
        nlohmann::json entry{
            {"case", c.case_id},        {"name", c.case_name},      {"quantity", c.quantity},
            {"reference", c.reference}, {"ours", c.ours},           {"error", number(c.error)},
            {"order", number(c.order)}, {"tolerance", c.tolerance}, {"reason", c.reason},
            {"passed", c.passed},       {"steps", c.steps},         {"errors", c.errors}};
        if (!std::isnan(c.min_order)) entry["least_order"] = c.min_order;
        if (!c.message.empty()) entry["message"] = c.message;
        list.push_back(std::move(entry));
    }
    return nlohmann::json{{"passed", passed()}, {"checks", std::move(list)}}.dump(2) + "\n";
}

}  // namespace hawser::validate
