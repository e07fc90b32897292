// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file state_visitor.h
/// Visitor of the state of a system (system.h), and rules for states read from bytes.

#include <cstddef>
#include <cstdint>
#include <span>

namespace hawser {

/// Visits the numbers of a system's state.
class StateVisitor {
  public:
    virtual ~StateVisitor() = default;
    /// Visit a finite number.
    void visit(double& value) { numbers({&value, 1}); }
    /// Visit a number that may be NaN, such as a default before it is set.
    void visit_or_nan(double& value) { bytes(&value, sizeof value); }
    void visit(std::int64_t& value) { bytes(&value, sizeof value); }
    void visit(std::int32_t& value) { bytes(&value, sizeof value); }
    void visit(std::span<double> values) { numbers(values); }
    void visit(std::span<std::int64_t> values) { bytes(values.data(), values.size_bytes()); }
    void visit(std::span<std::int32_t> values) { bytes(values.data(), values.size_bytes()); }
    /// True if the visit is around a step. Visit then only data that the step may change and a
    /// failed step must restore, with equal content before and after. A long memory visits only
    /// the line that the step writes.
    [[nodiscard]] virtual bool around_step() const noexcept { return false; }

  protected:
    virtual void bytes(void* data, std::size_t size) = 0;
    /// Visit numbers of the state; by default as bytes.
    virtual void numbers(std::span<double> values) { bytes(values.data(), values.size_bytes()); }
};

/// Collects the first fault of a system's state that was read from bytes (System::check_state()).
class StateRules {
  public:
    /// Require a condition.
    /// @param what  String literal that names the quantity.
    void require(bool holds, const char* what) noexcept {
        if (!holds && *fault_ == '\0') fault_ = what;
    }
    /// Require least ≤ value ≤ most; NaN is a fault.
    void range(double value, double least, double most, const char* what) noexcept {
        require(value >= least && value <= most, what);
    }
    /// Require 0 or 1.
    void flag(std::int32_t value, const char* what) noexcept {
        require(value == 0 || value == 1, what);
    }
    /// Return the first fault; "": none.
    [[nodiscard]] const char* fault() const noexcept { return fault_; }

  private:
    const char* fault_ = "";
};

}  // namespace hawser
