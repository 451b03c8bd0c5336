// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticTouchedMechanism
 * @brief   the mechanism that a session holds a body of
 */
#ifndef vtkHapticTouchedMechanism_h
#define vtkHapticTouchedMechanism_h

#include "vtkHapticSessionPart.h"

#include <string> // for a result

class vtkPolyData;
class vtkTable;

class VTKHAPTICINTERACTION_EXPORT vtkHapticTouchedMechanism : public vtkHapticSessionPart
{
public:
  vtkAbstractTypeMacro(vtkHapticTouchedMechanism, vtkHapticSessionPart);
  static vtkSmartPointer<vtkHapticTouchedMechanism> Of(vtkHapticSession& session);

  bool GetIsWire() const;       ///< whether MechanismSource is a wire
  const char* GetAdded() const; ///< whose was added last; "": none since MechanismSource is another
  void SetMoved(bool moved);    ///< whether it is drawn elsewhere than it is felt, for MechanismText to say so
  /// Moves and bends shapes; false: they are as at first.
  bool Move(vtkPolyData* shapes);
  void GetTable(vtkTable* table) const; ///< one row per constraint: description, Phase, Force [N], Inside [u]
  /// The setting MechanismConstraints with another constraint, an object as in a scene file, and with one less; "",
  /// with the session's GetProblem().
  std::string GetConstraintsWith(const char* law);
  std::string GetConstraintsWithout(const char* name);
  bool PutBack(); ///< all bodies begin anew where the scene file has them; false: no mechanism is held
  bool BreakConstraint(const char* name); ///< it holds no more until the mechanism begins anew; false: there is none

private:
  explicit vtkHapticTouchedMechanism(vtkHapticSession& session) : vtkHapticSessionPart(session) {}
};

#endif
