#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Write schema/scene-1.json, schema/exercise-1.json and docs/scenes_reference.md from the source.
# usage: scripts/write_scene_documents.sh [BUILD_DIR]
set -eu
cd "$(dirname "$0")/.."
HAWSER_WRITE_GENERATED=1 "${1:-build/release}/bin/hawser_test_scene" --gtest_filter='Generated.*'
HAWSER_WRITE_GENERATED=1 "${1:-build/release}/bin/hawser_test_exercise" --gtest_filter='Exercises.Schema*'
