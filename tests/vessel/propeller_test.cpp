// SPDX-License-Identifier: Apache-2.0
/// Propeller series against tables computed independently from the published coefficients, and
/// against tests of another program.
#include <hawser/vessel_propeller.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hawser::test {
namespace {

// Half a unit of the last printed digit.
constexpr double kFive = 0.51e-5, kSix = 0.51e-6;

struct BRow {
    double area, pitch, blades, advance, thrust, torque;
};

TEST(Propeller, WageningenBMeetsTheTable) {
    constexpr BRow kRows[] = {
        {0.70, 1.0, 4, 0.0, 0.45474, 0.067538}, {0.70, 1.0, 4, 0.2, 0.39193, 0.059423},
        {0.70, 1.0, 4, 0.4, 0.31425, 0.049210}, {0.70, 1.0, 4, 0.6, 0.22555, 0.037270},
        {0.70, 1.0, 4, 0.8, 0.12973, 0.023973}, {0.70, 1.0, 4, 1.0, 0.03067, 0.009692},
        {0.55, 0.8, 4, 0.0, 0.33855, 0.040295}, {0.55, 0.8, 4, 0.6, 0.12863, 0.019251},
        {0.70, 1.2, 4, 0.0, 0.54555, 0.096312}, {0.70, 1.2, 4, 0.6, 0.32514, 0.061238},
        {0.70, 1.2, 4, 1.0, 0.13291, 0.029198}, {0.65, 1.4, 4, 0.0, 0.60380, 0.123436},
        {0.55, 1.0, 3, 0.0, 0.41802, 0.062351}};
    for (const BRow& r : kRows) {
        const PropellerPoint k = wageningen_b(r.advance, r.pitch, r.area, r.blades);
        EXPECT_NEAR(k.thrust, r.thrust, kFive) << r.area << " " << r.pitch << " " << r.advance;
        EXPECT_NEAR(k.torque, r.torque, kSix) << r.area << " " << r.pitch << " " << r.advance;
    }
    const PropellerPoint at = wageningen_b(0.6, 1.0, 0.70, 4);
    EXPECT_NEAR(0.6 * at.thrust / (2.0 * std::numbers::pi * at.torque), 0.5779, 0.6e-4);
    const PropellerPoint best = wageningen_b(0.8, 1.0, 0.70, 4);
    EXPECT_NEAR(0.8 * best.thrust / (2.0 * std::numbers::pi * best.torque), 0.6890, 0.6e-4);
}

// Tests of the simulator xdyn, which has its own coefficients; its tolerance.
TEST(Propeller, WageningenBMeetsXdyn) {
    constexpr double kClose = 1e-2;
    EXPECT_NEAR(wageningen_b(0.0, 1.4, 0.65, 6).thrust, 0.603363, kClose);
    EXPECT_NEAR(wageningen_b(0.3, 1.4, 0.65, 6).thrust, 0.544592, kClose);
    EXPECT_NEAR(wageningen_b(1.2, 1.4, 0.65, 6).thrust, 0.161314, kClose);
    EXPECT_NEAR(10.0 * wageningen_b(0.0, 1.4, 0.65, 6).torque, 1.209494, kClose);
    EXPECT_NEAR(wageningen_b(0.0, 0.7, 0.30, 2).thrust, 0.242746, kClose);
    EXPECT_NEAR(wageningen_b(0.6, 0.7, 0.30, 2).thrust, 0.070951, kClose);
    EXPECT_NEAR(wageningen_b(0.0, 0.5, 0.40, 3).thrust, 0.188196, kClose);
    EXPECT_NEAR(wageningen_b(0.3, 0.5, 0.40, 3).thrust, 0.104372, kClose);
}

struct DuctRow {
    double pitch, advance, thrust, nozzle, torque;
};

TEST(Propeller, Ka470MeetsTheTable) {
    constexpr DuctRow kRows[] = {
        {1.0, 0.0, 0.52568, 0.26882, 0.044244}, {1.0, 0.2, 0.41424, 0.16601, 0.042794},
        {1.0, 0.4, 0.30682, 0.08697, 0.038442}, {1.0, 0.6, 0.18467, 0.01988, 0.030768},
        {1.2, 0.0, 0.69385, 0.36021, 0.066829}, {1.2, 0.4, 0.44672, 0.14309, 0.060629},
        {1.2, 0.6, 0.32549, 0.06643, 0.052660}, {1.4, 0.0, 0.86574, 0.44657, 0.093296},
        {0.8, 0.0, 0.36952, 0.18212, 0.027126}};
    for (const DuctRow& r : kRows) {
        const PropellerPoint k = ka4_70(r.advance, r.pitch);
        EXPECT_NEAR(k.thrust, r.thrust, kFive) << r.pitch << " " << r.advance;
        EXPECT_NEAR(k.nozzle, r.nozzle, kFive) << r.pitch << " " << r.advance;
        EXPECT_NEAR(k.torque, r.torque, kSix) << r.pitch << " " << r.advance;
    }
}

// Pull that a classification society expects of a ducted propeller: 1250 N (kW m)^(-2/3).
TEST(Propeller, DuctedPullAtRestMeetsTheRule) {
    for (const PropellerSeries series : {PropellerSeries::ka4_70, PropellerSeries::ka5_75}) {
        const PropellerDef p{.series = series, .diameter = 4.0, .pitch = 1.2};
        const double rule = 1250.0 * std::pow(5000.0 * 4.0, 2.0 / 3.0);
        // Series of different nozzles and pitches are within 5 % of the rule of thumb.
        EXPECT_NEAR(at_power(p, 5e6, 0.0, 1025.0).thrust / rule, 1.0, 0.05) << to_string(series);
    }
}

TEST(Propeller, Ka470PullAtConstantPower) {
    constexpr double kPull[2][8] = {{919.2, 824.0, 744.6, 676.1, 614.2, 555.1, 495.8, 433.9},
                                    {916.8, 824.3, 745.0, 674.4, 608.5, 544.0, 478.3, 409.2}};
    constexpr double kPitch[] = {1.2, 1.0}, kRps[] = {2.2470, 2.5781};
    for (int i = 0; i < 2; ++i) {
        const PropellerDef p{
            .series = PropellerSeries::ka4_70, .diameter = 4.0, .pitch = kPitch[i]};
        EXPECT_NEAR(at_power(p, 5e6, 0.0, 1025.0).rps, kRps[i], 0.51e-4);
        for (int v = 0; v < 8; ++v) {
            const PowerPoint at = at_power(p, 5e6, v, 1025.0);
            EXPECT_NEAR(at.thrust * 1e-3, kPull[i][v], 0.051) << kPitch[i] << " " << v;
            EXPECT_NEAR(2.0 * std::numbers::pi * at.rps * at.torque, 5e6, 1.0);
        }
    }
}

struct QuadrantRow {
    double degrees, thrust, torque;
};

TEST(Propeller, FourQuadrantsMeetTheTable) {
    constexpr QuadrantRow kRows[] = {
        {0, 0.23436, 0.035068},     {10, 0.15586, 0.025043},    {20, 0.05772, 0.011369},
        {30, -0.06076, -0.006791},  {45, -0.30202, -0.043792},  {90, -0.77011, -0.114879},
        {135, -0.56020, -0.082670}, {180, -0.18276, -0.033070}, {225, 0.34622, 0.051936},
        {270, 0.70806, 0.096258},   {315, 0.67865, 0.091614},   {350, 0.20819, 0.030887}};
    for (const QuadrantRow& r : kRows) {
        const QuadrantPoint c = four_quadrants_b4_70(r.degrees * std::numbers::pi / 180.0);
        EXPECT_NEAR(c.thrust, r.thrust, kFive) << r.degrees;
        EXPECT_NEAR(c.torque, r.torque, kSix) << r.degrees;
    }
    // Bollard pull as thrust coefficients: K = C (0.7 pi)^2 pi/8.
    const double scale = 0.49 * std::pow(std::numbers::pi, 3) / 8.0;
    EXPECT_NEAR(scale * four_quadrants_b4_70(0.0).thrust, 0.4451, 0.6e-4);
    EXPECT_NEAR(scale * four_quadrants_b4_70(0.0).torque, 0.06660, 0.6e-5);
}

TEST(Propeller, ForceIsContinuousAndOfTheRightSign) {
    for (const PropellerSeries series :
         {PropellerSeries::wageningen_b, PropellerSeries::ka4_70, PropellerSeries::ka5_75}) {
        const PropellerDef p{.series = series, .diameter = 3.0, .pitch = 1.0};
        // Along a circle of speeds and revolutions no difference exceeds that of a smooth curve.
        const double size = propeller_force(p, 1.0, 2.0, 0.0, 1025.0).thrust;
        double before = size;
        for (int i = 1; i <= 3600; ++i) {
            const double at = 2.0 * std::numbers::pi * i / 3600;
            const double t =
                propeller_force(p, 1.0, 2.0 * std::cos(at), 12.0 * std::sin(at), 1025.0).thrust;
            EXPECT_LT(std::abs(t - before), 0.02 * size) << to_string(series) << " " << i;
            before = t;
        }
        // It pushes ahead, pulls in reverse, and brakes if dragged without rotation.
        EXPECT_GT(propeller_force(p, 1.0, 2.0, 3.0, 1025.0).thrust, 0.0);
        EXPECT_LT(propeller_force(p, 1.0, -2.0, 3.0, 1025.0).thrust, 0.0);
        EXPECT_LT(propeller_force(p, 1.0, 0.0, 3.0, 1025.0).thrust, 0.0);
        // Negative pitch mirrors; zero pitch has no thrust but some torque.
        EXPECT_EQ(propeller_force(p, -1.0, 2.0, -3.0, 1025.0).thrust,
                  -propeller_force(p, 1.0, 2.0, 3.0, 1025.0).thrust);
        EXPECT_EQ(propeller_force(p, 0.0, 2.0, 3.0, 1025.0).thrust, 0.0);
        EXPECT_GT(propeller_force(p, 0.0, 2.0, 0.0, 1025.0).torque, 0.0);
    }
}

}  // namespace
}  // namespace hawser::test
