// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSMHapticSessionProxy
 * @brief   proxy of a session that follows the values which the session sets by itself
 *
 * FitWorkspace sets scale, rotation and offset, a labyrinth ball and walls too; marks are set at contacts, sources
 * switched off by name. Here they are read back into the properties, in any case, so that the panel shows them, a state
 * file keeps them and the next change of another property does not undo them.
 */
#ifndef vtkSMHapticSessionProxy_h
#define vtkSMHapticSessionProxy_h

#include "vtkHapticViewsModule.h" // for the export macro
#include "vtkSMProxy.h"

class VTKHAPTICVIEWS_EXPORT vtkSMHapticSessionProxy : public vtkSMProxy
{
public:
  static vtkSMHapticSessionProxy* New();
  vtkTypeMacro(vtkSMHapticSessionProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values that the session sets by itself while it is told others are told after those: no observer hears of an
  /// update whose values have not all arrived.
  void UpdateVTKObjects() override;

protected:
  vtkSMHapticSessionProxy() = default;
  ~vtkSMHapticSessionProxy() override = default;

  void CreateVTKObjects() override;

private:
  void ReadBack();

  bool Telling = false;
};

#endif
