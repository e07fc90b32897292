// SPDX-License-Identifier: Apache-2.0
#include <hawser/version.h>
#include <hawser/world.h>

namespace hawser {

const char* version() noexcept { return HAWSER_VERSION; }

}  // namespace hawser
