// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose vertices, edges and faces coincide overlap where their boxes overlap along each axis, and nowhere else:
// the boxes are the judge.
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/mechanism/check/BodiesOverlap.h"
#include "testing/support/MechanismRig.h"
#include "testing/support/TreeOf.h"

namespace palpate::test
{
namespace
{

using Cells = std::array<int, 3>;

/// Box of cells of edge 1 whose middle is there: two triangles to each square of its surface, the outer side outside.
std::shared_ptr<const TriangleMesh> latticeBox(const Cells& cells, const Vec3& middle_W)
{
  auto mesh = std::make_shared<TriangleMesh>();
  std::map<Cells, std::uint32_t> known;
  const auto vertex = [&](const Cells& at)
  {
    const auto [place, isNew] = known.emplace(at, static_cast<std::uint32_t>(mesh->vertices_W.size()));
    if (isNew)
    {
      mesh->vertices_W.push_back(
        middle_W + Vec3(at[0] - 0.5 * cells[0], at[1] - 0.5 * cells[1], at[2] - 0.5 * cells[2]));
    }
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool high : { false, true })
    {
      Cells at{};
      at[axis] = high ? cells[axis] : 0;
      for (at[u] = 0; at[u] < cells[u]; ++at[u])
      {
        for (at[v] = 0; at[v] < cells[v]; ++at[v])
        {
          Cells right = at, above = at, far = at;
          right[u] = far[u] = at[u] + 1;
          above[v] = far[v] = at[v] + 1;
          const std::uint32_t a = vertex(at), b = vertex(high ? right : above), c = vertex(far),
                              d = vertex(high ? above : right);
          mesh->triangles.push_back({ a, b, c });
          mesh->triangles.push_back({ a, c, d });
        }
      }
    }
  }
  return mesh;
}

const Cells boxCells{ 6, 6, 2 };

std::shared_ptr<const PressedBody> softBox(const std::string& name, const Vec3& middle_W)
{
  const SurfaceTree tree = treeOf(*latticeBox(boxCells, middle_W)); // whose mesh has the order of a tree
  return springBody(name, std::make_shared<const TriangleMesh>(tree.mesh()), 1.0, 2e-3);
}

bool sharesRoom(const Vec3& sizeA, const Vec3& sizeB, const Vec3& apart)
{
  return (apart.cwiseAbs().array() < 0.5 * (sizeA + sizeB).array()).all();
}

/// Places on lattices of whole and half an edge, touching from outside among them, and off any lattice.
std::vector<Vec3> placesAround()
{
  std::vector<Vec3> places{ Vec3(1.9, 0.0, 1.0), Vec3(2.0, 0.0, 1.99), Vec3(5.99, 5.99, 1.99), Vec3(6.01, 0.0, 0.0) };
  for (const double x : { 0.0, 0.5, 2.0, 3.0, 6.0, 7.0 })
  {
    for (const double y : { 0.0, -1.5, -6.0 })
    {
      for (const double z : { 0.0, 0.5, 1.0, 2.0, -1.0, -2.0 })
      {
        places.emplace_back(x, y, z);
      }
    }
  }
  return places;
}

TEST(Overlaps, OfSoftBoxesAreNamedWhereverTheirVerticesCoincideAndBoxesThatTouchAreNot)
{
  for (const double far : { 0.0, 1000.0 / 3.0 })
  {
    for (const Vec3& place : placesAround())
    {
      MechanismRig rig;
      rig.join(ConstraintKind::Attachment, "world", Vec3::Zero(), Vec3::Zero());
      const Vec3 first_W(far, -far, 10.0);
      rig.addSoft("one", softBox("one", first_W));
      rig.addSoft("other", softBox("other", first_W + place));
      EXPECT_EQ(rig.check().overlaps.size(), sharesRoom(Vec3(6, 6, 2), Vec3(6, 6, 2), place) ? 1u : 0u)
        << place.transpose() << " from " << far;
    }
  }
}

TEST(Overlaps, OfASoftAndARigidBoxAreNamedWhereverTheirFacesAreCoplanarAndBoxesThatTouchAreNot)
{
  for (const Vec3& half : { Vec3(3, 3, 1), Vec3(1, 1, 0.5), Vec3(1, 5, 1) })
  {
    for (const Vec3& place : placesAround())
    {
      MechanismRig rig;
      rig.addSoft("soft", softBox("soft", Vec3(0, 0, 10)));
      MechanismBody box;
      box.name = "rigid";
      box.kind = MechanismBodyKind::Rigid;
      box.halfSize_u = half;
      box.pose_W.p = Vec3(0, 0, 10) + place;
      rig.mechanism.bodies.push_back(box);
      rig.join(ConstraintKind::Attachment, "world", Vec3::Zero(), box.pose_W.p).a = "rigid";
      EXPECT_EQ(rig.check().overlaps.size(), sharesRoom(Vec3(6, 6, 2), 2.0 * half, place) ? 1u : 0u)
        << place.transpose() << " of half " << half.transpose();
    }
  }
}

TEST(Overlaps, OfARodFromTheOriginAreNamedWhereItRunsInABodyAndNotOnItsFaceOrWhereALawJoinsThem)
{
  // The rod is on the z axis from 0 to 4.
  const auto held = [](const Vec3& middle_W, bool joined)
  {
    MechanismRig rig(4.0);
    rig.addSoft("soft", softBox("soft", middle_W));
    if (!joined)
    {
      rig.join(ConstraintKind::Attachment, "world", Vec3::Zero(), Vec3::Zero());
    }
    else
    {
      rig.join(ConstraintKind::Attachment, "soft", Vec3::Zero(), middle_W + Vec3::UnitZ());
    }
    const MechanismCheck check = rig.check();
    EXPECT_TRUE(check.faults.empty()) << (check.faults.empty() ? "" : check.faults.front());
    const std::string sentence =
      "Bodies \"needle\" and \"soft\" overlap if the hand begins at the origin: no constraint joins them.";
    const bool said = std::ranges::find(check.remarks, sentence) != check.remarks.end();
    EXPECT_EQ(said, !check.heldOverlaps.empty());
    return said;
  };
  for (const double x : { 0.0, 0.5, 1.0, 1.3 })
  {
    EXPECT_TRUE(held(Vec3(x, 1.0, 2.0), false)) << "through it, along edges of its inside";
    EXPECT_TRUE(held(Vec3(x, 0.0, 0.0), false)) << "it begins in it";
    EXPECT_TRUE(held(Vec3(x, 0.0, 4.9), false)) << "it ends in it";
    EXPECT_FALSE(held(Vec3(x, 0.0, 5.0), false)) << "it ends on it";
    EXPECT_FALSE(held(Vec3(x, 0.0, -1.0), false)) << "it begins on it";
    EXPECT_FALSE(held(Vec3(x, 3.0, 2.0), false)) << "it lies on a face";
    EXPECT_FALSE(held(Vec3(x, 0.0, 2.0), true));
  }
}

} // namespace
} // namespace palpate::test
