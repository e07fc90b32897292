// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file state_visitor.h
/// Visits the state of a system (system.h), and checks one that was read from bytes.

#include <cstddef>
#include <cstdint>
#include <span>

namespace hawser {

/// Visits the numbers that make up a system's state.
class StateVisitor {
  public:
    virtual ~StateVisitor() = default;
    void visit(double& value) { numbers({&value, 1}); }
    /// A number that may be NaN, such as a default that is not known yet.
    void visit_or_nan(double& value) { bytes(&value, sizeof value); }
    void visit(std::int64_t& value) { bytes(&value, sizeof value); }
    void visit(std::int32_t& value) { bytes(&value, sizeof value); }
    void visit(std::span<double> values) { numbers(values); }
    void visit(std::span<std::int64_t> values) { bytes(values.data(), values.size_bytes()); }
    void visit(std::span<std::int32_t> values) { bytes(values.data(), values.size_bytes()); }
    /// True around a step, whose failure is to take back what prestep() did: only what that may
    /// change need be visited, the same before and after. A long memory of which a step writes one
    /// line visits that line.
    [[nodiscard]] virtual bool around_step() const noexcept { return false; }

  protected:
    virtual void bytes(void* data, std::size_t size) = 0;
    /// Numbers of the state; by default they are visited as bytes.
    virtual void numbers(std::span<double> values) { bytes(values.data(), values.size_bytes()); }
};

/// Collects the first fault of a system's state that was read from bytes (System::check_state()).
class StateRules {
  public:
    /// @param what  Literal that names the quantity.
    void require(bool holds, const char* what) noexcept {
        if (!holds && *fault_ == '\0') fault_ = what;
    }
    /// NaN is out of any range.
    void range(double value, double least, double most, const char* what) noexcept {
        require(value >= least && value <= most, what);
    }
    void flag(std::int32_t value, const char* what) noexcept {
        require(value == 0 || value == 1, what);
    }
    [[nodiscard]] const char* fault() const noexcept { return fault_; }  ///< "": none.

  private:
    const char* fault_ = "";
};

}  // namespace hawser
