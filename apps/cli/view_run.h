// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view_run.h
/// `hawser view`: a session, an exercise or a recording, a server, and the addresses of its roles.

#include "scene_options.h"

#include <cstdint>
#include <string>

namespace hawser::cli {

struct ViewOptions {
    SceneOptions scene;  ///< Its file may be a recording or an exercise.
    std::string listen = "127.0.0.1", record, restore;
    std::string report, summary;  ///< Of an exercise.
    int port = 8080, clients = 16;
    std::int32_t stride = 1;
    bool rt = false, paused = false, open = false;
};

/// Until a signal. @return the exit code. @throws std::exception
int view(const ViewOptions& options);

}  // namespace hawser::cli
