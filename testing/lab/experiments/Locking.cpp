// SPDX-License-Identifier: GPL-3.0-or-later
// Row 36: a bar that bends, of tetrahedra: how far each element is from the clamped bar, and the cost of its factor.
#include <algorithm>

#include "haptics/compliance/body/SoftBody.h"
#include "testing/haptics/compliance/Blocks.h"
#include "testing/lab/Experiments.h"
#include "testing/support/CostSample.h"

namespace palpate::lab
{
namespace locking_experiment
{

struct Bent
{
  double tip_m = 0.0;
  Cost factor;
};

/// .1 x .02 x .02 m, 1 MPa, nu .3, fixed at one end, 1 N across spread evenly over the other; r cells across.
Bent bend(ElementKind element, int r)
{
  SoftBodyInput input;
  input.mesh = test::blockOf({ 5 * r, r, r }, { 0.1, 0.02, 0.02 });
  input.fixed = test::fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa = { 1e6 };
  input.poisson = 0.3;
  input.element = element;
  input.model = ElasticModel::Linear;
  const SoftBodyResult made = makeSoftBody(input);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(made.body->displacement().size());
  for (const auto& t : borderOf(made.checked.mesh))
  {
    const auto atEnd = [&made](std::uint32_t n) { return made.checked.mesh.vertices_W[n].x() > 0.1 - 1e-9; };
    for (int i = 0; std::all_of(t.begin(), t.end(), atEnd) && i < 3; ++i)
    {
      load[3 * static_cast<Eigen::Index>(t[i]) + 2] += 1.0 / (2.0 * r * r) / 3.0;
    }
  }
  test::CostSample cost(3);
  for (int i = 0; i < 3; ++i)
  {
    cost.time([&made] { (void)made.body->refactor(); });
  }
  return { load.dot(made.body->linearAnswer(load)), Cost::of(cost) };
}

} // namespace locking_experiment

void runLocking(const Conditions& conditions, Table& table)
{
  using namespace locking_experiment;
  // Three-dimensional elasticity with a clamped end; Timoshenko's beam, 25.780 mm, may narrow there.
  const double clamped_m = 0.02545;
  for (int r = 1; r <= conditions.pick(4, 4, 8); r *= 2)
  {
    const std::string name = caseName({ { "across", static_cast<double>(r) } });
    const Bent linear = bend(ElementKind::Linear, r);
    table.atLeast({ name, "linear", "too stiff by" }, 1.0 - linear.tip_m / clamped_m, r <= 4 ? 0.2 : 0.05).cost =
      linear.factor;
    const Bent smoothed = bend(ElementKind::EdgeSmoothed, r);
    const Subject subject{ name, "edge-smoothed", "too stiff by" };
    (r >= 4 ? table.atMost(subject, 1.0 - smoothed.tip_m / clamped_m, 0.02)
            : table.info(subject, 1.0 - smoothed.tip_m / clamped_m))
      .cost = smoothed.factor;
  }
}

} // namespace palpate::lab
