// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticDeviceCheck
 * @brief   checks the chosen device of a session, and keeps the result
 */
#ifndef vtkHapticDeviceCheck_h
#define vtkHapticDeviceCheck_h

#include "vtkHapticSessionPart.h"

class VTKHAPTICINTERACTION_EXPORT vtkHapticDeviceCheck : public vtkHapticSessionPart
{
public:
  vtkAbstractTypeMacro(vtkHapticDeviceCheck, vtkHapticSessionPart);
  static vtkSmartPointer<vtkHapticDeviceCheck> Of(vtkHapticSession& session);

  /// Order of the states as GetState() gives them; all from CheckPassed on are final.
  enum States
  {
    CheckNone,
    CheckRuns,
    CheckPassed,
    CheckFaulty,
    CheckInconclusive,
    CheckAborted
  };

  ///@{
  /**
   * Checks the chosen device with a person who follows GetAsk(): noise, ends, then pushes of at most a tenth of its
   * force and half a second each, by motors alone, into walls that the device holds, and against its viscosity;
   * anything unexpected ends them at once. Not while touching; a device without force is refused. Simulated hands
   * follow it as well. The session's Update() follows it; the result is "" before the end, progress 0 to 1.
   */
  void Start();
  void Stop();
  int GetState() const;
  double GetProgress() const;
  const char* GetAsk() const;
  const char* GetResult() const;
  ///@}

  ///@{
  /**
   * Folder with the checks of devices: directions, ends, and whether walls may be left to them; that holds for this
   * session only where a device has no serial number. Applied whenever a device is opened; one whose file is damaged is
   * refused by name. "" (default): none is. KeepCalibration() adds the result of a passed check; false, with the
   * session's GetProblem(), if there is none or it cannot be written.
   */
  void SetCalibrationFolder(const char* folder);
  const char* GetCalibrationFolder() const;
  bool KeepCalibration();
  ///@}

private:
  explicit vtkHapticDeviceCheck(vtkHapticSession& session) : vtkHapticSessionPart(session) {}
};

#endif
