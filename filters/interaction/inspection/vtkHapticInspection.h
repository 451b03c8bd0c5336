// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticInspection
 * @brief   contact and marks of a session
 */
#ifndef vtkHapticInspection_h
#define vtkHapticInspection_h

#include "vtkHapticSessionPart.h"

class vtkPolyData;
class vtkTable;

class VTKHAPTICINTERACTION_EXPORT vtkHapticInspection : public vtkHapticSessionPart
{
public:
  vtkAbstractTypeMacro(vtkHapticInspection, vtkHapticSessionPart);
  static vtkSmartPointer<vtkHapticInspection> Of(vtkHapticSession& session);

  ///@{
  /**
   * What is at the contact: its source, cell, point and arrays as it was added, the place and normal in W, curvature
   * and the wall behind it. GetMarks() gives
   * points, GetMarksTable() a table, the setting MarksText has what HapticMarks takes; WriteMarks() writes csv or vtp
   * by the suffix; false with GetProblem(). The first place on a source takes longer: a second for a million cells. A
   * mark holds while the cell that it was set on is where the mark is; else its source has changed or moved, and it is
   * stale. One whose source is not in the scene is unseen.
   */
  enum MarkStates
  {
    MarkUnseen,
    MarkHolds,
    MarkStale
  };
  int GetMarkState(int mark) const;
  bool WriteMarks(const char* file);
  void GetMarks(vtkPolyData* points) const;
  void GetMarksTable(vtkTable* table) const;
  double GetValue(const char* name) const; ///< of an array there, name_k of a vector; NaN where there is none
  ///@}

private:
  explicit vtkHapticInspection(vtkHapticSession& session) : vtkHapticSessionPart(session) {}
};

#endif
