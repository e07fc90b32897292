// SPDX-License-Identifier: Apache-2.0
#include "wire/room.h"

#include <hawser/world.h>

#include "wire/feed.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace hawser::wire {
namespace {

/// Free length in elements above which no element is shortened.
constexpr double kTwoElements = 1.9;
constexpr double kPassingDistance =
    0.2;  ///< Distance in elements within which a wire passes a bollard.
constexpr double kKeepingDistance =
    0.25;  ///< The same distance if the node between already exists.
constexpr double kMinElementLength = 0.2;  ///< Smallest length along the wire [m].

/// Return true if a guide belongs to the bollard.
bool is_guide_of_post(const GuideDef& guide, std::string_view post) noexcept {
    return guide.name.size() > post.size() && guide.name.starts_with(post) &&
           guide.name[post.size()] == '/';
}

/// Call f(ends, distance along the wire to the element, id) for the elements on a side of a guide.
/// It starts at the guide and ends when f returns false.
template <class F>
void each_element(const World& world, const GuideDef& guide, InteractionId line, std::size_t side,
                  F&& f) {
    const auto elements = world.wires().elements(guide.wire);
    auto at = std::find(elements.begin(), elements.end(), line);
    double sum = 0.0;
    while (at != elements.end() && world.alive(*at) && world.intact(*at)) {
        std::array<Vec3, 2> ends = world.wires().ends(*at);
        if (side == 0) std::swap(ends[0], ends[1]);
        if (!f(ends, sum, *at) || (side == 0 && at == elements.begin())) return;
        sum += (ends[1] - ends[0]).norm();
        at += side == 0 ? -1 : 1;
    }
}

bool is_at_drum(const World& world, InteractionId id) {
    return kind_info(world.interaction_def(id).kind).is(kWoundUp);
}

/// Return the distance along the wire to the next guide, at most `enough` [m].
double distance_to_guide(const World& world, const GuideDef& guide, InteractionId line,
                         std::size_t side, double enough) {
    double way = enough;
    each_element(world, guide, line, side, [&](const auto& ends, double sum, InteractionId id) {
        sum += (ends[1] - ends[0]).norm();
        if (sum >= enough) return false;
        if (id == line || !is_at_drum(world, id)) return true;
        // A drum makes elements of its own length and has room for two.
        if (kind_info(world.interaction_def(id).kind).is(kAtGuide)) way = sum;
        return false;
    });
    return way;
}

/// Return the distance along the wire to the nearest bollard that it passes without lying on it, at
/// most `enough` [m].
double distance_to_post(const World& world, const GuideDef& guide, InteractionId line,
                        std::size_t side, double enough, double reach) {
    double way = enough;
    for (const SystemSignal& s : world.system_signals()) {
        if (s.name != "taken" || is_guide_of_post(guide, s.system)) continue;
        const auto* post = dynamic_cast<const PassedPost*>(world.find_system(s.system));
        if (post == nullptr || post->carries(guide.wire)) continue;
        double gap = reach, along = enough;
        each_element(world, guide, line, side, [&](const auto& ends, double sum, InteractionId id) {
            const auto near = post->separation(world, ends);
            if (near.gap < gap) {
                gap = near.gap;
                along = sum + near.fraction * (ends[1] - ends[0]).norm();
            }
            return sum < enough && (id == line || !is_at_drum(world, id));
        });
        if (along > kMinElementLength) way = std::min(way, along);
    }
    return way;
}

}  // namespace

double element_length_at_guide(const World& world, const GuideDef& def, InteractionId line,
                               std::size_t side, double straight) {
    const double usual = def.element_length, enough = kTwoElements * usual;
    const double reach =
        usual * (straight < kRemoveRatio * usual ? kKeepingDistance : kPassingDistance);
    const double way = std::min(distance_to_guide(world, def, line, side, enough),
                                distance_to_post(world, def, line, side, enough, reach));
    if (way >= enough) return usual;
    return std::max(std::min(usual, 0.5 * way), std::min(usual, 0.5 * kMinElementLength));
}

}  // namespace hawser::wire
