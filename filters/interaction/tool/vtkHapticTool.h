// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticTool_h
#define vtkHapticTool_h

#include "haptics/session/tool/ToolWorker.h"
#include "haptics/tick/base/HapticState.h"
#include "vtkHapticFeltSource.h"
#include "vtkHapticHeldAxis.h"
#include "vtkHapticToolHandle.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>

/// A pose as a place and a turn (w, x, y, z).
void vtkHapticPutPose(const palpate::Pose& from, double pose[7]);

/// The tool that the hand of a session holds in place of the ball: its source, its mesh, its status.
class vtkHapticTool : public vtkHapticFeltSource
{
public:
  vtkHapticToolHandle Handle = vtkHapticToolHandle::Centre;
  palpate::Vec3 HandlePoint_T = palpate::Vec3::Zero(); ///< [u], in the tool's data, as the tip
  palpate::Vec3 TipPoint_T = palpate::Vec3::Zero();
  double Lever_u = 0.0; ///< 0: the tool's own, or the distance from handle to tip

  const char* Setting() const override { return "ToolSource"; }
  const char* Subject() const override { return "tool"; }
  bool IsHeld() const override { return true; }
  void Choose(palpate::HapticSession& core) const override;
  std::string Refusal(const palpate::HapticSession& core) const override; ///< on a soft body
  /// The same data by other settings, or only with another lever.
  std::string TakeAgain();
  std::string TakeLever();
  const palpate::ToolChoice& Choice() const { return this->Chosen; }
  void GetShape(vtkPolyData* shape) const;
  /// From the handle to the tip; without a handle from the hand to the middle of the tool, or where that is in the
  /// hand, down the longest side of its box. Nothing: no tool is held.
  std::optional<vtkHapticHeldAxis> Axis() const;

  std::string Contacts;
  double Pose[7] = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 };
  double HandPose[7] = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 };
  double Tip[3] = { 0.0, 0.0, 0.0 };
  double Asked[3] = { 0.0, 0.0, 0.0 };
  double Given[3] = { 0.0, 0.0, 0.0 };

private:
  std::string Convert(vtkDataObject* data, const std::string& reason) override;
  bool IsMade() const override { return this->Chosen.tool != nullptr; }
  void Look(palpate::HapticSession& core, const palpate::HapticState& state, double now_s) override;
  std::string Sentence(palpate::HapticSession& core, const palpate::HapticState& state) const override;
  const char* Absent() const override;
  std::string PressingText(const palpate::HapticSession& core, const palpate::HapticState& state) const;
  std::string Make();
  std::string MakeTool();
  double LeverNow_u() const;
  void PutPose(const palpate::Pose& centre_W, double pose[7]) const;

  std::shared_ptr<const palpate::TriangleMesh> Mesh;
  palpate::ToolChoice Chosen;
  vtkSmartPointer<vtkPolyData> Shape; ///< of the held tool
};

#endif
