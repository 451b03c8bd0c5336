// SPDX-License-Identifier: GPL-3.0-or-later
// Row 37: yield under a fixed patch and under one node as a mesh gets finer: the node's compliance has no limit.
#include <algorithm>

#include "haptics/compliance/body/SoftBody.h"
#include "haptics/compliance/map/Patches.h"
#include "testing/haptics/compliance/Blocks.h"
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace patch_compliance_experiment
{

struct Compliance
{
  double patch_m_per_N = 0.0;
  double node_m_per_N = 0.0;
};

/// In the middle of the top of a pad of n cells along .1 m.
Compliance complianceOf(int n)
{
  SoftBodyInput input = test::pad(n);
  input.element = ElementKind::Linear;
  input.model = ElasticModel::Linear;
  const SoftBodyResult made = makeSoftBody(input);
  const std::vector<Vec3>& places_W = made.body->points().rest_W;
  const Vec3 middle_W(0.05, 0.05, 0.05);
  const auto closer = [&middle_W](const Vec3& a, const Vec3& b)
  { return (a - middle_W).norm() < (b - middle_W).norm(); };
  const auto node =
    static_cast<std::uint32_t>(std::min_element(places_W.begin(), places_W.end(), closer) - places_W.begin());
  const BorderFaces border(made.body->points(), borderOf(made.checked.mesh));
  SurfaceMap map;
  map.add(patchAt(border, middle_W, border.facesAt(node).front(), 0.0125));
  map.add({ { node }, { Mat3::Identity() } });
  const std::vector<std::uint32_t> both{ 0, 1 };
  const Eigen::MatrixXd c = made.body->compliance(map.columnsOf(both));
  return { c(2, 2), c(5, 5) };
}

} // namespace patch_compliance_experiment

void runPatch(const Conditions& conditions, Table& table)
{
  using namespace patch_compliance_experiment;
  // docs/theory.md, "A patch, and Hertz below it": block of 20 kPa and nu .4, patch of 12.5 mm; independent code.
  const std::vector<std::pair<int, double>> meshes{ { 4, 0.0 }, { 6, 0.0 }, { 8, 1.155e-3 }, { 12, 1.390e-3 },
    { 16, 1.533e-3 } };
  constexpr double limit_m_per_N = 1.86e-3; // of edges without length
  Compliance before;
  for (const auto& [n, truth] : meshes)
  {
    if (n > conditions.pick(12, 16, 16))
    {
      break;
    }
    const Compliance found = complianceOf(n);
    const std::string name = caseName({ { "edge_mm", 100.0 / n } });
    if (n >= 8)
    {
      table.within({ name, "patch", "compliance", "m/N" }, found.patch_m_per_N, truth, 0.01 * truth);
    }
    else
    {
      // With edges longer than the patch the map is right and the mechanics behind it too stiff.
      table.atLeast({ name, "coarse mechanics", "too stiff by" }, 1.0 - found.patch_m_per_N / limit_m_per_N, 0.4);
    }
    // A node's grows as the edges shrink, without end.
    if (n >= 8)
    {
      const double share = found.node_m_per_N / before.node_m_per_N;
      table.atLeast({ name, "one node", "compliance over that of the mesh before" }, share, 1.2);
    }
    before = found;
  }
}

} // namespace palpate::lab
