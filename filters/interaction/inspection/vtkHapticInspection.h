// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticInspection
 * @brief   contact and marks of a session
 */
#ifndef vtkHapticInspection_h
#define vtkHapticInspection_h

#include "vtkHapticSessionPart.h"

#include <string> // for the return type

class vtkHapticMarkRecords;
class vtkPolyData;
class vtkTable;

class VTKHAPTICINTERACTION_EXPORT vtkHapticInspection : public vtkHapticSessionPart
{
public:
  vtkAbstractTypeMacro(vtkHapticInspection, vtkHapticSessionPart);
  static vtkSmartPointer<vtkHapticInspection> Of(vtkHapticSession& session);

  ///@{
  /**
   * The data at the contact: source, cell, point and arrays as they were added, the place and normal in W, curvature
   * and the wall behind it. GetMarks() gives points, GetMarksTable() a table, the setting MarksText has the text for
   * HapticMarks; WriteMarks() writes csv or vtp by the suffix; false with GetProblem(). The first place on a source
   * takes longer: a second for a million cells. A mark holds while the cell that it was set on is where the mark is;
   * else its source has changed or moved, and it is stale. One whose source is not in the scene is unseen.
   */
  enum MarkStates
  {
    MarkUnseen,
    MarkHolds,
    MarkStale
  };
  int GetMarkState(int mark) const;
  bool WriteMarks(const char* file);
  /// Replaces the marks by those of a csv file; false with GetProblem(), and the marks stay.
  bool ReadMarks(const char* file);
  /// The text of the marks that were written or read last; "": none were.
  std::string GetSavedMarks() const;
  bool AddMarkAt(const char* name, double x, double y, double z); ///< in W, on no source
  bool RemoveMark(int mark);                                      ///< counted from 0; the others move up
  bool RenameMark(int mark, const char* name);                    ///< "": its number stands for it
  std::string GetMarkName(int mark) const;                        ///< "": it has none
  void GetMarkPosition(int mark, double position[3]) const;       ///< in W; NaN where there is no such mark
  void GetMarks(vtkPolyData* points) const;
  void GetMarksTable(vtkTable* table) const;
  void GetContactInData(double position[3]) const; ///< in the frame of its source's data; NaN before InspectContact()
  double GetValue(const char* name) const;         ///< of an array there, name_k of a vector; NaN where there is none
  ///@}

private:
  bool Refuses(int mark);
  void Keep(vtkHapticMarkRecords marks);

  explicit vtkHapticInspection(vtkHapticSession& session) : vtkHapticSessionPart(session) {}
};

#endif
