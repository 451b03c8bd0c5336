// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/constraints/ConstraintChange.h"

namespace palpate
{
namespace
{

void addRow(const ConstraintScene& scene, const ConstraintRow& row, double force_N, double moved_u,
  ConstraintOutcome& outcome) noexcept
{
  outcome.holds = outcome.holds || force_N != 0.0;
  if (row.turns)
  {
    return;
  }
  outcome.force_W += force_N * row.along_W;
  outcome.push_N += row.lowest_N == 0.0 ? force_N : 0.0;
  if (row.dry)
  {
    const ConstraintState& state = scene.laws[row.law];
    const bool atBound = force_N <= row.lowest_N || force_N >= row.highest_N;
    outcome.slips = atBound && moved_u != 0.0;
    outcome.rest_u.x() = (state.placed ? state.stuck_u.x() : row.now_u) + moved_u;
  }
}

/// Where Coulomb's contact rests: where it was but for its slip; where it is, while it is open.
void restCone(const ConstraintScene& scene, const ConstraintRows& rows, const ConstraintForces& forces, int first,
  ConstraintOutcome& outcome) noexcept
{
  const ConstraintRow& normal = rows.rows[first];
  const ConstraintState& state = scene.laws[normal.law];
  const auto& [a, b] = rows.ends[normal.law];
  outcome.rest_u = state.placed ? state.stuck_u : Vec3(a.x_W - b.x_W + state.offset_W);
  for (int k = first + 1; k < first + 3; ++k)
  {
    outcome.rest_u += forces.moved_u[k] * rows.rows[k].along_W;
  }
  const double friction = rows.friction[static_cast<std::size_t>((first - (rows.count - 3 * rows.cones)) / 3)];
  const double across_N = forces.force_N.segment<2>(first + 1).norm();
  outcome.slips = outcome.holds && across_N >= friction * forces.force_N[first] * (1.0 - 1e-12);
}

} // namespace

ConstraintOutcome outcomeOf(
  const ConstraintScene& scene, const ConstraintRows& rows, const ConstraintForces& forces, int law) noexcept
{
  ConstraintOutcome outcome;
  outcome.rest_u = scene.laws[law].stuck_u;
  for (int i = 0; i < rows.count; ++i)
  {
    const ConstraintRow& row = rows.rows[i];
    if (row.law != law)
    {
      continue;
    }
    addRow(scene, row, forces.force_N[i], forces.moved_u[i], outcome);
    if (i >= rows.count - 3 * rows.cones && (i - (rows.count - 3 * rows.cones)) % 3 == 2)
    {
      restCone(scene, rows, forces, i - 2, outcome);
    }
  }
  const ConstraintEnd& shaft = rows.ends[law][0];
  outcome.across_N = (outcome.force_W - shaft.axis_W.dot(outcome.force_W) * shaft.axis_W).norm();
  return outcome;
}

bool mayGiveWay(const PlannedConstraint& law) noexcept
{
  return law.kind == ConstraintKind::Break || law.kind == ConstraintKind::Insertion;
}

bool givesWay(const PlannedConstraint& law, const ConstraintOutcome& outcome) noexcept
{
  return law.kind == ConstraintKind::Break ? outcome.force_W.norm() > law.strength_N
                                           : outcome.across_N > law.tear_N || outcome.rest_u.x() < 0.0;
}

std::optional<ConstraintChange> changeConstraint(
  const PlannedConstraint& law, const ConstraintOutcome& outcome, ConstraintState& state) noexcept
{
  if (law.kind == ConstraintKind::Break && givesWay(law, outcome))
  {
    state.phase = ConstraintPhase::Gone;
    return ConstraintChange::Broken;
  }
  if (law.kind == ConstraintKind::Puncture && state.met && state.phase != ConstraintPhase::Inside &&
      outcome.push_N > law.strength_N)
  {
    state.phase = ConstraintPhase::Inside;
    state.placed = true;
    state.stuck_u = Vec3::Zero();
    return ConstraintChange::Punctured;
  }
  if (!inShaft(law, state) || !givesWay(law, outcome))
  {
    return std::nullopt;
  }
  const ConstraintChange change =
    outcome.across_N > law.tear_N ? ConstraintChange::TornOut : ConstraintChange::Withdrawn;
  state.phase = law.kind == ConstraintKind::Insertion ? ConstraintPhase::Gone : ConstraintPhase::Open;
  state.met = state.placed = false;
  return change;
}

} // namespace palpate
