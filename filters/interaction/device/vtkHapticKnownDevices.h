// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticKnownDevices
 * @brief   the devices that a session can use, and the link to the one that runs
 */
#ifndef vtkHapticKnownDevices_h
#define vtkHapticKnownDevices_h

#include "vtkHapticSessionPart.h"

#include <memory> // for an argument

namespace palpate
{
class HidBus;
}

class VTKHAPTICINTERACTION_EXPORT vtkHapticKnownDevices : public vtkHapticSessionPart
{
public:
  vtkAbstractTypeMacro(vtkHapticKnownDevices, vtkHapticSessionPart);
  static vtkSmartPointer<vtkHapticKnownDevices> Of(vtkHapticSession& session);

  ///@{
  /// Devices this build knows and those that were plugged in when they were last looked for, why one cannot be used (""
  /// when it can), and whether a program must lead its hand. Looking takes milliseconds.
  void Look();
  int GetNumberOfDevices() const;
  const char* GetName(int index) const;
  const char* GetProblem(int index) const;
  bool GetForPrograms(int index) const;
  /// The most likely choice: an attached device with force, else an attached device, else the mouse.
  const char* GetPreferred() const;
  ///@}

#ifndef __VTK_WRAP__
  /// Where devices of the USB bus are looked for; null (default): on this computer.
  void SetHidBus(std::shared_ptr<palpate::HidBus> bus);
#endif

  ///@{
  /// The link to a running device of this computer's USB bus: reports with the hand in the last second [Hz]; writes
  /// that hung, losses (stalls included), reports that were no known ones or too short, effects that were renewed.
  double GetLinkRate() const;
  vtkIdType GetLinkStalls() const;
  vtkIdType GetLinkLosses() const;
  vtkIdType GetLinkStrange() const;
  vtkIdType GetLinkRestarts() const;
  ///@}

private:
  explicit vtkHapticKnownDevices(vtkHapticSession& session) : vtkHapticSessionPart(session) {}
};

#endif
