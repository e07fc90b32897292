// SPDX-License-Identifier: Apache-2.0
// Tables of definitions (hawser/fields.h): keys, defaults and ranges of scenes and worlds.
#include "scene/anchors.h"
#include "scene/cranes.h"
#include "scene/deck_fields.h"
#include "scene/field_reader.h"
#include "scene/line_types.h"
#include "scene/resolutions.h"
#include "scene/sea_fields.h"
#include "scene/vessel_control.h"
#include "scene/winches.h"

#include <hawser/body_fields.h>
#include <hawser/hawser.h>
#include <hawser/material_fields.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <variant>

namespace {

using namespace hawser;
using namespace hawser::scene;

int checked = 0;  // Defaults compared with their words.

/// Compare the default that documents print with the member's initial value. Words such as "two
/// steps" are not compared. Printed values of angles have three digits.
template <class Def>
void check_default(const FieldInfo<Def>& row) {
    std::visit(
        [&]<class T>(T Def::* member) {
            const Def usual{};
            const std::string words = row.fallback;
            if constexpr (std::is_same_v<T, bool>) {
                if (words != "true" && words != "false") return;
                EXPECT_EQ(words == "true", usual.*member) << row.key;
                ++checked;
            } else if constexpr (std::is_arithmetic_v<T>) {
                char* end = nullptr;
                double printed = std::strtod(words.c_str(), &end);
                if (words.empty() || *end != '\0') return;
                if (row.degrees()) printed *= std::numbers::pi / 180.0;
                EXPECT_NEAR(printed, static_cast<double>(usual.*member),
                            (row.degrees() ? 1e-3 : 1e-12) * std::abs(printed))
                    << row.key;
                ++checked;
            }
        },
        row.member);
}

template <class Def>
void check_table(std::span<const FieldInfo<Def>> rows, const char* table) {
    std::set<std::string> keys;
    for (const FieldInfo<Def>& row : rows) {
        SCOPED_TRACE(table);
        EXPECT_TRUE(keys.insert(row.key).second) << row.key << " stands twice";
        EXPECT_STRNE("", row.doc) << row.key;
        EXPECT_LE(row.least, row.most) << row.key;
        if (row.degrees()) {
            EXPECT_TRUE(std::string(row.unit).starts_with("deg")) << row.key;
        }
        check_default(row);
    }
}
#define CHECK_TABLE(Def, rows) check_table<Def>(rows, #rows)

TEST(FieldTable, PrintedDefaultsAreThoseOfTheDefinitions) {
    checked = 0;
    CHECK_TABLE(BodyDef, kBodyFields);
    CHECK_TABLE(MaterialDef, kMaterialFields);
    CHECK_TABLE(CableSection, kSectionFields);
    CHECK_TABLE(LayoutSection, kLayoutFields);
    CHECK_TABLE(WinchDef, winch_fields());
    CHECK_TABLE(GypsyDef, gypsy_fields());
    CHECK_TABLE(ResolutionDef, resolution_fields());
    CHECK_TABLE(WaveDef, kWaveFields);
    CHECK_TABLE(WindDef, kWindFields);
    CHECK_TABLE(LineWater, kLineWaterFields);
    CHECK_TABLE(StopperDef, kStopperFields);
    CHECK_TABLE(PinDef, kPinFields);
    CHECK_TABLE(HookDef, kHookFields);
    CHECK_TABLE(ChaserDef, kChaserFields);
    CHECK_TABLE(VesselControl, ControlTable::kNumbers);
    CHECK_TABLE(CraneSlew, CraneTable<CraneSlew>::kNumbers);
    CHECK_TABLE(CraneTackle, CraneTable<CraneTackle>::kNumbers);
    CHECK_TABLE(CraneRating, CraneTable<CraneRating>::kNumbers);
    CHECK_TABLE(LatticeCraneDef, CraneTable<LatticeCraneDef>::kNumbers);
    CHECK_TABLE(AnchorDef, VesselTable<AnchorDef>::kNumbers);
    CHECK_TABLE(AnchorClay, VesselTable<AnchorClay>::kNumbers);
    CHECK_TABLE(StabilityDef, VesselTable<StabilityDef>::kNumbers);
    CHECK_TABLE(HullResistance, VesselTable<HullResistance>::kNumbers);
    CHECK_TABLE(MmgStern, VesselTable<MmgStern>::kNumbers);
    CHECK_TABLE(SteeringDef, VesselTable<SteeringDef>::kNumbers);
    EXPECT_GE(checked, 100);
}

BodyDef ball() {
    BodyDef def;
    def.mass = 2.0;
    def.inertia = Mat3::Identity();
    return def;
}

// Every number of the table is checked by the world: beyond `most` and below `least`.
TEST(FieldTable, WorldsRejectNumbersOutsideTheTable) {
    for (const FieldInfo<BodyDef>& row : kBodyFields) {
        const auto rejected = [&](double value) {
            BodyDef def = ball();
            std::visit(
                [&]<class T>(T BodyDef::* member) {
                    if constexpr (std::is_same_v<T, double>)
                        def.*member = value;
                    else if constexpr (std::is_same_v<T, Vec3>)
                        (def.*member)[1] = value;
                },
                row.member);
            try {
                World().add_body(def);
            } catch (const DefError& error) {
                return std::string(error.what());
            }
            return std::string();
        };
        if (!std::holds_alternative<double BodyDef::*>(row.member) &&
            !std::holds_alternative<Vec3 BodyDef::*>(row.member))
            continue;
        for (const double bad : {2.0 * row.most, std::nan("")})
            if (std::isnan(bad) || std::isfinite(bad)) {
                EXPECT_NE(std::string::npos, rejected(bad).find(row.key)) << row.key;
            }
        if (row.least == 0.0) {
            EXPECT_NE(std::string::npos, rejected(-1.0).find(row.key)) << row.key;
        }
        EXPECT_EQ("", rejected(0.5)) << row.key;
    }
    MaterialDef steel{.name = "steel"};
    for (const FieldInfo<MaterialDef>& row : kMaterialFields) {
        MaterialDef def = steel;
        def.*std::get<double MaterialDef::*>(row.member) = 2.0 * row.most;
        try {
            World().add_material(def);
            ADD_FAILURE() << row.key;
        } catch (const DefError& error) {
            EXPECT_NE(std::string::npos, std::string(error.what()).find(row.key));
        }
    }
}

// A key of one number per axis accepts one number for all axes.
TEST(FieldTable, ReadsNumbersPerAxisAngleAndFlag) {
    BodyDef def;
    read_fields(def, Json::parse(R"({"linear_damping": 3, "gravity": false, "mass": 5,
                                     "angular_damping": [1, 2, 3], "position": [9, 9, 9]})"),
                kBodyFields);
    EXPECT_EQ(Vec3(3.0, 3.0, 3.0), def.linear_damping);
    EXPECT_EQ(Vec3(1.0, 2.0, 3.0), def.angular_damping);
    EXPECT_EQ(5.0, def.mass);
    EXPECT_FALSE(def.gravity);
    EXPECT_TRUE(def.position.isZero(0.0)) << "read by its own reader";
    CraneSlew slew;
    read_fields(slew, Json::parse(R"({"angle_deg": 90})"), CraneTable<CraneSlew>::kNumbers);
    EXPECT_DOUBLE_EQ(0.5 * std::numbers::pi, slew.angle);
    WaveDef wave;
    read_fields(wave, Json::parse(R"({"height": 2, "components": 7, "seed": 2147483647})"),
                kWaveFields);
    EXPECT_EQ(7, wave.components);
    EXPECT_EQ(2147483647U, wave.seed);
}

}  // namespace
