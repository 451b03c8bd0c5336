// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticBodyFile_h
#define vtkHapticBodyFile_h

#include <string>

#include "haptics/compliance/body/SoftBody.h"
#include "vtkHapticTetraFill.h"

/// The tetrahedra of a volume file, or those that fill the closed surface of another file. The problem names the file.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticTetraFillResult vtkHapticReadBody(
  const std::string& file, const palpate::TetraSizes& sizes);

/// "linear", "corotational", "neohookean"; false: it is none of them, and `model` stays.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticModelOf(const std::string& name, palpate::ElasticModel& model);

#endif
