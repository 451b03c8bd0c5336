// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPieces_h
#define vtkHapticPieces_h

#include <string>

class vtkInformationVector;

/// Empty, or why a filter that needs all of its data does nothing: it is asked for a part of them that no other process
/// has the rest of, and a measurement on a part is wrong without a sign of it. `output`: of the request for data.
[[nodiscard]] std::string vtkHapticRefusePieces(vtkInformationVector* output);

#endif
