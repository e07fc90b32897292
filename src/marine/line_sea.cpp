// SPDX-License-Identifier: Apache-2.0
#include <hawser/line_sea.h>
#include <hawser/world.h>

#include "marine/bodies.h"
#include "marine/checks.h"
#include "marine/sea_system.h"

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace hawser {
namespace marine {

std::shared_ptr<const LineSea> line_part(const SeaDef& def, double gravity,
                                         const LineTable& table) {
    if (table.sorts.empty()) return nullptr;
    auto out = std::make_shared<LineSea>();
    out->sea.depth = def.depth;
    out->sea.density = def.density;
    out->sea.level = def.level;
    out->sea.waves = def.waves;
    out->sea.current = def.current;
    out->sea.convective = def.convective;
    out->gravity = gravity;
    out->sorts = table.sorts;
    for (std::size_t i = 0; i < table.of_element.size(); ++i) {
        const LineTable::Known& known = table.of_element[i];
        if (known.generation < 0) continue;
        out->elements.push_back({{static_cast<std::int32_t>(i), known.generation}, known.sort});
    }
    out->holders = table.holders;
    return out;
}

namespace {

LineTable table_of(const LineSea& of) {
    LineTable out;
    out.length_param = length_params();
    for (const LineWater& w : of.sorts) {
        check_line_water("sorts", w);
        out.sorts.push_back(with_volume(w));
    }
    for (const LineSea::Element& e : of.elements) {
        if (e.id.index < 0 || e.id.index > kMaxLineElement || e.id.generation < 0)
            throw SeaError("elements", "there is no such element");
        if (e.sort < 0 || static_cast<std::size_t>(e.sort) >= of.sorts.size())
            throw SeaError("elements", "an element has no coefficients");
        const auto place = static_cast<std::size_t>(e.id.index);
        if (out.of_element.size() <= place) out.of_element.resize(place + 1);
        out.of_element[place] = {e.id.generation, e.sort};
    }
    out.holders = of.holders;
    std::sort(out.holders.begin(), out.holders.end());
    return out;
}

}  // namespace
}  // namespace marine

struct LineLoads::Impl {
    explicit Impl(const LineSea& of)
        : current(of.sea.current),
          sea(of.sea, of.gravity),
          moment(sea.at(0.0)),
          field(sea, current),
          nodes(marine::table_of(of)),
          convective(of.sea.convective) {}

    std::vector<SeaCurrent> current;
    Sea sea;
    SeaMoment moment;
    marine::WaterField field;
    marine::LineNodes nodes;
    bool convective;
};

LineLoads::LineLoads(const LineSea& of) : impl_(std::make_unique<Impl>(of)) {}
LineLoads::~LineLoads() = default;

bool LineLoads::compute(Prestep& now, const SeaInputs& inputs) noexcept {
    Impl& m = *impl_;
    try {
        m.sea.at(now.time, inputs, m.moment);
        m.field.begin(m.moment);
        m.nodes.list(now.world);
    } catch (const std::bad_alloc&) {
        return false;
    }
    now.for_each(m.nodes.wires(), [&](int i) noexcept { m.nodes.find(now.world, i); });
    now.for_each(m.nodes.chunks(),
                 [&](int i) noexcept { m.nodes.load_chunk(m.field, m.convective, i); });
    return true;
}

void LineLoads::add(Loads& loads, std::span<const BodyId> except) const noexcept {
    const marine::LineNodes& nodes = impl_->nodes;
    for (int i = 0; i < nodes.count(); ++i)
        if (nodes.of(i).any && !std::binary_search(except.begin(), except.end(), nodes.body(i)))
            marine::add_point(nodes.of(i), loads.of(nodes.body(i)));
}

std::shared_ptr<const LineSea> line_sea(const World& world) noexcept {
    const auto* sea = dynamic_cast<const marine::SeaSystem*>(world.find_system("sea"));
    return sea == nullptr ? nullptr : sea->line_part();
}

SeaInputs acting_inputs(const World& world) noexcept {
    const auto* sea = dynamic_cast<const marine::SeaSystem*>(world.find_system("sea"));
    return sea == nullptr ? SeaInputs{} : sea->acting_inputs();
}

}  // namespace hawser
