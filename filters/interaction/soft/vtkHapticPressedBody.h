// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPressedBody_h
#define vtkHapticPressedBody_h

#include "haptics/session/soft/SoftWorker.h"
#include "haptics/tick/HapticState.h"

#include "vtkHapticSoftBodyData.h"

#include <memory>
#include <string>

namespace palpate
{
class HapticSession;
}

class vtkDataObject;
class vtkUnstructuredGrid;

/// The soft body of a session: what was asked for, what was made of it, how it is.
class vtkHapticPressedBody
{
public:
  std::string Source;    ///< that is asked for; "": none
  double Rate_Hz = 30.0; ///< packets a second

  /// Takes what a source has, null: it is not there. Empty, or why it cannot give way; then it does not.
  std::string Take(const std::string& name, vtkDataObject* data);
  palpate::SoftChoice Choice() const { return { this->Input, this->Name, this->Rate_Hz }; }
  /// How it is at that time, after each look at the session.
  void Follow(palpate::HapticSession& core, const palpate::HapticState& state, double now_s);
  /// The body as it is bent; false, and unchanged, where it is as it was when it was asked for last.
  bool Bend(vtkUnstructuredGrid& body);

  bool ShowHand = false; ///< where it was when the body was computed last
  palpate::Vec3 Hand_W = palpate::Vec3::Zero();

  std::string Text;
  double Strain = 0.0;
  double PacketsPerSecond = 0.0;

private:
  std::string Sentence(const palpate::HapticState& state) const;
  void CountPackets(double now_s);

  std::string Name;
  std::string Problem;
  std::string Material; ///< in words
  std::shared_ptr<const palpate::SoftBodyInput> Input;
  palpate::SoftStatus Status;
  std::shared_ptr<const palpate::BodyShape> Shown;
  vtkHapticBall Ball; ///< that presses it
  std::uint64_t CountedPackets = 0;
  double Counted_s = 0.0;
};

#endif
