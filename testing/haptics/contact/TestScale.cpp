// SPDX-License-Identifier: GPL-3.0-or-later
// Row 16: the unit, the place and a stray far point change nothing.
#include <cmath>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

constexpr std::size_t sphereTriangles = 5000;

class Scale : public ::testing::TestWithParam<double>
{
protected:
  Scale() : sphere_(sphereTriangles, 1.0), r_(GetParam()), plain_(sceneOf(sphere_.mesh()), r_, slideStart_W(sphere_)) {}

  /// Leads both over the sphere; `toOther` and `fromOther` are the change of frame.
  template<class To, class From>
  void compare(Probe& other, To toOther, From fromOther, double relative)
  {
    for (std::size_t i = 0; i < testCount(1500); ++i)
    {
      const SlidePoint slide = slideOver(this->sphere_, i);
      this->plain_.to(slide.p_W);
      other.to(toOther(slide.p_W));
      const Vec3 truth = this->plain_.force(1.0);
      const Vec3 force = fromOther(other.x_W()) - slide.p_W;
      ASSERT_LE((force - truth).norm(), relative * truth.norm()) << "tick " << i;
    }
  }

  NoisySphere sphere_;
  double r_;
  Probe plain_;
};

TEST_P(Scale, TheForceScalesWithTheScene)
{
  for (const double factor : { 1e-6, 1e-3, 1e3, 1e6 })
  {
    SCOPED_TRACE(factor);
    this->plain_ = Probe(sceneOf(this->sphere_.mesh()), this->r_, slideStart_W(this->sphere_));
    Probe other(sceneOf(scaled(this->sphere_.mesh(), factor)), factor * this->r_, factor * slideStart_W(this->sphere_));
    this->compare(
      other, [factor](const Vec3& p) { return Vec3(factor * p); }, [factor](const Vec3& x) { return Vec3(x / factor); },
      1e-9);
  }
}

TEST_P(Scale, APowerOfTwoChangesNoBit)
{
  for (const int exponent : { -20, 20 })
  {
    SCOPED_TRACE(exponent);
    const double factor = std::ldexp(1.0, exponent);
    this->plain_ = Probe(sceneOf(this->sphere_.mesh()), this->r_, slideStart_W(this->sphere_));
    Probe other(sceneOf(scaled(this->sphere_.mesh(), factor)), factor * this->r_, factor * slideStart_W(this->sphere_));
    this->compare(
      other, [factor](const Vec3& p) { return Vec3(factor * p); }, [factor](const Vec3& x) { return Vec3(x / factor); },
      0.0);
  }
}

TEST_P(Scale, AMillionDiagonalsAwayTheForceIsTheSame)
{
  const double diagonal = 103.0 * std::sqrt(3.0); // of the box around a sphere of radius at most 51.5
  const Vec3 by = 1e6 * diagonal * Vec3(1, -1, 1).normalized();
  Probe other(sceneOf(shifted(this->sphere_.mesh(), by)), this->r_, slideStart_W(this->sphere_) + by);
  this->compare(
    other, [&by](const Vec3& p) { return Vec3(p + by); }, [&by](const Vec3& x) { return Vec3(x - by); }, 1e-6);
}

TEST_P(Scale, AStrayPointFarAwayChangesNoBit)
{
  TriangleMesh mesh = this->sphere_.mesh();
  append(mesh, shifted(makeIcosphere(0, 1.0), { 1e9, 1e9, 1e9 }));
  Probe other(sceneOf(mesh), this->r_, slideStart_W(this->sphere_));
  const auto same = [](const Vec3& v) { return v; };
  this->compare(other, same, same, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Row16, Scale, ::testing::Values(0.0, 1.0));

} // namespace
} // namespace palpate::test
