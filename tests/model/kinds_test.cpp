// SPDX-License-Identifier: Apache-2.0
/// Every kind of interaction: its Jacobian is the derivative of its violation, it has no net force
/// or moment, and it starts without violation.
#define HAWSER_KIND_SETUP
#include "model/kinds/all.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace hawser::test {
namespace {

constexpr int kSlots = kMaxInteractionBodies, kRows = kMaxInteractionRows;

/// Poses of the bodies of one interaction.
struct Poses {
    Vec3 x[kSlots];
    Quat q[kSlots];
    BodyKind kind[kSlots];
};

struct Evaluated {
    double g[kRows];
    double j[kSlots][kRows][6];
};

Evaluated evaluate(const InteractionDef& def, const Poses& poses) {
    Evaluated out{};
    generic::with_kind(def.kind, [&]<class K>() {
        const typename K::Data data = K::make(def);
        double r[kSlots][9];
        generic::BodyRef refs[K::kBodies];
        for (int b = 0; b < K::kBodies; ++b) {
            const Mat3 m = poses.q[b].toRotationMatrix();
            for (int i = 0; i < 9; ++i) r[b][i] = m(i / 3, i % 3);
            refs[b] = {{poses.x[b].x(), poses.x[b].y(), poses.x[b].z()},
                       r[b],
                       poses.kind[b] == BodyKind::rigid};
        }
        generic::Rows<K::kBodies, K::kRows> rows;
        K::evaluate(data, refs, rows);
        for (int k = 0; k < K::kRows; ++k) {
            out.g[k] = rows.g[k];
            for (int b = 0; b < K::kBodies; ++b)
                std::memcpy(out.j[b][k], rows.J[b][k], sizeof out.j[b][k]);
        }
    });
    return out;
}

/// Move one coordinate of one body: 0-2 along, 3-5 about a world axis.
Poses moved(Poses p, int body, int axis, double by) {
    if (axis < 3)
        p.x[body][axis] += by;
    else
        p.q[body] = Quat(Eigen::AngleAxisd(by, Vec3::Unit(axis - 3))) * p.q[body];
    return p;
}

int freedoms(BodyKind kind) { return model::dof_of(kind); }

/// True if a segment of a bend is shorter than a tenth of its length: there its Jacobian is no
/// derivative, and it exerts a net moment (model/kinds/bends.h).
bool has_collapsed_segment(const Poses& p, const InteractionDef& d) {
    if (d.kind != InteractionKind::Bend) return false;
    Vec3 at[3];
    for (std::size_t b = 0; b < 3; ++b)
        at[b] = p.x[b] + (p.kind[b] == BodyKind::rigid ? Vec3(p.q[b] * d.point[b]) : Vec3::Zero());
    return std::min((at[1] - at[0]).norm(), (at[2] - at[1]).norm()) < 0.1 * d.get("length");
}

/// Draw random poses, frames and points, so that no value is special.
void draw(Random& random, const KindInfo& info, bool lumps, Poses& p, InteractionDef& d) {
    d = between(info.kind, {});
    for (int b = 0; b < info.bodies; ++b) {
        const auto s = static_cast<std::size_t>(b);
        p.kind[b] = info.takes_scalar(b)          ? BodyKind::scalar
                    : lumps && random.chance(0.7) ? BodyKind::lump
                                                  : BodyKind::rigid;
        p.x[b] = p.kind[b] == BodyKind::scalar ? Vec3(random.uniform(-1, 1), 0, 0)
                                               : Vec3(random.vector(2.0));
        p.q[b] = p.kind[b] == BodyKind::rigid ? random.rotation() : Quat::Identity();
        d.point[s] = random.vector(0.5);
        d.frame[s] = random.rotation();
    }
    for (std::size_t i = 0; i < info.params.size(); ++i)
        d.params[i] = std::isnan(info.params[i].fallback) ? 1.3 : info.params[i].fallback;
    // Far outside any range, on the slope of range rows.
    if (info.kind == InteractionKind::HingeRange || info.kind == InteractionKind::SlideRange)
        d.set("min", 40.0).set("max", 50.0);
    if (has_collapsed_segment(p, d)) draw(random, info, lumps, p, d);
}

/// Set poses near the joint's own configuration: frames aligned except for a small rotation. The
/// twist angle is singular if the axes are opposite.
void align(Random& random, Poses& p, InteractionDef& d) {
    const Quat small(Eigen::AngleAxisd(0.5, random.vector(1.0).normalized()));
    d.frame[1] = (p.q[1].conjugate() * (small * (p.q[0] * d.frame[0]))).normalized();
}

class EachKind : public testing::TestWithParam<int> {
  protected:
    const KindInfo& info() const {
        return interaction_kinds()[static_cast<std::size_t>(GetParam())];
    }
    /// Return the first seed of a test of this kind; `first` differs from test to test.
    static std::uint32_t kind_seed(int first) {
        return first_seed(static_cast<std::uint32_t>(GetParam() + first));
    }
    bool takes_lumps() const {
        return !info().uses_frames && info().kind != InteractionKind::Hydrostatic;
    }
};
INSTANTIATE_TEST_SUITE_P(Kinds, EachKind, testing::Range(0, kInteractionKindCount),
                         [](const auto& i) {
                             return std::string(
                                 interaction_kinds()[static_cast<std::size_t>(i.param)].name);
                         });

TEST_P(EachKind, JacobianIsTheDerivativeOfTheViolation) {
    // Central differences of fourth order. Rows steeper than 30 are near a singular pose and left
    // out. At 30, rounding of the angle of about 2⁻⁵³·30² gives an error of 2⁻⁵³·30²·2/d ≈ 2e-9.
    constexpr double kStep = 1e-4, kTolerance = 2e-8, kSteepest = 30.0;
    int compared = 0, rows = 0;
    Random random(kind_seed(1));
    const int trials = by_tier(60, 200, 2000);
    for (int trial = 0; trial < trials; ++trial) {
        Poses p;
        InteractionDef d;
        draw(random, info(), takes_lumps() && trial % 2 == 1, p, d);
        if (info().uses_frames && trial % 3 != 0) align(random, p, d);
        const Evaluated at = evaluate(d, p);
        for (int b = 0; b < info().bodies; ++b) {
            const int dof = freedoms(p.kind[b]);
            for (int axis = 0; axis < dof; ++axis) {
                const Evaluated plus = evaluate(d, moved(p, b, axis, kStep));
                const Evaluated minus = evaluate(d, moved(p, b, axis, -kStep));
                const Evaluated plus_two = evaluate(d, moved(p, b, axis, 2.0 * kStep));
                const Evaluated minus_two = evaluate(d, moved(p, b, axis, -2.0 * kStep));
                const auto slope_of = [&](int r, auto&& value) {
                    return (8.0 * (value(plus.g[r]) - value(minus.g[r])) -
                            (value(plus_two.g[r]) - value(minus_two.g[r]))) /
                           (12.0 * kStep);
                };
                if (info().kind == InteractionKind::Bend) {
                    // The two rows have their own rotating basis about the wire, so only their
                    // length is the bend. The energy contains half its square.
                    double slope = 0.0, want = 0.0;
                    for (int r = 0; r < 2; ++r) {
                        slope += slope_of(r, [](double g) { return 0.5 * g * g; });
                        want += at.g[r] * at.j[b][r][axis];
                    }
                    EXPECT_NEAR(slope, want, kTolerance * 10) << "slot " << b << " axis " << axis;
                    continue;
                }
                for (int r = 0; r < info().rows; ++r) {
                    if (info().row_units[r] == 'v') continue;  // has no violation
                    ++rows;
                    double steepest = 0.0;
                    for (int c = 0; c < info().bodies; ++c)
                        for (int k = 0; k < freedoms(p.kind[c]); ++k)
                            steepest = std::max(steepest, std::abs(at.j[c][r][k]));
                    // Angles jump at the end of a revolution.
                    const bool jumps = std::abs(plus_two.g[r] - minus_two.g[r]) > 0.1;
                    if (jumps || steepest > kSteepest) continue;
                    ++compared;
                    const double slope = slope_of(r, [](double g) { return g; });
                    EXPECT_NEAR(slope, at.j[b][r][axis], kTolerance * (1 + std::abs(slope)))
                        << "row " << r << " slot " << b << " axis " << axis << " trial " << trial;
                }
            }
        }
    }
    EXPECT_GE(compared, rows * 9 / 10);
}

/// Velocity rows: their Jacobian is that of the coordinate used by the range of the same joint, at
/// the joint's own configuration.
TEST(Motors, DriveTheCoordinateThatTheRangeMeasures) {
    const std::pair<InteractionKind, InteractionKind> pairs[] = {
        {InteractionKind::HingeMotor, InteractionKind::HingeRange},
        {InteractionKind::SlideMotor, InteractionKind::SlideRange}};
    Random random(first_seed(5));
    const int trials = by_tier(20, 100, 1000);
    for (const auto& [motor, range] : pairs)
        for (int trial = 0; trial < trials; ++trial) {
            Poses p;
            InteractionDef d;
            draw(random, kind_info(range), false, p, d);
            // Parallel axes, any rotation about them.
            const Quat turn(Eigen::AngleAxisd(random.uniform(-3, 3), Vec3::UnitZ()));
            d.frame[1] = p.q[1].conjugate() * (p.q[0] * d.frame[0]) * turn;
            const Evaluated want = evaluate(d, p);
            InteractionDef m = d;
            m.kind = motor;
            m.params[0] = 0.7;
            const Evaluated got = evaluate(m, p);
            EXPECT_EQ(got.g[0], 0.7);
            for (int b = 0; b < 2; ++b)
                for (int i = 0; i < 6; ++i)
                    EXPECT_NEAR(got.j[b][0][i], want.j[b][0][i], 1e-12) << b << " " << i;
        }
}

TEST_P(EachKind, ActsWithoutNetForceOrMoment) {
    // Kinds with one body act against the world; scalar bodies have no position.
    const bool world = info().bodies == 1;
    if (world) GTEST_SKIP() << "acts against the world";
    Random random(kind_seed(100));
    const int trials = by_tier(60, 200, 2000);
    for (int trial = 0; trial < trials; ++trial) {
        Poses p;
        InteractionDef d;
        draw(random, info(), takes_lumps() && trial % 2 == 1, p, d);
        // A shared point pulls both bodies at that point. With a gap the pair of forces has the
        // moment gap × force, which vanishes with the gap.
        if (std::string(info().row_units).starts_with("mmm")) {
            const Vec3 arm0 =
                p.kind[0] == BodyKind::rigid ? Vec3(p.q[0] * d.point[0]) : Vec3::Zero();
            const Vec3 arm1 =
                p.kind[1] == BodyKind::rigid ? Vec3(p.q[1] * d.point[1]) : Vec3::Zero();
            p.x[1] = p.x[0] + arm0 - arm1;
        }
        const Evaluated at = evaluate(d, p);
        Vec3 elastic = Vec3::Zero();
        for (int r = 0; r < info().rows; ++r) {
            Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
            for (int b = 0; b < info().bodies; ++b) {
                if (p.kind[b] == BodyKind::scalar) continue;
                const double* j = at.j[b][r];
                const Vec3 lin(j[0], j[1], j[2]);
                force += lin;
                moment += p.x[b].cross(lin);
                if (p.kind[b] == BodyKind::rigid) moment += Vec3(j[3], j[4], j[5]);
            }
            // Entries are of the order 1 to 10: rounding.
            EXPECT_LE(force.norm(), 1e-13) << "row " << r;
            if (info().kind == InteractionKind::Bend) {
                elastic += at.g[r] * moment;
            } else {
                EXPECT_LE(moment.norm(), 1e-12) << "row " << r;
            }
        }
        // One row of a bend alone twists a bent wire about its tangent; the elastic force, along
        // the bend, does not.
        EXPECT_LE(elastic.norm(), 1e-12);
    }
}

TEST_P(EachKind, StartsWithoutViolation) {
    Random random(kind_seed(200));
    const int trials = by_tier(10, 50, 500);
    const std::string name = info().name;
    for (int trial = 0; trial < trials; ++trial) {
        Recipe r;
        std::vector<BodyId> ids;
        for (int b = 0; b < info().bodies; ++b) {
            if (info().takes_scalar(b))
                ids.push_back(r.scalar(name == "winch_stretch" ? 0.0 : 0.4, 1.0));
            else
                ids.push_back(r.rigid(Vec3(2.0 * b, 0, 0), random.rotation(), 1.0, {1, 2, 2.5}));
        }
        InteractionDef d = r.at(info().kind, ids, random.vector(1.0), random.rotation());
        if (name == "universal")
            d.frame[1] = d.frame[1] * Quat(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitY()));
        if (name == "distance" || name.ends_with("stretch") || name.ends_with("span"))
            for (auto& point : d.point) point = random.vector(0.3);
        if (name == "bend")
            for (auto& point : d.point) point.setZero();  // centres on a line
        if (name == "hydrostatic") r.bodies[0].orientation = Quat::Identity();
        for (std::size_t i = 0; i < info().params.size(); ++i) {
            const std::string param = info().params[i].name;
            const bool pose = param == "length" && info().length_from_pose;
            if (std::isnan(info().params[i].fallback) && !pose && param != "rest_height" &&
                param != "target")
                d.params[i] = 1.0;
        }
        if (name.ends_with("range")) d.set("min", -1.0);
        // Its length is the one with the slides at 0.
        if (name == "end_span")
            d.set("radius", 0.0);
        else if (name.ends_with("span"))
            d.set("slide_0", 0.0).set("slide_1", 0.0);
        r.add(d);
        World w = r.make();
        const auto g = w.violation(InteractionId{0});
        for (int k = 0; k < info().rows; ++k)
            EXPECT_NEAR(g[static_cast<std::size_t>(k)], 0.0, 1e-14) << "row " << k;
    }
}

TEST_P(EachKind, TableIsConsistent) {
    const KindInfo& i = info();
    EXPECT_EQ(static_cast<int>(i.kind), GetParam());
    EXPECT_EQ(find_kind(i.name), &i);
    EXPECT_EQ(&kind_info(i.kind), &i);
    EXPECT_GE(i.bodies, 1);
    EXPECT_LE(i.bodies, kMaxInteractionBodies);
    EXPECT_GE(i.rows, 1);
    EXPECT_LE(i.rows, kMaxInteractionRows);
    EXPECT_LT(i.scalar_slot, i.bodies);
    EXPECT_LE(i.params.size(), static_cast<std::size_t>(kMaxInteractionParams));
    EXPECT_GT(std::strlen(i.doc), 10U);
    EXPECT_EQ(std::strlen(i.row_units), static_cast<std::size_t>(i.rows));
    for (const char* u = i.row_units; *u != 0; ++u) EXPECT_NE(std::strchr("mrv", *u), nullptr);
    for (const ParamInfo& p : i.params) {
        EXPECT_GT(std::strlen(p.doc), 3U) << p.name;
        EXPECT_GT(std::strlen(p.unit), 0U) << p.name;
        EXPECT_LE(p.min, p.max) << p.name;
        if (!std::isnan(p.fallback)) {
            EXPECT_GE(p.fallback, p.min) << p.name;
            EXPECT_LE(p.fallback, p.max) << p.name;
        }
        InteractionDef d = between(i.kind, {});
        d.set(p.name, 3.5);
        EXPECT_EQ(d.get(p.name), 3.5);
    }
    InteractionDef d = between(i.kind, {});
    EXPECT_THROW(d.set("no such parameter", 1.0), DefError);
    EXPECT_THROW((void)d.get("no such parameter"), DefError);
}

TEST(Kinds, UnknownNamesFindNothing) {
    EXPECT_EQ(find_kind("no such kind"), nullptr);
    EXPECT_EQ(find_kind(""), nullptr);
}

}  // namespace
}  // namespace hawser::test
