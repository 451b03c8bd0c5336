// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/constraints/ConstraintCompliance.h"

namespace palpate
{
namespace
{

/// Of a body that nothing elastic holds: which of the problem's degrees of freedom are its own, and which of its six
/// numbers they are.
struct FreeWays
{
  int first = 0;
  int count = 0; ///< the last so many of six
};

FreeWays waysOf(const MechanismPlan& plan, const MechanismGrip& grip, int body) noexcept
{
  const auto countOf = [&plan, &grip](int b)
  {
    const MechanismBodyKind kind = plan.bodies[b].kind;
    const int turns = grip.turning_Nu_per_rad > 0.0 ? 0 : 3;
    const int rests = isLoose(plan.bodies[b]) ? 0 : 6;
    return kind == MechanismBodyKind::Rigid ? rests : kind == MechanismBodyKind::Held ? turns : 0;
  };
  FreeWays ways{ 0, countOf(body) };
  for (int b = 0; b < body; ++b)
  {
    ways.first += countOf(b);
  }
  return ways;
}

/// The part of one side's point: as A's goes, and as B's goes the other way.
Mat3 sideCompliance(const ConstraintScene& scene, const ConstraintRows& rows, int l, int side, int m) noexcept
{
  Mat3 sum = Mat3::Zero();
  for (int t = 0; t < 2; ++t)
  {
    const ConstraintEnd& a = rows.ends[l][side];
    const ConstraintEnd& b = rows.ends[m][t];
    if (a.soft >= 0 && a.soft == b.soft)
    {
      const Mat3 c = complianceBetween(*scene.soft[a.soft]->snapshot, a.point, b.point);
      sum += side == t ? c : Mat3(-c);
    }
  }
  return sum;
}

/// How A's point of constraint l goes against B's, by the soft bodies, under a force between those of constraint m.
Mat3 softCompliance(const ConstraintScene& scene, const ConstraintRows& rows, int l, int m) noexcept
{
  return sideCompliance(scene, rows, l, 0, m) + sideCompliance(scene, rows, l, 1, m);
}

/// Of the rows of the constraints that i and j belong to: rows of one constraint stand together.
void addSoft(const ConstraintScene& scene, const ConstraintRows& rows, ConstraintProblem& problem) noexcept
{
  for (int i = 0, iEnd = 0; i < rows.count; i = iEnd)
  {
    const int l = rows.rows[i].law;
    for (iEnd = i; iEnd < rows.count && rows.rows[iEnd].law == l; ++iEnd)
    {
    }
    for (int j = 0, jEnd = 0; j <= i; j = jEnd)
    {
      const int m = rows.rows[j].law;
      for (jEnd = j; jEnd < rows.count && rows.rows[jEnd].law == m; ++jEnd)
      {
      }
      const Mat3 c = softCompliance(scene, rows, l, m);
      for (int p = i; p < iEnd; ++p)
      {
        for (int q = j; q < std::min(jEnd, p + 1); ++q)
        {
          const bool points = !rows.rows[p].turns && !rows.rows[q].turns;
          const double add = points ? rows.rows[p].along_W.dot(c * rows.rows[q].along_W) : 0.0;
          problem.compliance(p, q) += add;
          problem.compliance(q, p) = problem.compliance(p, q);
        }
      }
    }
  }
}

/// Of the body in the hand, on whose side of the constraints the rows' motions are.
void addHeld(
  const ConstraintScene& scene, const ConstraintRows& rows, const HeldYield& held, ConstraintProblem& problem) noexcept
{
  std::array<Vec6, ConstraintRows::most> j;
  for (int i = 0; i < rows.count; ++i)
  {
    j[i].setZero();
    for (int side = 0; side < 2; ++side)
    {
      if (rows.ends[rows.rows[i].law][side].body == scene.plan.held)
      {
        j[i] += jacobianOf(scene, rows, rows.rows[i], side);
      }
    }
    problem.free[i] = rows.rows[i].free_u + j[i].dot(held.back_u);
    const Vec6 goes = held.compliance * j[i];
    for (int k = 0; k <= i; ++k)
    {
      problem.compliance(i, k) = goes.dot(j[k]);
    }
  }
}

/// Of rows with Coulomb's friction, of the compliance by their loose bodies: a body that stands on more places than it
/// has degrees of freedom shares its weight between them evenly.
constexpr double evenly = 1e-3;

/// Of a loose body: by its inertia it yields to a row's force in a tick like a spring.
void addLoose(const ConstraintScene& scene, const ConstraintRows& rows, int body, ConstraintProblem& problem) noexcept
{
  const LooseYield& yield = scene.loose[static_cast<std::size_t>(body)];
  std::array<Vec6, ConstraintRows::most> j;
  std::array<int, ConstraintRows::most> own{};
  int count = 0;
  for (int i = 0; i < rows.count; ++i)
  {
    const auto& [a, b] = rows.ends[rows.rows[i].law];
    if (a.body != body && b.body != body)
    {
      continue;
    }
    j[count] = jacobianOf(scene, rows, rows.rows[i], a.body == body ? 0 : 1);
    own[count] = i;
    problem.free[i] += j[count].dot(yield.back_u);
    const Vec6 goes = yield.compliance * j[count];
    for (int k = 0; k <= count; ++k)
    {
      problem.compliance(i, own[k]) += goes.dot(j[k]);
    }
    const bool rubs = i >= rows.count - 3 * rows.cones;
    problem.compliance(i, i) += rubs ? evenly * goes.dot(j[count]) : 0.0;
    ++count;
  }
}

void addWays(const ConstraintScene& scene, const ConstraintRows& rows, const MechanismGrip& grip,
  ConstraintProblem& problem) noexcept
{
  problem.along.setZero();
  for (int i = 0; i < rows.count; ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      const FreeWays ways = waysOf(scene.plan, grip, rows.ends[rows.rows[i].law][side].body);
      if (ways.count > 0)
      {
        const Vec6 j = jacobianOf(scene, rows, rows.rows[i], side);
        problem.along.row(i).segment(ways.first, ways.count) += j.tail(ways.count).transpose();
      }
    }
  }
  problem.load.setZero();
  for (int b = 0; b < scene.plan.bodyCount; ++b)
  {
    if (scene.plan.bodies[b].kind == MechanismBodyKind::Rigid && !isLoose(scene.plan.bodies[b]))
    {
      problem.load.segment<3>(waysOf(scene.plan, grip, b).first) = scene.plan.bodies[b].load_W;
    }
  }
}

/// Resistance of a force at an arm against turning, about all axes but its own. A force that pushes over is left out:
/// no body comes to rest there.
Mat3 heldByPull(const Vec3& arm_W, const Vec3& force_W) noexcept
{
  const double pull = arm_W.dot(force_W);
  return pull > 0.0 ? Mat3(pull * (Mat3::Identity() - arm_W * arm_W.transpose() / arm_W.squaredNorm()))
                    : Mat3(Mat3::Zero());
}

/// A body that hangs between joints, as a rod that is pulled at both ends does, is in balance by these forces alone: no
/// row is for its turn.
void addTurns(const ConstraintScene& scene, const ConstraintRows& rows, const MechanismGrip& grip,
  ConstraintProblem& problem) noexcept
{
  const double characteristic_u = scene.plan.characteristic_u;
  for (int l = 0; l < scene.plan.lawCount; ++l)
  {
    for (int side = 0; side < 2 && scene.laws[l].force_W != Vec3::Zero(); ++side)
    {
      const ConstraintEnd& end = rows.ends[l][side];
      const FreeWays ways = waysOf(scene.plan, grip, end.body);
      if (ways.count > 0)
      {
        const int turn = ways.first + ways.count - 3;
        const Vec3 force_W = side == 0 ? scene.laws[l].force_W : Vec3(-scene.laws[l].force_W);
        problem.turns.block<3, 3>(turn, turn) +=
          heldByPull(armOf(scene, rows, l, side), force_W) / (characteristic_u * characteristic_u);
      }
    }
  }
}

} // namespace

void assembleConstraints(const ConstraintScene& scene, const ConstraintRows& rows, const MechanismGrip& grip,
  const HeldYield& held, ConstraintProblem& problem) noexcept
{
  const FreeWays last = waysOf(scene.plan, grip, scene.plan.bodyCount - 1);
  problem.resize(rows.count, last.first + last.count);
  problem.cones = rows.cones;
  problem.friction = rows.friction;
  problem.yield_u_per_N = 1.0 / grip.coupling_N_per_u;
  addHeld(scene, rows, held, problem);
  for (int b = 0; b < static_cast<int>(scene.loose.size()); ++b)
  {
    if (isLoose(scene.plan.bodies[b]))
    {
      addLoose(scene, rows, b, problem);
    }
  }
  addSoft(scene, rows, problem);
  for (int i = 0; i < rows.count; ++i)
  {
    const ConstraintRow& row = rows.rows[i];
    problem.compliance(i, i) += row.compliance_u_per_N;
    problem.lowest[i] = row.lowest_N;
    problem.highest[i] = row.highest_N;
  }
  addWays(scene, rows, grip, problem);
  addTurns(scene, rows, grip, problem);
}

Vec3 softApart_W(const ConstraintScene& scene, const ConstraintRows& rows, int l) noexcept
{
  const auto& [a, b] = rows.ends[l];
  Vec3 apart_W = (a.soft >= 0 ? a.x_W : Vec3(Vec3::Zero())) - (b.soft >= 0 ? b.x_W : Vec3(Vec3::Zero()));
  for (int m = 0; m < scene.plan.lawCount; ++m)
  {
    if (scene.laws[m].force_W != Vec3::Zero())
    {
      apart_W += softCompliance(scene, rows, l, m) * scene.laws[m].force_W;
    }
  }
  return apart_W;
}

Vec3 yielded_W(const ConstraintScene& scene, const ConstraintRows& rows, int l, int side) noexcept
{
  Vec3 x_W = rows.ends[l][side].x_W;
  for (int m = 0; m < scene.plan.lawCount; ++m)
  {
    if (scene.laws[m].force_W != Vec3::Zero())
    {
      const Vec3 way_W = sideCompliance(scene, rows, l, side, m) * scene.laws[m].force_W;
      x_W += side == 0 ? way_W : Vec3(-way_W);
    }
  }
  return x_W;
}

Vec6 pressOn(
  const ConstraintScene& scene, const ConstraintRows& rows, const ConstraintForces& forces, int body) noexcept
{
  Vec6 sum = Vec6::Zero();
  for (int i = 0; i < rows.count; ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      if (rows.ends[rows.rows[i].law][side].body == body)
      {
        sum += forces.force_N[i] * jacobianOf(scene, rows, rows.rows[i], side);
      }
    }
  }
  return sum;
}

Vec6 motionOf(const ConstraintScene& scene, const ConstraintRows& rows, const MechanismGrip& grip,
  const HeldYield& held, const ConstraintForces& forces, int body) noexcept
{
  Vec6 motion = Vec6::Zero();
  if (body == scene.plan.held)
  {
    motion = held.compliance * pressOn(scene, rows, forces, body) + held.back_u;
  }
  if (!scene.loose.empty() && isLoose(scene.plan.bodies[body]))
  {
    const LooseYield& yield = scene.loose[static_cast<std::size_t>(body)];
    motion = yield.compliance * pressOn(scene, rows, forces, body) + yield.back_u;
  }
  const FreeWays ways = waysOf(scene.plan, grip, body);
  motion.tail(ways.count) += forces.way_u.segment(ways.first, ways.count);
  return motion;
}

} // namespace palpate
