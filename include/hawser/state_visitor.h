// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file state_visitor.h
/// Visitor of the state of a system (system.h), and rules for states read from bytes.

#include <cstddef>
#include <cstdint>
#include <span>

namespace hawser {

/// Interface that visits the numbers of a system's state, to save, restore, hash or copy them. A
/// system passes its variables by reference in System::visit_state(); a visitor may read or write
/// them.
class StateVisitor {
  public:
    virtual ~StateVisitor() = default;
    /// Visit a finite number. A restored value that is not finite is rejected.
    void visit(double& value) { numbers({&value, 1}); }
    /// Visit a number that may be NaN, such as a default that is not set yet.
    void visit_or_nan(double& value) { bytes(&value, sizeof value); }
    /// Visit an integer, or a range of numbers or integers.
    void visit(std::int64_t& value) { bytes(&value, sizeof value); }
    void visit(std::int32_t& value) { bytes(&value, sizeof value); }
    void visit(std::span<double> values) { numbers(values); }
    void visit(std::span<std::int64_t> values) { bytes(values.data(), values.size_bytes()); }
    void visit(std::span<std::int32_t> values) { bytes(values.data(), values.size_bytes()); }
    /// True if the visit saves or restores data around one step. Then visit only data that the step
    /// may change, the same data before and after it. For example, of a long memory visit only the
    /// entry that the step writes.
    [[nodiscard]] virtual bool around_step() const noexcept { return false; }

  protected:
    /// Visit `size` bytes of the state at `data`.
    virtual void bytes(void* data, std::size_t size) = 0;
    /// Visit numbers of the state; by default as bytes.
    virtual void numbers(std::span<double> values) { bytes(values.data(), values.size_bytes()); }
};

/// Rules that System::check_state() applies to a restored state. Stores the first fault.
class StateRules {
  public:
    /// Require a condition.
    /// @param what  Fault if the condition is false, a string literal.
    void require(bool holds, const char* what) noexcept {
        if (!holds && *fault_ == '\0') fault_ = what;
    }
    /// Require least ≤ value ≤ most; NaN is a fault.
    void range(double value, double least, double most, const char* what) noexcept {
        require(value >= least && value <= most, what);
    }
    /// Check that a restored flag is 0 or 1. @param what  Name of the flag in the message.
    void flag(std::int32_t value, const char* what) noexcept {
        require(value == 0 || value == 1, what);
    }
    /// Return the first fault; "": none.
    [[nodiscard]] const char* fault() const noexcept { return fault_; }

  private:
    const char* fault_ = "";
};

}  // namespace hawser
