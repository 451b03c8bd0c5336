// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticMouseInput
 * @brief   leads a vtkHapticMouse by mouse and keyboard in a window, beside the camera
 *
 * The hand follows the pointer. Shift and the left button press; while they do the wheel goes deeper and less deep, as
 * it does with Shift alone. Arrow keys move the hand by ten pixels, with Shift by one; Page Down presses, and again
 * goes deeper; Page Up goes less deep; Home lifts; in a plane world nothing presses. A hand that advances
 * (vtkHapticMouse) goes on by a notch where another one would go deeper. Everything else, and all of it
 * while the mouse leads no hand, is left to the window's own style.
 */
#ifndef vtkHapticMouseInput_h
#define vtkHapticMouseInput_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the implementation

class vtkHapticMouse;
class vtkRenderWindowInteractor;

class VTKHAPTICINTERACTION_EXPORT vtkHapticMouseInput : public vtkObject
{
public:
  static vtkHapticMouseInput* New();
  vtkTypeMacro(vtkHapticMouseInput, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whose hand it leads; whose events it hears, before styles and widgets; null: none. The interactor is watched, not
  /// kept.
  void SetMouse(vtkHapticMouse* mouse);
  void SetInteractor(vtkRenderWindowInteractor* interactor);
  ///@}

protected:
  vtkHapticMouseInput();
  ~vtkHapticMouseInput() override;

private:
  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
