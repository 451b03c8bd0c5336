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
  /// All bodies begin anew where the scene file has them, loose sources where their data are; false: there are none.
  bool PutBack();
  /// How dense a source is [kg/m3]. Above 0 it is a loose body from the next tick on, with the mass of the volume in
  /// its closed surface; 0: it is fixed. LooseText says how it is. False, with GetProblem(), for values that are not
  /// allowed.
  bool SetDensity(const char* source, double density);
  double GetDensity(const char* source) const;
  bool BreakConstraint(const char* name); ///< it holds no more until the mechanism begins anew; false: there is none

private:
  explicit vtkHapticTouchedMechanism(vtkHapticSession& session) : vtkHapticSessionPart(session) {}
};

#endif
