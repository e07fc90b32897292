// SPDX-License-Identifier: Apache-2.0
#include "access/wire_alerts.h"

#include "base/index.h"
#include "context/wires_data.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

/// For so long a wire is stepped more calmly, the longer of both.
constexpr double kAlertSteps = 20.0, kAlertSeconds = 1.0;

}  // namespace

std::int32_t most_alert(double step) noexcept {
    // A step of 1e-7 s, the shortest, makes ten million of them.
    return static_cast<std::int32_t>(std::ceil(std::max(kAlertSteps, kAlertSeconds / step)));
}

void follow_alerts(Model& model) noexcept {
    Wires& w = model.wires;
    for (std::size_t k = 0; k < w.count(); ++k) {
        if (!(w.credit[k] >= 0.0) || !std::isfinite(w.credit[k])) w.credit[k] = 0.0;
        w.alert[k] = std::max(0, w.alert[k]);
    }
    for (const std::int32_t id : w.element)
        model.interactions.alert[at(id)] = w.alert[at(w.wire_of[at(id)])] > 0 ? 1.0 : 0.0;
    w.stale = false;
}

}  // namespace hawser::stepper
