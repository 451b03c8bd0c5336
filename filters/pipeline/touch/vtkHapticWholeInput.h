// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticWholeInput_h
#define vtkHapticWholeInput_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for the return type

class vtkDataObject;
class vtkPolyData;

/// A hand goes through all of a surface, whichever ranks its pieces are on. Every rank must ask, and asks in the same
/// order. The number of this rank; 0 where there is one alone.
VTKHAPTICPIPELINE_EXPORT int vtkHapticRank();

/// All pieces of a surface, on every rank; where there is one rank the surface itself. Null if there is none.
VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkDataObject> vtkHapticWholeSurface(vtkDataObject* piece);

/// The one piece of a path that has points, on every rank; null if several have: nothing says in which order a hand
/// goes through them.
VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkPolyData> vtkHapticWholePath(vtkPolyData* piece);

#endif
