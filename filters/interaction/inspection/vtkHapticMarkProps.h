// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticMarkProps
 * @brief   the marks of a session in a renderer: a ball and a label each, of the same size on the screen at any
 * distance
 *
 * The label has the number of the mark, counted from 1, and its name. None is picked or counted in the bounds of a
 * scene.
 */
#ifndef vtkHapticMarkProps_h
#define vtkHapticMarkProps_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the implementation
#include <string> // for the return type

class vtkActor;
class vtkHapticSession;
class vtkRenderer;

class VTKHAPTICINTERACTION_EXPORT vtkHapticMarkProps : public vtkObject
{
public:
  static vtkHapticMarkProps* New();
  vtkTypeMacro(vtkHapticMarkProps, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// One renderer at a time; the props leave the one before. Null: none. The renderer is watched, not kept alive.
  void SetRenderer(vtkRenderer* renderer);

  /// Takes the marks of a session; null has none.
  void UpdateFrom(vtkHapticSession* session);

  int GetNumberOfMarks() const;
  /// "2 lesion"; "" where there is no such mark, counted from 0.
  std::string GetLabel(int mark) const;
  vtkActor* GetBallsActor() const;

protected:
  vtkHapticMarkProps();
  ~vtkHapticMarkProps() override;

private:
  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
