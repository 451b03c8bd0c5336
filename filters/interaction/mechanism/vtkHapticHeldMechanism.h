// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHeldMechanism_h
#define vtkHapticHeldMechanism_h

#include "haptics/session/HapticSession.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkPolyData;
class vtkTable;

/// The mechanism of a session: what was asked for, what was made of it, how it is.
class vtkHapticHeldMechanism
{
public:
  std::string Source; ///< that is asked for; "": none
  std::string Laws;   ///< a list of laws in place of those of its scene file; "": those

  /// Takes what a source has, null: it is not there. Empty, or why it cannot be held; then none is.
  std::string Take(const std::string& name, vtkDataObject* data);
  /// The same data by other laws.
  std::string TakeAgain();
  palpate::MechanismChoice Choice(double rate_Hz) const { return { this->Inputs, this->Name, rate_Hz }; }
  /// What Laws is with another law, as an object of a scene file, and with one less; "" with a problem.
  std::string With(const std::string& law, std::string& problem) const;
  std::string Without(const std::string& name, std::string& problem) const;
  /// The place of a law in the mechanism; -1: there is none.
  int IndexOf(const std::string& name) const;
  /// How it is, after each look at the session.
  void Follow(palpate::HapticSession& core, const palpate::HapticState& state);
  /// The bodies that `shapes` has where they are at first, where they are now; false: none has moved.
  bool Move(vtkPolyData& shapes) const;
  /// A row a law: Law, Kind, A, B, Phase, Force [N], Inside [u].
  void FillTable(vtkTable& table) const;

  std::string Text;
  double Depth = 0.0; ///< the hand's way along what it holds since nothing pushed [u]

private:
  std::string Sentence(palpate::HapticSession& core) const;

  std::string Name;
  std::string File, Folder; ///< text of the scene file, and where that lies
  std::string Problem;
  bool OfServer = false;
  std::shared_ptr<const palpate::MechanismInputs> Inputs;
  palpate::MechanismNow Now;
  palpate::Vec3 Begin_W = palpate::Vec3::Zero(); ///< where that way begins
};

#endif
