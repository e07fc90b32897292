// SPDX-License-Identifier: Apache-2.0
#include "runner.h"

namespace hawser::bench {

std::unique_ptr<Runner> make_ours(const Scene& /*scene*/) {
    return nullptr;
}

}  // namespace hawser::bench
