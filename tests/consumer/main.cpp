// SPDX-License-Identifier: Apache-2.0
#include <hawser/hawser.h>
#include <hawser/version.h>

#include <cstdio>
#include <cstring>

int main() {
    std::printf("hawser %s\n", hawser::version());
    return std::strcmp(hawser::version(), HAWSER_VERSION) == 0 ? 0 : 1;
}
