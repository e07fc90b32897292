// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file report.h
/// Results of a validation case.

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace hawser::validate {

/// One number or one vector compared with its reference.
struct Check {
    std::string case_id;
    std::string case_name;
    std::string quantity;  ///< Quantity with its unit.
    std::vector<double> reference;
    std::vector<double> ours;
    double error = 0.0;                                       ///< |ours − reference| / scale.
    double order = std::numeric_limits<double>::quiet_NaN();  ///< Order over the whole study.
    double tolerance = 0.0;                                   ///< Largest error accepted.
    double min_order = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> steps;   ///< Steps of a convergence study [s].
    std::vector<double> errors;  ///< Error at each of them.
    std::string reason;          ///< Why this tolerance.
    std::string message;         ///< Message of a case that could not run.
    bool passed = false;
};

/// Result at one step: one vector for each quantity of the case.
using Result = std::vector<std::vector<double>>;

/// Reference and tolerance of a quantity.
struct Target {
    std::string quantity;
    std::vector<double> reference;
    double scale = 0.0;       ///< Divisor of the error; 0: the length of the reference.
    double tolerance = 1e-3;  ///< Tolerance at the reference step.
    double min_order = 1.9;   ///< Least order over all halvings.
    std::string reason = "relative, second order";
};

/// Steps of a convergence study, each half of the previous one, and the index of the step for the
/// error. The order is that over all halvings. Errors of phase (second order) and dissipation
/// (third order) may have opposite signs and distort single halvings.
struct Steps {
    std::vector<double> steps;
    std::size_t is_checked = 0;
};
/// Error at h = 1/960 s, order over three halvings about it.
inline const Steps kAbout960{{1.0 / 480, 1.0 / 960, 1.0 / 1920, 1.0 / 3840}, 1};
/// The same error, order over three coarser halvings, for cases in which finer steps are limited by
/// the resolution of the measurement.
inline const Steps kTo960{{1.0 / 120, 1.0 / 240, 1.0 / 480, 1.0 / 960}, 3};

class Report {
  public:
    void begin(std::string id, std::string name);

    /// Compare a value with its reference. @param scale  Scale of the relative error; 0: the norm
    /// of the reference.
    Check& compare(std::string quantity, std::vector<double> reference, std::vector<double> ours,
                   double tolerance, std::string reason, double scale = 0.0);

    /// Run `simulate` at several steps. Compare every quantity with its reference, and compute the
    /// order of convergence.
    void converge(const std::vector<Target>& targets,
                  const std::function<Result(double step)>& simulate,
                  const Steps& steps = kAbout960);

    /// Record a failed check because the case has thrown an exception.
    void fail(std::string message);

    [[nodiscard]] const std::vector<Check>& checks() const noexcept { return checks_; }
    [[nodiscard]] bool passed() const noexcept;

    /// Print the checks from index `first` on.
    void print(std::size_t first) const;
    [[nodiscard]] std::string json() const;

  private:
    std::string id_, name_;
    std::vector<Check> checks_;
};

}  // namespace hawser::validate
