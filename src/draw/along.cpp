// SPDX-License-Identifier: Apache-2.0
#include "draw/along.h"

#include "draw/wire_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::draw {
namespace {

constexpr std::size_t kAlongCells =
    // Number of cells for a wire with a varying number of nodes; more than the pixels of a plot.
    400;

/// Elements of a wire in one frame: start and end of each [m], tension [N].
struct WireElements {
    std::vector<double> from, to, tension;
    std::vector<bool> parted;

    [[nodiscard]] double length() const { return to.empty() ? 0.0 : to.back(); }
    [[nodiscard]] double middle(std::size_t i) const { return 0.5 * (from[i] + to[i]); }
    void add(double length, double pull, bool broken) {
        from.push_back(to.empty() ? 0.0 : to.back());
        to.push_back(from.back() + length);
        tension.push_back(pull);
        parted.push_back(broken);
    }
};

/// Return the elements of a cable with equal lengths, as at the start.
WireElements equal_elements(const record::RecordedCable& cable, const record::Frame& frame) {
    WireElements out;
    for (std::int32_t i = 0; i < cable.elements; ++i)
        out.add(cable.length / cable.elements,
                frame.tensions[static_cast<std::size_t>(cable.first_element) +
                               static_cast<std::size_t>(i)],
                false);
    return out;
}

WireElements unchanged_order(const std::vector<WireLine>& lines, const std::string& name) {
    WireElements out;
    for (const WireLine& line : lines)
        if (line.name == name)
            for (const WirePiece& p : line.segments)
                out.add(p.parted ? 0.0 : (p.to - p.from).norm(), p.tension, p.parted);
    return out;
}

/// Call done(index, frame) for all frames of a recording, except the frame before the first step.
template <class F>
void each_frame(const record::Recording& recording, F&& done) {
    for (std::size_t f = 0; f < recording.frame_count(); ++f) {
        const record::Frame frame = recording.frame(f);
        if (frame.step > 0 || recording.frame_count() == 1) done(f, frame);
    }
}

/// Least, greatest and mean tension in cells of equal length.
class TensionCells {
  public:
    TensionCells(std::size_t count, double length)
        : length_(length),
          least_(count, HUGE_VAL),
          sum_(count, 0.0),
          greatest_(count, -HUGE_VAL),
          sample_counts_(count, 0) {}

    void add_tensions(const WireElements& e) {
        const double cell = length_ / static_cast<double>(sum_.size());
        for (std::size_t i = 0; i < e.tension.size(); ++i) {
            const auto first = static_cast<std::size_t>(e.from[i] / cell + 1e-9);
            const auto behind = static_cast<std::size_t>(std::ceil(e.to[i] / cell - 1e-9));
            for (std::size_t k = first; k < std::min(behind, sum_.size()); ++k) {
                least_[k] = std::min(least_[k], e.tension[i]);
                greatest_[k] = std::max(greatest_[k], e.tension[i]);
                const double middle = (static_cast<double>(k) + 0.5) * cell;
                if (middle < e.from[i] || middle >= e.to[i]) continue;
                sum_[k] += e.tension[i];
                ++sample_counts_[k];
            }
        }
    }

    void write_to(Along& out) const {
        for (std::size_t k = 0; k < sum_.size(); ++k) {
            if (sample_counts_[k] == 0) continue;
            out.s.push_back(length_ * (static_cast<double>(k) + 0.5) /
                            static_cast<double>(sum_.size()));
            out.least.push_back(least_[k]);
            out.mean.push_back(sum_[k] / sample_counts_[k]);
            out.greatest.push_back(greatest_[k]);
        }
    }

  private:
    double length_;
    std::vector<double> least_, sum_, greatest_;
    std::vector<int> sample_counts_;
};

WireElements elements_of(const record::Recording& recording, const Along& wire,
                         const std::vector<WireLine>& lines, const record::Frame& frame) {
    return wire.changes ? unchanged_order(lines, wire.name)
                        : equal_elements(recording.cables[wire.cable], frame);
}

/// List the plotted wires, and find their greatest length and which of them change their nodes.
std::vector<Along> plotted_wires(const record::Recording& recording, const record::Series& series,
                                 std::size_t most, const WireReader& reader) {
    std::vector<Along> out;
    for (const record::CableSeries& s : series.cables)
        if (out.size() < most) {
            out.emplace_back();
            out.back().name = s.name;
            out.back().cable = static_cast<std::size_t>(s.cable);
        }
    each_frame(recording, [&](std::size_t, const record::Frame& frame) {
        if (frame.wires == nullptr) return;
        for (Along& wire : out)
            wire.changes =
                wire.changes || std::any_of(frame.wires->begin(), frame.wires->end(),
                                            [&](const auto& one) { return one.name == wire.name; });
    });
    std::vector<WireLine> lines;
    each_frame(recording, [&](std::size_t, const record::Frame& frame) {
        reader.read(frame, lines);
        for (Along& wire : out)
            wire.length =
                std::max(wire.length, elements_of(recording, wire, lines, frame).length());
    });
    std::erase_if(out, [](const Along& wire) { return !(wire.length > 0.0); });
    return out;
}

}  // namespace

std::vector<Along> tensions_along(const record::Recording& recording, const record::Series& series,
                                  std::size_t most, std::size_t drawn) {
    const WireReader reader(recording);
    std::vector<Along> out = plotted_wires(recording, series, most, reader);
    std::vector<TensionCells> cells;
    for (const Along& wire : out)
        cells.emplace_back(wire.changes
                               ? kAlongCells
                               : static_cast<std::size_t>(recording.cables[wire.cable].elements),
                           wire.length);
    std::vector<WireLine> lines;
    each_frame(recording, [&](std::size_t f, const record::Frame& frame) {
        reader.read(frame, lines);
        for (std::size_t w = 0; w < out.size(); ++w) {
            WireElements e = elements_of(recording, out[w], lines, frame);
            cells[w].add_tensions(e);
            if (f != drawn) continue;
            for (std::size_t i = 0; i < e.tension.size(); ++i) {
                out[w].elements.push_back(e.middle(i));
                if (e.parted[i]) out[w].parted.push_back(e.middle(i));
            }
            out[w].tensions = std::move(e.tension);
        }
    });
    for (std::size_t w = 0; w < out.size(); ++w) cells[w].write_to(out[w]);
    return out;
}

}  // namespace hawser::draw
