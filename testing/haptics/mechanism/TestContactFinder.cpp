// SPDX-License-Identifier: GPL-3.0-or-later
// Places where a mesh in the hand may meet a soft body: geometry alone.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "HeldMesh.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "testing/support/MechanismRig.h"

namespace palpate::test
{
namespace
{

TEST(SidedSurface, OfAMeshInAnyOrderTheNormalsPointOut)
{
  Random random(testSeed(341));
  const Vec3 middle(3.0, -1.0, 2.0);
  TriangleMesh both = shuffled(shifted(makeIcosphere(2, 1.0), middle), random);
  append(both, shifted(both, Vec3(5, 0, 0)));
  const auto made = makeRigidMesh(both);
  ASSERT_TRUE(made.ok()) << made.problem;
  const TriangleMesh& mesh = made.value->tree->mesh();
  const TriangleMesh right = made.value->rightHanded();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto corner = made.value->tree->data().cornersOf(t);
    const Vec3 centre = (corner[0] + corner[1] + corner[2]) / 3.0;
    const Vec3 from = centre.x() > middle.x() + 2.5 ? Vec3(middle + Vec3(5, 0, 0)) : middle;
    EXPECT_GT(made.value->areaOf(t, mesh.vertices_W).normalized().dot((centre - from).normalized()), 0.99);
    const auto& [a, b, c] = right.triangles[t];
    const Vec3 area = (right.vertices_W[b] - right.vertices_W[a]).cross(right.vertices_W[c] - right.vertices_W[a]);
    EXPECT_GT(area.dot(centre - from), 0.0);
  }
  EXPECT_EQ(made.value->edges.size(), 3 * mesh.triangles.size() / 2);
}

TEST(SidedSurface, AMeshThatIsOpenOrPinchedOrTooLargeIsRefused)
{
  TriangleMesh open = makeBox(Vec3::Zero(), Vec3::Ones());
  open.triangles.pop_back();
  EXPECT_NE(makeRigidMesh(open).problem.find("open: 3 of its edges"), std::string::npos) << makeRigidMesh(open).problem;
  TriangleMesh pinched = makeBox(Vec3::Zero(), Vec3::Ones());
  append(pinched, makeBox(Vec3(1, 1, 0), Vec3(2, 2, 1))); // along an edge of both
  EXPECT_NE(makeRigidMesh(pinched).problem.find("more than two triangles"), std::string::npos);
  EXPECT_NE(makeRigidMesh(makeIcosphere(6, 1.0)).problem.find("81920 triangles"), std::string::npos);
  EXPECT_NE(makeRigidMesh({}).problem, "");
}

/// A surface that nothing bends.
struct Rigid
{
  explicit Rigid(const TriangleMesh& mesh)
    : body(springBody("body", std::make_shared<const TriangleMesh>(cleanMesh(mesh).mesh), 0.1, 0.0)),
      sided(makeSided(body->scene->surfaces().front().tree))
  {
  }

  [[nodiscard]] std::vector<NearPlace> near(const SidedSurface& held, const Pose& held_W, double reach_u) const
  {
    return nearPlaces({ held, held_W, *this->sided, this->body.get(), 0, 0, 0, reach_u, {} });
  }

  std::shared_ptr<const PressedBody> body;
  std::shared_ptr<const SidedSurface> sided;
};

double leastGap(const std::vector<NearPlace>& near)
{
  double least = std::numeric_limits<double>::infinity();
  for (const NearPlace& place : near)
  {
    least = std::min(least, place.gap_u);
  }
  return least;
}

/// Each gap is that along its own normal, between its own points.
void expectConsistent(const std::vector<NearPlace>& near, const Pose& held_W)
{
  for (const NearPlace& place : near)
  {
    const FoundContact& contact = place.contact;
    const double gap = contact.normal_B.dot(held_W * contact.point_A - contact.place_B.x_W);
    EXPECT_NEAR(contact.normal_B.norm(), 1.0, 1e-12);
    EXPECT_NEAR(gap, place.gap_u, 1e-12);
    EXPECT_NEAR(contact.place_B.weights.sum(), 1.0, 1e-12);
  }
}

TEST(NearPlaces, OfAVertexAboveAFaceAndAFaceAboveAVertexAreAsFarAsTheyAre)
{
  const Rigid floor(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, 0)));
  TriangleMesh spike; // its tip down, inside of a triangle of the floor
  spike.vertices_W = { { 0, 0, 0 }, { 0.2, 0, 0.5 }, { -0.1, 0.2, 0.5 }, { -0.1, -0.2, 0.5 } };
  spike.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  const auto held = heldMesh(spike);
  for (const double height : { 0.03, 1e-12, -0.02 })
  {
    const Pose at{ Vec3(0.3, 0.1, height), Quat::Identity() };
    const auto near = floor.near(*held, at, 0.1);
    expectConsistent(near, at);
    ASSERT_EQ(near.size(), 1u) << "no other part of it is within reach, height " << height;
    EXPECT_NEAR(near[0].gap_u, height, 1e-12);
    EXPECT_LT((near[0].contact.normal_B - Vec3::UnitZ()).norm(), 1e-6);
  }
  const Rigid peak(shifted(test::rotated(spike, Quat(0, 1, 0, 0)), Vec3(0.1, 0.2, 0))); // its tip up
  const auto plate = heldMesh(makeBox(Vec3(-1, -1, 0), Vec3(1, 1, 0.05)));
  for (const double height : { 0.03, -0.02, -0.04 }) // nearer to the plate's far side, at last
  {
    const Pose at{ Vec3(0, 0, height), Quat::Identity() };
    const auto near = peak.near(*plate, at, 0.1);
    expectConsistent(near, at);
    ASSERT_EQ(near.size(), 1u) << height;
    EXPECT_NEAR(near[0].gap_u, height, 1e-12);
    EXPECT_LT((near[0].contact.normal_B - Vec3::UnitZ()).norm(), 1e-6);
  }
}

TEST(NearPlaces, OfEdgesThatCrossAreWhereBothAreNearest)
{
  // Two roofs, one upside down across the other: their ridges cross at a point that is no vertex of either.
  const auto roof = [](double up)
  {
    TriangleMesh mesh;
    mesh.vertices_W = { { -1, 0, 0 }, { 1.1, 0, 0 }, { -1, 0.5, -up }, { 1.1, 0.5, -up }, { -1, -0.5, -up },
      { 1.1, -0.5, -up } };
    mesh.triangles = { { 0, 1, 3 }, { 0, 3, 2 }, { 0, 4, 5 }, { 0, 5, 1 }, { 2, 3, 5 }, { 2, 5, 4 }, { 0, 2, 4 },
      { 1, 5, 3 } };
    return mesh;
  };
  const Rigid below(roof(0.4));
  const auto held = heldMesh(test::rotated(roof(-0.4), Quat(Eigen::AngleAxisd(1.2, Vec3::UnitZ()))));
  for (const double height : { 0.02, -0.01 })
  {
    const Pose at{ Vec3(0.013, 0.021, height), Quat::Identity() };
    const auto near = below.near(*held, at, 0.05);
    expectConsistent(near, at);
    ASSERT_EQ(near.size(), 1u);
    EXPECT_NEAR(near[0].gap_u, height, 1e-12);
    EXPECT_LT((near[0].contact.normal_B - Vec3::UnitZ()).norm(), 1e-12);
    const Vec3 along(std::cos(1.2), std::sin(1.2), 0.0); // the upper ridge, through (.013, .021): at y = 0
    EXPECT_NEAR(near[0].contact.place_B.x_W.x(), 0.013 - 0.021 * along.x() / along.y(), 1e-12);
  }
}

TEST(NearPlaces, OfABallBeforeABlockTheNearestIsAsFarAsItsFacetsAre)
{
  const Rigid floor(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, 0)));
  Random random(testSeed(342));
  double before = std::numeric_limits<double>::infinity();
  for (const int level : { 2, 3, 4 })
  {
    const auto ball = heldMesh(makeIcosphere(level, 0.5));
    double most = 0.0;
    for (int i = 0; i < 20; ++i)
    {
      const Pose at{ Vec3(0.3 * random.uniform(), 0.3 * random.uniform(), 0.52),
        Quat(Eigen::AngleAxisd(random.uniform(0, 3), random.direction())) };
      const auto near = floor.near(*ball, at, 0.1);
      expectConsistent(near, at);
      const double gap = leastGap(near);
      EXPECT_GE(gap, 0.02 - 1e-12) << "inscribed";
      most = std::max(most, gap - 0.02);
    }
    EXPECT_LT(most, 0.35 * before) << "a quarter with every level";
    before = most;
  }
}

TEST(ChosenPlaces, AreApartAndTheNearestAndThoseWithoutRoomAreCounted)
{
  std::vector<NearPlace> near;
  for (int i = 0; i < 20; ++i)
  {
    for (int j = 0; j < 20; ++j)
    {
      NearPlace place;
      place.contact.name = static_cast<std::uint64_t>(100 * i + j + 1);
      place.contact.place_B.x_W = Vec3(i, j, 0);
      place.gap_u = i < 10 ? 0.0 : 1.0;
      near.push_back(place);
    }
  }
  const ChosenPlaces chosen = choosePlaces(near, { 16, 16 }, 1.0, 0.1, {});
  EXPECT_EQ(chosen.leftOut, 0);
  EXPECT_LE(chosen.places.size(), 16u);
  EXPECT_GE(chosen.places.size(), 8u);
  for (std::size_t a = 0; a < chosen.places.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      EXPECT_GE((chosen.places[a].contact.place_B.x_W - chosen.places[b].contact.place_B.x_W).norm(), chosen.apart_u);
    }
  }
  // Each touching place has one of the chosen nearer than they are apart.
  for (const NearPlace& place : near)
  {
    double least = 1e9;
    for (const NearPlace& other : chosen.places)
    {
      least = std::min(least, (place.contact.place_B.x_W - other.contact.place_B.x_W).norm());
    }
    EXPECT_TRUE(place.gap_u > 0.1 || least < chosen.apart_u);
  }
  // Twenty that press in as many directions at one place cannot be merged.
  std::vector<NearPlace> star;
  for (int i = 0; i < 20; ++i)
  {
    NearPlace place;
    const double z = 1.0 - (2.0 * i + 1.0) / 20.0, turn = 2.4 * i;
    place.contact.normal_B = Vec3(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
    place.contact.name = static_cast<std::uint64_t>(i + 1);
    place.gap_u = place.free_u = 1e-3 * i;
    star.push_back(place);
  }
  const ChosenPlaces nearest = choosePlaces(star, { 4, 4 }, 1.0, 1.0, {});
  ASSERT_EQ(nearest.places.size(), 4u);
  EXPECT_EQ(nearest.leftOut, 16);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(nearest.places[i].contact.name, i + 1);
  }
}

/// All that is said of a mechanism with a mesh and a wall.
MechanismCheck checked(const std::function<void(Mechanism&)>& change)
{
  const auto wall = springWall("wall", Vec3::Zero(), Vec3::UnitZ(), 0.1, 1e-3);
  Mechanism mechanism;
  MechanismBody tool, soft;
  tool.name = "tool";
  tool.kind = MechanismBodyKind::Held;
  tool.mesh = heldMesh(makeBox(Vec3(-0.01, -0.01, 0.1), Vec3(0.01, 0.01, 0.12)));
  soft.name = "wall";
  soft.kind = MechanismBodyKind::Soft;
  mechanism.bodies = { tool, soft };
  mechanism.findsContacts = true;
  change(mechanism);
  const std::vector<MechanismSoft> bodies{ { "wall", wall.get() }, { "other", wall.get() } };
  return checkMechanism(mechanism, bodies, { kc, kr });
}

void expectFault(const std::string& words, const std::function<void(Mechanism&)>& change)
{
  const MechanismCheck check = checked(change);
  ASSERT_EQ(check.faults.size(), 1u) << words;
  EXPECT_NE(check.faults[0].find(words), std::string::npos) << check.faults[0];
}

TEST(CheckedMeshes, WithoutWhatTheyNeedAreRefusedInOneSentence)
{
  const MechanismCheck good = checked([](Mechanism&) {});
  EXPECT_TRUE(good.faults.empty()) << good.faults[0];
  EXPECT_EQ(good.rows, 0);
  EXPECT_TRUE(good.heldOverlaps.empty());
  expectFault("would meet nothing", [](Mechanism& m) { m.findsContacts = false; });
  expectFault("the size of a rod beside it", [](Mechanism& m) { m.bodies[0].length_u = 0.1; });
  expectFault("friction of found contacts", [](Mechanism& m) { m.foundFriction = -0.1; });
  expectFault("friction of found contacts", [](Mechanism& m) { m.foundFriction = std::nan(""); });
  expectFault("there are none", [](Mechanism& m) { m.bodies.pop_back(); });
  expectFault("no such body has a file",
    [](Mechanism& m)
    {
      m.bodies[0].mesh.reset();
      m.bodies[0].length_u = m.bodies[0].diameter_u = 0.1;
    });
  const auto law = [](ConstraintKind kind, const std::string& name)
  {
    MechanismConstraint made;
    made.name = name;
    made.kind = kind;
    made.a = "tool";
    made.b = "wall";
    made.strength_N = 1.0;
    return made;
  };
  expectFault("needs a rod in the hand", [&law](Mechanism& m) { m.laws = { law(ConstraintKind::Puncture, "hole") }; });
  expectFault("fewer than four contacts",
    [&law](Mechanism& m)
    {
      for (int i = 0; i < 13; ++i)
      {
        m.laws.push_back(law(ConstraintKind::Spring, std::to_string(i)));
      }
    });
  expectFault("lies outside of",
    [&law](Mechanism& m)
    {
      m.laws = { law(ConstraintKind::Attachment, "far") };
      m.laws[0].point_A = Vec3(0, 0, 0.2);
    });
}

TEST(CheckedMeshes, MayMeetTwoSoftBodiesAndSayInWhatTheyStand)
{
  const MechanismCheck two = checked(
    [](Mechanism& m)
    {
      MechanismBody other = m.bodies[1];
      other.name = "other";
      m.bodies.push_back(other);
    });
  ASSERT_TRUE(two.faults.empty());
  EXPECT_TRUE(std::ranges::none_of(
    two.remarks, [](const std::string& remark) { return remark.find("are not found") != std::string::npos; }));
  const MechanismCheck in = checked(
    [](Mechanism& m) { m.bodies[0].mesh = heldMesh(makeBox(Vec3(-0.01, -0.01, -0.01), Vec3(0.01, 0.01, 0.01))); });
  ASSERT_EQ(in.heldOverlaps.size(), 1u);
  EXPECT_TRUE(std::ranges::any_of(
    in.remarks, [](const std::string& remark) { return remark.find("push them apart at once") != std::string::npos; }));
}

} // namespace
} // namespace palpate::test
