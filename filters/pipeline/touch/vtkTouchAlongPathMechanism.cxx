// SPDX-License-Identifier: GPL-3.0-or-later
// With what a mechanism holds in the hand.
#include <map>
#include <memory>

#include "haptics/session/mechanism/MechanismTouch.h"
#include "vtkDoubleArray.h"
#include "vtkHapticHandPath.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticTickRows.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkTouchAlongPath.h"

namespace
{
/// The rows of a mechanism: those of a tick, where the held body is turned, and what each law does.
class MechanismRows
{
public:
  MechanismRows(std::size_t count, const palpate::MechanismPlan& plan, const palpate::Mechanism& mechanism)
    : Rows(count), Held(plan.held), Torque(Rows.Add("Torque", 3)), Turn(Rows.Add("Turn", 4)),
      Residual(Rows.Add("Residual", 1))
  {
    for (const palpate::MechanismLaw& law : mechanism.laws)
    {
      this->Laws.push_back({ this->Rows.Add(("Force of " + law.name).c_str(), 3),
        this->Rows.Add(("Phase of " + law.name).c_str(), 1), this->Rows.Add(("Inside of " + law.name).c_str(), 1) });
    }
  }

  void Set(std::size_t row, double time, const palpate::Pose& hand_W, const palpate::MechanismResult& result)
  {
    const auto i = static_cast<vtkIdType>(row);
    const palpate::Pose& held_W = result.pose_W[this->Held];
    int holding = 0;
    for (std::size_t law = 0; law < this->Laws.size(); ++law)
    {
      const palpate::LawNow& now = result.laws[law];
      holding += now.force_W.squaredNorm() > 0.0 ? 1 : 0;
      this->Laws[law].Force->SetTuple(i, now.force_W.data());
      this->Laws[law].Phase->SetValue(i, static_cast<double>(now.phase));
      this->Laws[law].Inside->SetValue(i, now.inside_u);
    }
    this->Rows.Set(row, { held_W.p, hand_W.p, result.wrench_W.force, holding, time });
    this->Torque->SetTuple(i, result.wrench_W.torque.data());
    this->Turn->SetTuple4(i, held_W.q.w(), held_W.q.x(), held_W.q.y(), held_W.q.z());
    this->Residual->SetValue(i, result.residual_u);
  }

  void MoveTo(vtkPolyData& output) { this->Rows.MoveTo(&output); }

private:
  struct LawRows
  {
    vtkDoubleArray *Force, *Phase, *Inside;
  };

  vtkHapticTickRows Rows;
  int Held;
  vtkDoubleArray *Torque, *Turn, *Residual;
  std::vector<LawRows> Laws;
};
} // namespace

palpate::MechanismHold vtkTouchAlongPath::Hold() const
{
  const double arm_m = this->Lever / this->Scale;
  return { this->Stiffness, this->Stiffness * arm_m * arm_m, this->Scale, this->LowRate };
}

std::string vtkTouchAlongPath::BesideMechanism()
{
  const std::string surfaces = this->OfSurfacesAlone();
  const std::string set = !surfaces.empty()                          ? surfaces
                          : this->FrictionStatic > 0.0               ? "friction of its own"
                          : this->GetNumberOfInputConnections(3) > 0 ? "a tool"
                                                                     : "";
  return set.empty() ? "" : "a mechanism does not feel " + set + ": turn that off";
}

bool vtkTouchAlongPath::TouchMechanism(vtkDataObject& data, const vtkHapticHandPath& path, vtkPolyData& output)
{
  const vtkHapticMechanismResult read = vtkHapticToMechanism(data);
  std::string problem = !read.Problem.empty()         ? read.Problem
                        : !vtkHapticIsWhereMade(data) ? "the mechanism is not where its scene file has it: take Haptic "
                                                        "Mechanism itself, and move its bodies in that file"
                        : !(this->Lever >= 0.0)       ? "Lever: it must be a finite number of units, 0 or above"
                                                      : this->BesideMechanism();
  std::unique_ptr<palpate::MechanismTouch> touch;
  if (problem.empty())
  {
    touch = palpate::MechanismTouch::make(*read.Inputs, this->Hold(), problem);
  }
  if (!touch)
  {
    vtkErrorMacro("Nothing was touched: " << problem);
    return false;
  }
  const std::size_t count = path.Points_W.size();
  MechanismRows rows(count, touch->plan(), read.Inputs->mechanism);
  int capped = 0;
  std::map<palpate::BodyPair, int> overlaps; // in how many rows
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!this->Goes(static_cast<double>(i) / static_cast<double>(count)))
    {
      return true;
    }
    const palpate::Pose hand_W = path.Hand(i);
    const palpate::MechanismResult result = touch->next(path.Times[i], hand_W);
    capped += result.capped ? 1 : 0;
    for (const palpate::BodyPair& pair : touch->overlaps())
    {
      ++overlaps[pair];
    }
    rows.Set(i, path.Times[i], hand_W, result);
  }
  rows.MoveTo(output);
  if (capped > 0)
  {
    vtkWarningMacro("In " << capped << " rows the laws were not met within a tick's work.");
  }
  for (const auto& [pair, count] : overlaps)
  {
    vtkWarningMacro("In " << count << " rows " << palpate::overlapText(pair) << '.');
  }
  return true;
}
