// SPDX-License-Identifier: Apache-2.0
#include <hawser/version.h>

#include <cstdio>

int main() {
    std::printf("hawser %s\n", HAWSER_VERSION);
    return 0;
}
