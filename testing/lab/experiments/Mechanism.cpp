// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 65 and 66: a needle as a lever in a wall and an organ, and its path in and out. An object that moves, touched
// through a spring or by a force that is held for it: direct-coupling.
#include <algorithm>
#include <cmath>

#include "testing/lab/Experiments.h"
#include "testing/support/LeverRig.h"

namespace palpate::lab
{
namespace mechanism_experiment
{

using test::kc;
using Lever = test::NeedleLever;
using Two = Lever::Two;

constexpr double hand_m = 5e-3; ///< so far the hand goes across the needle

Two forceByMechanism_N(const Lever& lever)
{
  test::LeverRig rig(lever);
  return rig.force_N(hand_m);
}

void judgeLever(Table& table)
{
  constexpr const char* whole = "ours: one problem in the laws' rows";
  constexpr const char* diagonal = "each spot by itself";
  for (const double turning_Nm : { 0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0 })
  {
    const std::string name = caseName({ { "turning", turning_Nm } });
    const Lever lever{ turning_Nm };
    // A turn that only balance holds is taken as small in a tick.
    const Two truth = turning_Nm > 0.0 ? lever.forceOfTurn_N(hand_m) : lever.forceByEnergy_N(hand_m);
    const Two ours = forceByMechanism_N(lever);
    table.within({ name, whole, "force of the wall", "N" }, ours[0], truth[0], 1e-9);
    table.within({ name, whole, "force of the organ", "N" }, ours[1], truth[1], 1e-9);
    table.within({ name, whole, "force on the hand", "N" }, ours.sum(), truth.sum(), 1e-9);
    if (turning_Nm > 0.0) // each by itself, a hand that leaves the turn free feels nothing
    {
      const Two alone = lever.forceBySpot_N(hand_m);
      table.info({ name, diagonal, "force of the wall", "N" }, alone[0]);
      table.info({ name, diagonal, "force of the organ", "N" }, alone[1]);
      table.info({ name, diagonal, "force on the hand", "N" }, alone.sum());
    }
  }
  table.within({ "turn left free", whole, "felt stiffness", "N/m" }, -forceByMechanism_N(Lever{}).sum() / hand_m,
    4000.0 / 27.0, 1e-9 * 4000.0 / 27.0);
  const Lever held{ test::kr };
  const Two truth = held.forceByEnergy_N(hand_m);
  const Two alone = held.forceBySpot_N(hand_m);
  table.atLeast({ "turn held", diagonal, "too much force on the hand by" }, alone.sum() / truth.sum() - 1.0, 0.2);
  table.atLeast({ "turn held", diagonal, "organ pushes where it is pulled, times" }, -alone[1] / truth[1], 1.0);
}

/// The stroke of docs/theory.md, "Constraints between bodies".
constexpr double punctured_N = 1.5, rubs_N = 0.4, stroke_m = 0.02, rod_m = 0.1;
constexpr double yield_m_per_N = 1.0 / kc + 1.0 / test::tissue;

/// A needle in a hand, pushed into a tissue and drawn back.
class Stroke
{
public:
  double puncture_m = -1.0;
  double reversal_m = -1.0;
  double work_J = 0.0;

  Stroke()
  {
    this->rig_.addSoft(
      "tissue", test::springWall("tissue", Vec3(0.0, 0.0, rod_m), -Vec3::UnitZ(), 0.02, 1.0 / test::tissue));
    MechanismConstraint& law = this->rig_.join(ConstraintKind::Puncture, "tissue", Vec3::Zero(), Vec3::Zero());
    law.strength_N = punctured_N;
    law.dryFriction_N = rubs_N;
    (void)this->rig_.step(Vec3(0.0, 0.0, -1e-3));
  }

  const MechanismResult& to(double hand, bool back)
  {
    const MechanismResult& r = this->rig_.step(Vec3(0.0, 0.0, hand));
    const double force_N = -r.exact_W.force.z();
    this->work_J += 0.5 * (this->before_N_ + force_N) * (hand - this->before_m_);
    if (r.eventCount > 0)
    {
      this->puncture_m = hand;
      this->work_J += 0.5 * (punctured_N - force_N) * (hand - this->before_m_); // up to the puncture it rose
    }
    if (back && this->reversal_m < 0.0 && force_N <= -rubs_N + 1e-12)
    {
      this->reversal_m = stroke_m - hand;
    }
    this->before_N_ = force_N;
    this->before_m_ = hand;
    return r;
  }

private:
  test::MechanismRig rig_{ rod_m };
  double before_N_ = 0.0;
  double before_m_ = 0.0;
};

/// Of a tick that a chart shows: sixty in each direction, and the one of the puncture.
void drawn(Table& table, double hand, bool back, const MechanismResult& r)
{
  const std::string name = caseName({ { "hand_mm", 1e3 * hand }, { "back", back ? 1.0 : 0.0 } });
  table.info({ name, "as the laws have it", "force", "N" }, -r.exact_W.force.z());
  table.info({ name, "ours: as it is felt", "force", "N" }, -r.wrench_W.force.z());
}

void judgeStroke(const Conditions& conditions, Table& table)
{
  const int steps = conditions.pick(12000, 24000, 240000);
  Stroke stroke;
  for (int i = 0; i <= 2 * steps; ++i)
  {
    const bool back = i > steps;
    const double hand = stroke_m * (back ? 2 * steps - i : i) / steps;
    const MechanismResult& r = stroke.to(hand, back);
    if (i % (steps / 60) == 0 || r.eventCount > 0)
    {
      drawn(table, hand, back, r);
    }
  }
  const auto judge = [&table](const char* quantity, const char* unit, double value, double truth) {
    table.within({ "stroke of 20 mm", "ours: puncture", quantity, unit }, value, truth, 1e-3 * truth);
  };
  judge("where it punctures", "mm", 1e3 * stroke.puncture_m, 1e3 * punctured_N * yield_m_per_N);
  judge("way of the reversal", "mm", 1e3 * stroke.reversal_m, 2e3 * rubs_N * yield_m_per_N);
  // The surface's spring until it breaks, then the friction of the hole, in and out, but for the reversal.
  const double work_J = 0.5 * punctured_N * punctured_N * yield_m_per_N +
                        rubs_N * (stroke_m - punctured_N * yield_m_per_N) +
                        rubs_N * (stroke_m - 2.0 * rubs_N * yield_m_per_N);
  judge("work of the stroke", "mJ", 1e3 * stroke.work_J, 1e3 * work_J);
}

} // namespace mechanism_experiment

void runMechanism(const Conditions& conditions, Table& table)
{
  using namespace mechanism_experiment;
  judgeLever(table);
  judgeStroke(conditions, table);
}

} // namespace palpate::lab
