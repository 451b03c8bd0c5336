// SPDX-License-Identifier: GPL-3.0-or-later
// With a rigid tool in the hand in place of a ball.
#include <memory>
#include <numbers>
#include <optional>

#include "haptics/session/path/ToolTouch.h"
#include "vtkDoubleArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticHandPath.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticTickRows.h"
#include "vtkHapticTouchedField.h"
#include "vtkPolyData.h"
#include "vtkTouchAlongPath.h"

namespace
{
constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

/// The rows of a tool, with what it has beyond a ball.
class ToolRows
{
public:
  explicit ToolRows(std::size_t count)
    : Rows(count), Torque(Rows.Add("Torque", 3)), Turn(Rows.Add("Turn", 4)), Angle(Rows.Add("Angle", 1))
  {
  }

  void Set(std::size_t row, double time, const palpate::Pose& hand_W, const palpate::ToolTouched& touched)
  {
    const auto i = static_cast<vtkIdType>(row);
    const palpate::Quat& q = touched.pose_W.q;
    this->Rows.Set(row, { touched.pose_W.p, hand_W.p, touched.wrench_W.force, touched.contacts, time });
    this->Torque->SetTuple(i, touched.wrench_W.torque.data());
    this->Turn->SetTuple4(i, q.w(), q.x(), q.y(), q.z());
    this->Angle->SetValue(i, degreesPerRadian * hand_W.q.angularDistance(q));
  }

  void MoveTo(vtkPolyData& output) { this->Rows.MoveTo(&output); }

private:
  vtkHapticTickRows Rows;
  vtkDoubleArray* Torque;
  vtkDoubleArray* Turn;
  vtkDoubleArray* Angle;
};
} // namespace

void vtkTouchAlongPath::SetToolConnection(vtkAlgorithmOutput* tool)
{
  this->SetInputConnection(3, tool);
}

void vtkTouchAlongPath::SetToolData(vtkDataObject* tool)
{
  this->SetInputDataObject(3, tool);
}

const char* vtkTouchAlongPath::OfSurfacesAlone()
{
  return this->Field->IsAskedFor() || this->GetNumberOfInputConnections(2) > 0 ? "a field"
         : this->Radius > 0.0                                                  ? "a ball's radius"
         : this->LineRadius > 0.0                                              ? "lines"
         : this->ForceShading                                                  ? "shading"
         : !this->Materials->Empty()                                           ? "material from data"
                                                                               : "";
}

std::string vtkTouchAlongPath::BesideTool()
{
  const std::string set = this->OfSurfacesAlone();
  return set.empty() ? "" : "A tool does not feel " + set + ": turn that off, or take the tool away.";
}

bool vtkTouchAlongPath::TouchWithTool(
  vtkDataObject& surface, vtkDataObject& tool, const vtkHapticHandPath& path, vtkPolyData& output)
{
  const vtkHapticConversionResult scene = vtkHapticToMesh(&surface);
  const vtkHapticConversionResult held = vtkHapticToMesh(&tool);
  std::string problem = this->BesideTool();
  problem = !problem.empty() || held.Mesh ? problem : "The tool cannot be held: " + held.Problem;
  problem = !problem.empty() || scene.Mesh ? problem : "The surface cannot be touched: " + scene.Problem;
  std::unique_ptr<palpate::ToolTouch> touch;
  if (problem.empty())
  {
    palpate::ToolHold hold;
    hold.stiffness_N_per_m = this->Stiffness;
    hold.scale_u_per_m = this->Scale;
    hold.lever_u = this->Lever != 0.0 ? std::optional(this->Lever) : std::nullopt;
    hold.friction = this->FrictionKinetic;
    hold.coupling = this->VirtualCoupling ? palpate::ToolCoupling::Virtual : palpate::ToolCoupling::Constraints;
    touch = palpate::ToolTouch::make(*held.Mesh, *scene.Mesh, hold, path.Hand(0), problem);
  }
  if (!touch)
  {
    vtkErrorMacro("Nothing was touched: " << problem);
    return false;
  }
  if (!touch->noWayOut().empty())
  {
    vtkWarningMacro("The tool " << touch->noWayOut() << ".");
  }
  const std::size_t count = path.Points_W.size();
  ToolRows rows(count);
  int unsettled = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!this->Goes(static_cast<double>(i) / static_cast<double>(count)))
    {
      return true;
    }
    const palpate::Pose hand_W = path.Hand(i);
    const palpate::ToolTouched touched = touch->next(hand_W);
    unsettled += touched.settled ? 0 : 1;
    rows.Set(i, path.Times[i], hand_W, touched);
  }
  rows.MoveTo(output);
  if (unsettled > 0)
  {
    vtkWarningMacro("In " << unsettled << " rows the tool had not come to rest.");
  }
  return true;
}
