// SPDX-License-Identifier: Apache-2.0
#define HAWSER_KIND_SETUP
#include <hawser/def.h>
#include <hawser/interactions.h>

#include "model/kinds/all.h"

#include <array>
#include <cmath>

namespace hawser {
namespace {

constexpr std::array<KindInfo, kInteractionKindCount> kKinds = {
#define HAWSER_X(id, text) generic::kinds::id::kInfo,
    HAWSER_INTERACTION_KINDS(HAWSER_X)
#undef HAWSER_X
};

/// True if the table of kinds, the enumeration InteractionKind and the structs of kinds have the
/// same order.
constexpr bool consistent() {
    bool ok = true;
#define HAWSER_X(id, text)                                                  \
    ok =                                                                    \
        ok && generic::kinds::id::kInfo.kind == InteractionKind::id &&      \
        std::string_view(generic::kinds::id::kInfo.name) == text &&         \
        generic::kinds::id::kInfo.bodies == generic::kinds::id::kBodies &&  \
        generic::kinds::id::kInfo.rows == generic::kinds::id::kRows &&      \
        generic::kinds::id::kInfo.params.size() <= kMaxInteractionParams && \
        std::string_view(generic::kinds::id::kInfo.row_units).size() == generic::kinds::id::kRows;
    HAWSER_INTERACTION_KINDS(HAWSER_X)
#undef HAWSER_X
    return ok;
}
static_assert(consistent(), "an interaction kind contradicts its table entry");

std::size_t param_index(const KindInfo& info, std::string_view param) {
    for (std::size_t i = 0; i < info.params.size(); ++i)
        if (param == info.params[i].name) return i;
    std::string message = std::string("interaction kind '") + info.name + "' has no parameter '" +
                          std::string(param) + "'; it has:";
    for (const ParamInfo& p : info.params) message += std::string(" ") + p.name;
    throw DefError(message);
}

}  // namespace

std::span<const KindInfo> interaction_kinds() noexcept { return kKinds; }

const KindInfo& kind_info(InteractionKind kind) noexcept {
    return kKinds[static_cast<std::size_t>(kind)];
}

const KindInfo* find_kind(std::string_view name) noexcept {
    for (const KindInfo& info : kKinds)
        if (name == info.name) return &info;
    return nullptr;
}

InteractionDef& InteractionDef::set(std::string_view param, double value) {
    params[param_index(kind_info(kind), param)] = value;
    return *this;
}

double InteractionDef::get(std::string_view param) const {
    return params[param_index(kind_info(kind), param)];
}

}  // namespace hawser
