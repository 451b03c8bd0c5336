// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMechanismData_h
#define vtkHapticMechanismData_h

#include <string>
#include <vector>

#include "vtkHapticMechanismFile.h"
#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPolyData;

/// The surfaces of a mechanism's bodies as they are at first: those that are held about the origin. The cell array Body
/// says which.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkPolyData> vtkHapticMechanismShapes(
  const vtkHapticMechanismResult& read);

/// Describes a mechanism by the text of its file and the folder of that, as field data.
VTKHAPTICPIPELINE_EXPORT void vtkHapticDescribeMechanism(
  vtkDataObject& data, const std::string& text, const std::string& folder);

/// Whether data describe a mechanism.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsMechanism(vtkDataObject* data);

/// The text of the scene file that data describe a mechanism by, and the folder of that; "": they do not.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticMechanismFileOf(vtkDataObject& data);
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticMechanismFolderOf(vtkDataObject& data);

/// Data that were brought from a server: the folder is one of the server's.
VTKHAPTICPIPELINE_EXPORT void vtkHapticSetOfServer(vtkDataObject& data);
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsOfServer(vtkDataObject& data);

/// The mechanism that data describe.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticMechanismResult vtkHapticToMechanism(vtkDataObject& data);

/// What a mechanism becomes, a line each.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<std::string> vtkHapticMechanismText(
  const palpate::MechanismInputs& inputs, const palpate::MechanismCheck& check);

#endif
