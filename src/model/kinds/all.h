// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file all.h
/// Include every kind. The list of kinds is HAWSER_INTERACTION_KINDS in <hawser/interactions.h>.

#include "model/kinds/bends.h"
#include "model/kinds/clutch.h"
#include "model/kinds/drives.h"
#include "model/kinds/friction.h"
#include "model/kinds/gear.h"
#include "model/kinds/hydrostatic.h"
#include "model/kinds/joints.h"
#include "model/kinds/lines.h"
#include "model/kinds/routes.h"

namespace hawser::HAWSER_ISA {

/// Call f.template operator()<Kind>() for the kind with this enumerator.
template <class F>
inline void with_kind(InteractionKind kind, F&& f) {
    switch (kind) {
#define HAWSER_X(id, name)                  \
    case InteractionKind::id:               \
        f.template operator()<kinds::id>(); \
        break;
        HAWSER_INTERACTION_KINDS(HAWSER_X)
#undef HAWSER_X
    }
}

}  // namespace hawser::HAWSER_ISA
