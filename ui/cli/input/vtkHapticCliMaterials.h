// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliMaterials_h
#define vtkHapticCliMaterials_h

#include <CLI/App.hpp>

#include "vtkHapticMaterialArrays.h"

/// The options that say which arrays of a file make its stiffness, friction and texture, for one command. `settings`
/// is filled while the command line is read and has to be checked afterwards.
void vtkHapticCliAddMaterials(CLI::App& command, vtkHapticMaterialSettings& settings);

/// Throws vtkHapticCliProblem naming the range that cannot be used.
void vtkHapticCliCheckMaterials(const vtkHapticMaterialSettings& settings);

#endif
