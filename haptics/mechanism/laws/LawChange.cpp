// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/laws/LawChange.h"

namespace palpate
{
namespace
{

void addRow(const LawScene& scene, const LawRow& row, double force_N, double moved_u, LawOutcome& outcome) noexcept
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
    const LawState& state = scene.laws[row.law];
    const bool atBound = force_N <= row.lowest_N || force_N >= row.highest_N;
    outcome.slips = atBound && moved_u != 0.0;
    outcome.rest_u.x() = (state.placed ? state.stuck_u.x() : row.now_u) + moved_u;
  }
}

/// Where Coulomb's contact rests: where it was but for its slip; where it is, while it is open.
void restCone(
  const LawScene& scene, const LawRows& rows, const LawForces& forces, int first, LawOutcome& outcome) noexcept
{
  const LawRow& normal = rows.rows[first];
  const LawState& state = scene.laws[normal.law];
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

LawOutcome outcomeOf(const LawScene& scene, const LawRows& rows, const LawForces& forces, int law) noexcept
{
  LawOutcome outcome;
  outcome.rest_u = scene.laws[law].stuck_u;
  for (int i = 0; i < rows.count; ++i)
  {
    const LawRow& row = rows.rows[i];
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
  const LawEnd& shaft = rows.ends[law][0];
  outcome.across_N = (outcome.force_W - shaft.axis_W.dot(outcome.force_W) * shaft.axis_W).norm();
  return outcome;
}

bool mayGiveWay(const PlannedLaw& law) noexcept
{
  return law.kind == LawKind::Break || law.kind == LawKind::Insertion;
}

bool givesWay(const PlannedLaw& law, const LawOutcome& outcome) noexcept
{
  return law.kind == LawKind::Break ? outcome.force_W.norm() > law.strength_N
                                    : outcome.across_N > law.tear_N || outcome.rest_u.x() < 0.0;
}

std::optional<LawChange> changeLaw(const PlannedLaw& law, const LawOutcome& outcome, LawState& state) noexcept
{
  if (law.kind == LawKind::Break && givesWay(law, outcome))
  {
    state.phase = LawPhase::Gone;
    return LawChange::Broken;
  }
  if (law.kind == LawKind::Puncture && state.met && state.phase != LawPhase::Inside && outcome.push_N > law.strength_N)
  {
    state.phase = LawPhase::Inside;
    state.placed = true;
    state.stuck_u = Vec3::Zero();
    return LawChange::Punctured;
  }
  if (!inShaft(law, state) || !givesWay(law, outcome))
  {
    return std::nullopt;
  }
  const LawChange change = outcome.across_N > law.tear_N ? LawChange::TornOut : LawChange::Withdrawn;
  state.phase = law.kind == LawKind::Insertion ? LawPhase::Gone : LawPhase::Open;
  state.met = state.placed = false;
  return change;
}

} // namespace palpate
