// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/compliance/wire/ArcSeries.h"
#include "haptics/compliance/wire/Beam.h"
#include "haptics/core/PoseMath.h"
#include "testing/haptics/compliance/wire/RandomBeams.h"

namespace palpate::test
{
namespace
{

using Twelve = Eigen::Matrix<double, 12, 1>;
using Square = Eigen::Matrix<double, 12, 12>;

struct TwoPoses
{
  Pose first, second;
};

TwoPoses moved(const TwoPoses& at, const Twelve& by)
{
  const auto one = [](const Pose& pose, const NodeVector& u) -> Pose {
    return { pose.p + u.head<3>(), turnBy(u.tail<3>()) * pose.q };
  };
  return { one(at.first, by.head<6>()), one(at.second, by.tail<6>()) };
}

BeamAnswer answerOf(const WireBeam& beam, const TwoPoses& at)
{
  BeamAnswer answer;
  bendBeam(beam, at.first, at.second, answer);
  return answer;
}

Twelve gradientOf(const BeamAnswer& answer)
{
  return (Twelve() << answer.gradient[0], answer.gradient[1]).finished();
}

Square tangentOf(const BeamAnswer& answer)
{
  return (Square() << answer.firstFirst, answer.firstSecond, answer.firstSecond.transpose(), answer.secondSecond)
    .finished();
}

/// Poses of a beam that is bent, stretched and twisted by as much as the argument.
TwoPoses bent(const Wire& wire, double far, Random& random)
{
  const WirePlaces places = bentAtRandom(wire, far, random);
  return { places[0], places[1] };
}

TEST(Beam, AnAngleByItsCosineIsThatOfTheLibraryToTheSeventhDigitOfADerivative)
{
  for (const double angle : { 1e-9, 1e-4, 0.01, 0.2, 0.7, 1.2, 1.57 })
  {
    const double s = 2.0 * std::pow(std::sin(0.5 * angle), 2), sine = std::sin(angle), cosine = std::cos(angle);
    const ArcSeries arc = arcOf(s);
    EXPECT_NEAR(arc.squared, angle * angle, 4e-15 * angle * angle) << angle;
    EXPECT_NEAR(arc.ratio, angle / sine, 4e-15) << angle;
    if (angle > 0.1)
    {
      // (1 - c^2) f' = c f - 1, and its derivative.
      const double first = (cosine * arc.ratio - 1.0) / (sine * sine);
      EXPECT_NEAR(arc.first, first, 1e-12) << angle;
      EXPECT_NEAR(arc.second, (arc.ratio + 3.0 * cosine * first) / (sine * sine), 1e-10) << angle;
    }
  }
  EXPECT_EQ(arcOf(0.0).ratio, 1.0);
  EXPECT_NEAR(arcOf(0.0).first, -1.0 / 3.0, 1e-16); // a / sin a = 1 + s / 3 + 2 s^2 / 15
  EXPECT_NEAR(arcOf(0.0).second, 4.0 / 15.0, 1e-16);
}

TEST(Beam, ItsForcesAreTheSlopesOfItsEnergy)
{
  Random random(testSeed(1));
  for (std::size_t i = 0; i < testCount(50); ++i)
  {
    const Wire wire = kinkedWire(3);
    const WireBeam& beam = wire.beams[i % 3];
    const TwoPoses at = bent(wire, 0.6, random);
    const Twelve gradient = gradientOf(answerOf(beam, at));
    constexpr double h = 1e-5;
    for (int k = 0; k < 12; ++k)
    {
      const Twelve by = h * Twelve::Unit(k);
      const double slope =
        (answerOf(beam, moved(at, by)).energy_Nu - answerOf(beam, moved(at, -by)).energy_Nu) / (2.0 * h);
      EXPECT_NEAR(gradient[k], slope, 1e-8 * (1.0 + gradient.norm())) << "motion " << k;
    }
  }
}

TEST(Beam, ItsStiffnessIsThatOfDifferencesOfForcesAlsoFarFromRest)
{
  Random random(testSeed(2));
  for (std::size_t i = 0; i < testCount(50); ++i)
  {
    const Wire wire = kinkedWire(3);
    const WireBeam& beam = wire.beams[i % 3];
    const TwoPoses at = bent(wire, 0.4, random);
    constexpr double h = 1e-5;
    Square slopes;
    for (int k = 0; k < 12; ++k)
    {
      const Twelve by = h * Twelve::Unit(k);
      slopes.col(k) =
        (gradientOf(answerOf(beam, moved(at, by))) - gradientOf(answerOf(beam, moved(at, -by)))) / (2.0 * h);
    }
    // Forces along turns that follow one another differ by their order; the second derivative along one turn does not.
    const Square symmetric = 0.5 * (slopes + slopes.transpose());
    const Square tangent = tangentOf(answerOf(beam, at));
    EXPECT_LE((tangent - symmetric).cwiseAbs().maxCoeff(), 1e-8 * symmetric.cwiseAbs().maxCoeff());
    EXPECT_LE((tangent - tangent.transpose()).cwiseAbs().maxCoeff(), 1e-14 * tangent.cwiseAbs().maxCoeff());
  }
}

TEST(Beam, ARigidMotionTurnsItsForcesAndChangesNothingElse)
{
  Random random(testSeed(3));
  for (std::size_t i = 0; i < testCount(50); ++i)
  {
    const Wire wire = kinkedWire(2);
    const TwoPoses at = bent(wire, 0.5, random);
    const Pose motion{ 3.0 * random.direction(), turnBy(3.0 * random.direction()) };
    const BeamAnswer before = answerOf(wire.beams[1], at);
    const BeamAnswer after = answerOf(wire.beams[1], { motion * at.first, motion * at.second });
    Square turn = Square::Zero();
    for (int k = 0; k < 12; k += 3)
    {
      turn.block<3, 3>(k, k) = motion.q.toRotationMatrix();
    }
    const double rounding = 1e-13 * tangentOf(before).cwiseAbs().maxCoeff();
    EXPECT_NEAR(after.energy_Nu, before.energy_Nu, rounding);
    EXPECT_LE((gradientOf(after) - turn * gradientOf(before)).norm(), rounding);
    EXPECT_LE((tangentOf(after) - turn * tangentOf(before) * turn.transpose()).norm(), 10.0 * rounding);
  }
}

TEST(Beam, ItsForcesAndMomentsAreInBalance)
{
  Random random(testSeed(4));
  for (std::size_t i = 0; i < testCount(50); ++i)
  {
    const Wire wire = kinkedWire(2);
    const TwoPoses at = bent(wire, 0.6, random);
    const auto [a, b] = answerOf(wire.beams[0], at).gradient;
    EXPECT_LE((a + b).head<3>().norm(), 1e-14 * a.norm());
    const Vec3 moment = a.tail<3>() + b.tail<3>() + (at.second.p - at.first.p).cross(b.head<3>());
    EXPECT_LE(moment.norm(), 1e-13 * a.norm());
  }
}

TEST(Beam, AtRestItIsFreeOfForceWhereverItIs)
{
  const Wire wire = kinkedWire(1);
  const Pose somewhere{ Vec3(3.0, -2.0, 7.0), turnBy(Vec3(0.4, 2.0, -1.0)) };
  const TwoPoses at{ somewhere,
    somewhere * Pose{ wire.beams[0].length_u * Vec3::UnitX(), wire.beams[0].second.conjugate() } };
  EXPECT_LE(gradientOf(answerOf(wire.beams[0], at)).norm(), 1e-13);
}

TEST(Beam, ALittleLoadBendsItAsTimoshenkoSays)
{
  const BeamSection section{ 1e4, 40.0, 3.0, 2.0 };
  const std::array<Vec3, 2> points{ Vec3::Zero(), 0.7 * Vec3::UnitX() };
  const Wire wire = makeWire(points, { &section, 1 }).value;
  const WirePlaces places = placesAlong(points);
  const NodeBlock stiffness = answerOf(wire.beams[0], { places[0], places[1] }).secondSecond;
  const NodeBlock compliance = stiffness.inverse();
  const double length = 0.7;
  EXPECT_NEAR(compliance(0, 0), length / 1e4, 1e-12);
  for (const int across : { 1, 2 })
  {
    EXPECT_NEAR(compliance(across, across), std::pow(length, 3) / (3.0 * 3.0) + length / 40.0, 1e-12);
    EXPECT_NEAR(compliance(across + 3, across + 3), length / 3.0, 1e-12);
  }
  EXPECT_NEAR(compliance(1, 5), length * length / (2.0 * 3.0), 1e-12);
  EXPECT_NEAR(compliance(3, 3), length / 2.0, 1e-12);
}

TEST(Beam, ATwistOfNearlyHalfATurnIsKnownBySignAndSize)
{
  const Wire wire = kinkedWire(1);
  for (const double twist : { -3.1, -2.0, -0.3, 1e-9, 0.3, 2.0, 3.1 })
  {
    // The rest of this beam is along its own x axis at the first node.
    const Pose first;
    const Pose second{ wire.beams[0].length_u * Vec3::UnitX(),
      turnBy(twist * Vec3::UnitX()) * wire.beams[0].second.conjugate() };
    const BeamAnswer answer = answerOf(wire.beams[0], { first, second });
    EXPECT_NEAR(answer.twist_rad, twist, 1e-13);
    EXPECT_NEAR(answer.gradient[1][3], 2.0 / wire.beams[0].length_u * twist, 1e-13);
  }
}

} // namespace
} // namespace palpate::test
