// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/servo/SharedDents.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "SoftScenes.h"
#include "haptics/compliance/servo/SubgridForce.h"
#include "testing/support/Linear.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr double patch_u = 0.01;

SoftContact contactAt(const SoftSurfaceRef& touch, const Vec3& at_W, const Vec3& n, double force_N)
{
  SoftContact contact;
  contact.soft = &touch;
  contact.point.at.x_W = at_W;
  contact.point.patch_u = patch_u;
  contact.n = n.normalized();
  contact.spring = { 1.7e-3, 2e-4 };
  contact.force_N = force_N * contact.n;
  return contact;
}

TEST(SharedDents, ContactsOfOnePlaceHaveOneDentUnderTheirWholeForceAndFarOnesOneEach)
{
  const SoftSurfaceRef touch;
  for (const double apart_u : { 0.0, 100.0 * patch_u })
  {
    std::vector<SoftContact> contacts;
    for (int i = 0; i < 4; ++i)
    {
      contacts.push_back(contactAt(touch, Vec3(apart_u * i, 0, 0), Vec3::UnitZ(), 0.5));
    }
    SharedDents dents(contacts);
    (void)dents.press();
    const SubgridDepth expected = subgridDepth(contacts[0].spring, apart_u == 0.0 ? 2.0 : 0.5);
    EXPECT_NEAR(dents.depthAt(2).z(), expected.depth_u, 1e-12 * expected.depth_u);
    EXPECT_EQ(dents.depthAt(2).head<2>(), Eigen::Vector2d::Zero());
  }
}

TEST(SharedDents, OfAWallAndOfAnotherBodyNothingIsShared)
{
  const SoftSurfaceRef one;
  const SoftSurfaceRef other;
  std::vector<SoftContact> contacts{ contactAt(one, Vec3::Zero(), Vec3::UnitZ(), 1.0),
    contactAt(other, Vec3::Zero(), Vec3::UnitZ(), 1.0), contactAt(one, Vec3::Zero(), Vec3::UnitZ(), 1.0) };
  contacts[2].soft = nullptr;
  SharedDents dents(contacts);
  (void)dents.press();
  EXPECT_DOUBLE_EQ(dents.depthAt(0).z(), subgridDepth(contacts[0].spring, 1.0).depth_u);
  EXPECT_EQ(dents.depthAt(2), Vec3::Zero());
}

/// At random places within some patches, pressed within their cones of normals.
std::vector<SoftContact> randomContacts(const SoftSurfaceRef& touch, Random& random)
{
  std::vector<SoftContact> contacts;
  for (int i = 0; i < 5; ++i)
  {
    const Vec3 n = Vec3::UnitZ() + 0.8 * random.inCube(1.0);
    contacts.push_back(contactAt(touch, random.inCube(patch_u), n, random.uniform(0.1, 2.0)));
  }
  return contacts;
}

TEST(SharedDents, DepthIsTheDerivativeOfTheEnergyAndSlopesThatOfDepth)
{
  Random random(testSeed(77));
  const SoftSurfaceRef touch;
  for (std::size_t i = 0; i < testCount(50); ++i)
  {
    std::vector<SoftContact> contacts = randomContacts(touch, random);
    const int count = static_cast<int>(contacts.size());
    SharedDents dents(contacts);
    (void)dents.press(SharedDents::Line::Tangent);
    Eigen::MatrixXd slopes(count, count);
    for (int c = 0; c < count; ++c)
    {
      for (int d = 0; d < count; ++d)
      {
        slopes(c, d) = dents.slopeBetween(c, d);
      }
    }
    EXPECT_LE((slopes - slopes.transpose()).norm(), 1e-14 * slopes.norm());
    EXPECT_GE(test::eigenvaluesOf(slopes)[0], -1e-12 * slopes.norm());
    for (int d = 0; d < count; ++d)
    {
      const double step_N = 1e-5;
      const Vec3 force_N = contacts[d].force_N;
      const auto pressed = [&](double by_N)
      {
        contacts[d].force_N = force_N + by_N * contacts[d].n;
        SharedDents moved(contacts);
        (void)moved.press();
        contacts[d].force_N = force_N;
        return moved;
      };
      const SharedDents more = pressed(step_N);
      const SharedDents less = pressed(-step_N);
      const double depth_u = contacts[d].n.dot(dents.depthAt(d));
      EXPECT_NEAR((more.energy() - less.energy()) / (2.0 * step_N), depth_u, 1e-7 * slopes.trace());
      for (int c = 0; c < count; ++c)
      {
        const double slope = contacts[c].n.dot(more.depthAt(c) - less.depthAt(c)) / (2.0 * step_N);
        EXPECT_NEAR(slope, slopes(c, d), 1e-7 * slopes.trace());
      }
    }
  }
}

TEST(SharedDents, AsideIsTheDerivativeOfTheEnergyByTheForcesAcrossAndNeverTakesAny)
{
  Random random(testSeed(282));
  const SoftSurfaceRef touch;
  for (std::size_t i = 0; i < testCount(50); ++i)
  {
    std::vector<SoftContact> contacts = randomContacts(touch, random);
    const int count = static_cast<int>(contacts.size());
    for (SoftContact& contact : contacts)
    {
      contact.spring.across = 1.3;
      const Vec3 aside_N = random.inCube(0.5);
      contact.force_N += aside_N - contact.n.dot(aside_N) * contact.n;
    }
    SharedDents dents(contacts);
    (void)dents.press();
    Eigen::MatrixXd across(count, count);
    for (int c = 0; c < count; ++c)
    {
      for (int d = 0; d < count; ++d)
      {
        across(c, d) = dents.acrossBetween(c, d);
      }
      EXPECT_NEAR(contacts[c].n.dot(dents.asideAt(c)), 0.0, 1e-18);
      // Across its normal a force changes no dent's depth: the energy is a square.
      const Vec3 along = contacts[c].n.cross(random.inCube(1.0)).normalized();
      const auto energy = [&](double by_N)
      {
        std::vector<SoftContact> pulled = contacts;
        pulled[c].force_N += by_N * along;
        SharedDents moved(pulled);
        (void)moved.press();
        return moved.energy();
      };
      const double slope = (energy(1e-3) - energy(-1e-3)) / 2e-3;
      EXPECT_NEAR(slope, along.dot(dents.asideAt(c)), 1e-9 * dents.asideAt(c).norm() + 1e-13);
    }
    EXPECT_GE(test::eigenvaluesOf(across)[0], -1e-12 * across.norm());
  }
}

TEST(SharedDents, OneAloneGivesAlongTheSurfaceByMindlinsRatioOfItsSlope)
{
  const SoftSurfaceRef touch;
  std::vector<SoftContact> contacts{ contactAt(touch, Vec3::Zero(), Vec3::UnitZ(), 0.1) };
  contacts[0].spring.across = 1.6 / 1.2; // (2 - nu) / (2 (1 - nu)) at nu = .4
  SharedDents dents(contacts);
  (void)dents.press();
  EXPECT_DOUBLE_EQ(dents.acrossBetween(0, 0), 1.6 / 1.2 * subgridDepth(contacts[0].spring, 0.1).slope);
}

/// A pad whose faces around the middle of its top rise by a slope: the ball rests on several of them.
SoftPad dimpledPad(double slope)
{
  return SoftPad(10, 2.0, ElementKind::Linear,
    [slope](SoftBodyInput& input)
    {
      for (Vec3& p : input.mesh.vertices_W)
      {
        const Vec3 aside = p - SoftPad::middle();
        p.z() *= 1.0 + slope * std::max(std::abs(aside.x()), std::abs(aside.y())) / 0.05;
      }
    });
}

TEST(SharedDents, AVertexInNearlyFlatFacesIsAsSoftAsTheFlat)
{
  const auto pressed = [](double slope, int& contacts)
  {
    SoftScene s(dimpledPad(slope), 0.01, 0.05);
    (void)s.move(SoftPad::middle() + Vec3(0, 0, 0.02));
    const SoftResult found = s.move(SoftPad::middle() + Vec3(0, 0, 0.004));
    EXPECT_FALSE(found.capped);
    contacts = s.state.count;
    return found.force_N.z();
  };
  int contacts = 0;
  const double flat_N = pressed(0.0, contacts);
  EXPECT_GT(flat_N, 0.1);
  for (const double slope : { 1e-5, 1e-4, 1e-3, 1e-2 })
  {
    // A ball in a dimple of this slope is at most 10 mm x slope^2 higher and its feet 10 mm x slope apart, of a patch
    // of 20.
    EXPECT_NEAR(pressed(slope, contacts) / flat_N, 1.0, 1e-3 + slope);
    EXPECT_GT(contacts, 1) << slope;
  }
}

} // namespace
} // namespace palpate::test
