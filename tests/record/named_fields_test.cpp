// SPDX-License-Identifier: Apache-2.0
// Fields that a table has beyond those of the first format: recorded by name, if not the default.
#include "record/field_bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace hawser;
using namespace hawser::record;

enum class Colour : std::uint8_t { red, green, blue };

struct Thing {
    Colour colour = Colour::red;
    double mass = 1.0;
    Vec3 point{0.0, 0.0, 0.0};
    double time = std::numeric_limits<double>::quiet_NaN();  // NaN: not given
    bool open = true;
};

constexpr auto kRows = std::to_array<FieldInfo<Thing>>({{"mass", &Thing::mass},
                                                        {"point", &Thing::point},
                                                        {"time", &Thing::time},
                                                        {"open", &Thing::open}});
constexpr std::size_t kFirstNamed = 2;

std::vector<std::byte> bytes_of(const Thing& thing, std::span<const FieldInfo<Thing>> rows) {
    ByteWriter out;
    PutFields{out}.table(thing, thing.colour, 3, rows, kFirstNamed);
    return {out.bytes().begin(), out.bytes().end()};
}

Thing read(std::span<const std::byte> bytes, std::span<const FieldInfo<Thing>> rows) {
    ByteReader in(bytes);
    Thing out;
    GetFields{in}.table(out, out.colour, 3, rows, kFirstNamed);
    EXPECT_EQ(0U, in.bytes_left());
    return out;
}

TEST(NamedFields, AreReadAsWritten) {
    const Thing thing{Colour::blue, 2.5, {1.0, 2.0, 3.0}, 0.25, false};
    const Thing back = read(bytes_of(thing, kRows), kRows);
    EXPECT_EQ(Colour::blue, back.colour);
    EXPECT_EQ(2.5, back.mass);
    EXPECT_EQ(Vec3(1.0, 2.0, 3.0), back.point);
    EXPECT_EQ(0.25, back.time);
    EXPECT_FALSE(back.open);
}

// A recording without the new fields is the same in both versions.
TEST(NamedFields, DefaultsTakeNoBytes) {
    const std::span<const FieldInfo<Thing>> all = kRows, before = all.first(kFirstNamed);
    const Thing thing{.colour = Colour::green, .mass = 7.0};
    EXPECT_EQ(bytes_of(thing, before), bytes_of(thing, all));
    EXPECT_EQ(1U + 4U * sizeof(double), bytes_of(thing, all).size());
    const Thing back = read(bytes_of(thing, before), all);
    EXPECT_EQ(7.0, back.mass);
    EXPECT_TRUE(std::isnan(back.time));
    EXPECT_TRUE(back.open);
}

TEST(NamedFields, UnknownNamesAndKindsAreRejected) {
    const std::span<const FieldInfo<Thing>> all = kRows;
    const Thing thing{.time = 3.0};
    try {
        (void)read(bytes_of(thing, all), all.first(kFirstNamed));
        FAIL() << "an older version reads a newer field";
    } catch (const BadBytes& error) {
        EXPECT_NE(std::string::npos, std::string(error.what()).find("\"time\"")) << error.what();
    }
    std::vector<std::byte> forged = bytes_of(thing, all);
    forged[0] = std::byte{0x83};  // kind 3 of 3
    EXPECT_THROW((void)read(forged, all), BadBytes);
    forged = bytes_of(thing, all);
    forged.resize(forged.size() - 1);
    EXPECT_THROW((void)read(forged, all), BadBytes);
}

}  // namespace
