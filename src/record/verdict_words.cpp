// SPDX-License-Identifier: Apache-2.0
#include "record/verdict_words.h"

#include "record/units.h"

#include <fmt/format.h>

#include <cmath>

namespace hawser::record {

std::string sentence(Judge judge, const Finding& f, const std::string& where) {
    const std::string when = fmt::format("at {:.6g} s", f.time);
    switch (judge) {
        case Judge::energy:
            return fmt::format(
                "{} of mechanical energy {} {}", with_unit(std::abs(f.value), "J"),
                f.value < 0.0 ? "had vanished without reason" : "had come out of nothing", when);
        case Judge::violation:
            return fmt::format("joint '{}' stood open by {:.4g} m or rad {}", where, f.value, when);
        case Judge::cable:
            return fmt::format(
                "the tension of element '{}' was off by what {:.4g} of its length makes {}", where,
                f.value, when);
        case Judge::certificate:
            return fmt::format("the step's equations were left unsolved by {:.2e}, relative, {}",
                               f.value, when);
        case Judge::speed:
            return fmt::format("'{}' turned by {:.3g} rad in a step {}", where, f.value, when);
    }
    return {};
}

}  // namespace hawser::record
