// SPDX-License-Identifier: Apache-2.0
#include "draw/curves.h"

#include <span>

namespace hawser::draw {

std::vector<std::vector<Point>> curve_parts(const Axes& axes, const record::Series& series,
                                            const std::vector<double>& values, double factor) {
    std::vector<double> scaled(values);
    for (double& v : scaled) v *= factor;
    std::vector<std::vector<Point>> out;
    for (const auto& [begin, end] : record::continuous_intervals(series, values))
        out.push_back(thinned(axes, std::span(series.time).subspan(begin, end - begin),
                              std::span(scaled).subspan(begin, end - begin)));
    return out;
}

}  // namespace hawser::draw
