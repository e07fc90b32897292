// SPDX-License-Identifier: Apache-2.0
#include "record/snapshot_file.h"

#include "base/file_kind.h"
#include "record/bytes.h"
#include "record/field_bytes.h"
#include "record/files.h"
#include "record/scene_difference.h"

#include <fmt/format.h>

#include <cstring>
#include <string>
#include <vector>

namespace hawser::record {

namespace {

constexpr char kSnapshotMagic[8] = {'H', 'A', 'W', 'S', 'E', 'R', 'S', 'T'};
/// Version 5 has a structure before the state. Both versions contain the scene.
constexpr std::uint32_t kVersion = 4, kVersionWithStructure = 5;

std::uint32_t file_checksum(std::span<const std::byte> file) {
    std::uint32_t sum = 0;
    std::memcpy(&sum, file.last(sizeof sum).data(), sizeof sum);
    return sum;
}

/// Compare two scenes. A text that is not JSON belongs to a world without a scene.
SceneDifferences differences(const std::string& before, const std::string& now) {
    if (before.empty() || now.empty() || before == now)
        return {{}, "a world that no scene file made"};
    return compare_scenes(before, now);
}

/// Restore a saved state in a scene whose numbers differ. Such numbers may change the objects of
/// the scene, such as the elements of a cable.
void restore_variant_state(World& world, std::span<const std::byte> state,
                           const std::vector<std::string>& numbers) {
    try {
        world.state().restore_variant(state);
    } catch (const DefError& e) {
        throw BadBytes(fmt::format(
            "{}; the scenes differ in {}{}", e.what(), numbers.front(),
            numbers.size() == 1 ? "" : fmt::format(" and {} more numbers", numbers.size() - 1)));
    }
}

}  // namespace

void save_snapshot(const std::filesystem::path& file, const SceneInfo& scene, const World& world,
                   bool with_structure) {
    ByteWriter out;
    out.write_bytes(std::as_bytes(std::span(kSnapshotMagic)));
    out.put(with_structure ? kVersionWithStructure : kVersion);
    out.put(scene.hash);
    out.put_text(scene.name);
    out.put_text(scene.text);
    out.put(world.time());
    out.put(world.state().hash());
    if (with_structure) {
        PutFields put{out};
        put(world.state().structure());
    }
    out.write_bytes(world.state().save());
    out.put(crc32(out.bytes()));
    if (const std::string fault = write_file(file, out.bytes()); !fault.empty())
        throw SnapshotError(fmt::format("{}: cannot write the snapshot: {}", file.string(), fault));
}

std::vector<std::string> restore_snapshot(const std::filesystem::path& file, const SceneInfo& scene,
                                          World& world) {
    std::vector<std::byte> bytes;
    if (const std::string fault = read_file(file, bytes); !fault.empty())
        throw SnapshotError(fmt::format("{}: the snapshot: {}", file.string(), fault));
    try {
        ByteReader in(bytes);
        if (std::memcmp(in.take(sizeof kSnapshotMagic).data(), kSnapshotMagic,
                        sizeof kSnapshotMagic) != 0)
            throw BadBytes(base::file_kind_error_or(as_text(bytes), "a saved state", file.string(),
                                                    "not a Hawser snapshot"));
        const auto version = in.get<std::uint32_t>();
        if (version != kVersion && version != kVersionWithStructure)
            throw BadBytes(fmt::format("snapshot format {}, this program reads {} and {}", version,
                                       kVersion, kVersionWithStructure));
        const auto hash = in.get<std::uint64_t>();
        const std::string name = in.get_text(), text = in.get_text();
        const double time = in.get<double>();
        const auto state_hash = in.get<std::uint64_t>();
        if (in.bytes_left() < 4 ||
            file_checksum(bytes) != crc32(std::span(bytes).first(bytes.size() - 4)))
            throw BadBytes("the checksum does not match");
        if (hash != scene.hash) {
            SceneDifferences found = differences(text, scene.text);
            if (found.structure.empty() && version == kVersionWithStructure)
                found.structure = "the run had added or removed parts before that time";
            if (!found.structure.empty())
                throw BadBytes(fmt::format(
                    "saved at {:.6g} s from the scene \"{}\" with hash {:016x}; this is \"{}\" "
                    "with hash {:016x}, and more differs than numbers: {}; restore it with the "
                    "same scene file and the same --step, --form and --scale",
                    time, name, hash, scene.name, scene.hash, found.structure));
            if (!found.numbers.empty()) {
                restore_variant_state(world, in.take(in.bytes_left() - 4), found.numbers);
                return found.numbers;
            }
        }
        Structure made_of;
        GetFields get{in};
        if (version == kVersionWithStructure) get(made_of);
        const auto state = in.take(in.bytes_left() - 4);
        // If the state does not fit, the world stays unchanged.
        const std::vector<std::byte> before = world.state().save();
        const bool other = version == kVersionWithStructure;
        const Structure was = other ? world.state().structure() : Structure{};
        other ? world.state().restore(made_of, state) : world.state().restore(state);
        if (world.state().hash() != state_hash) {
            other ? world.state().restore(was, before) : world.state().restore(before);
            throw BadBytes(
                fmt::format("the restored state has another hash; it was saved with another "
                            "instruction set than {} or another version of Hawser",
                            instruction_set()));
        }
    } catch (const BadBytes& e) {
        throw SnapshotError(fmt::format("{}: {}", file.string(), e.what()));
    } catch (const DefError& e) {
        throw SnapshotError(fmt::format("{}: {}", file.string(), e.what()));
    }
    return {};
}

}  // namespace hawser::record
