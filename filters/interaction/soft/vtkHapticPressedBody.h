// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPressedBody_h
#define vtkHapticPressedBody_h

#include "haptics/session/soft/SoftWorker.h"
#include "haptics/tick/base/HapticState.h"

#include "vtkHapticFeltSource.h"
#include "vtkHapticSoftBodyData.h"

#include <memory>
#include <string>

class vtkUnstructuredGrid;

/// The soft body of a session: its source, its input, its status.
class vtkHapticPressedBody : public vtkHapticFeltSource
{
public:
  double Rate_Hz = 30.0; ///< snapshots a second

  const char* Setting() const override { return "SoftSource"; }
  const char* Subject() const override { return "soft body"; }
  bool IsHeld() const override { return false; }
  void Choose(palpate::HapticSession& core) const override;
  /// The body as it is bent; false, and unchanged, where it is as it was when it was asked for last.
  bool Bend(vtkUnstructuredGrid& body);

  palpate::Vec3 Hand_W = palpate::Vec3::Zero(); ///< where it was when the body was computed last

  double Strain = 0.0;
  double PacketsPerSecond = 0.0;

private:
  std::string Convert(vtkDataObject* data, const std::string& reason) override;
  bool IsMade() const override { return this->Input != nullptr; }
  void Look(palpate::HapticSession& core, const palpate::HapticState& state, double now_s) override;
  std::string Sentence(palpate::HapticSession& core, const palpate::HapticState& state) const override;
  const char* Absent() const override;
  void CountPackets(double now_s);

  std::string Material; ///< in words
  std::shared_ptr<const palpate::SoftBodyInput> Input;
  palpate::SoftStatus Status;
  bool Pressed = false, IsFelt = false; ///< by the ball, or by a tool
  double Age_s = 0.0;                   ///< of the state at which its snapshot was made
  std::shared_ptr<const palpate::BodyShape> Shown;
  vtkHapticBall Ball; ///< that presses it
  std::uint64_t CountedPackets = 0;
  double Counted_s = 0.0;
};

#endif
