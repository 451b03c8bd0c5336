// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticWholeInput_h
#define vtkHapticWholeInput_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for the return type

class vtkBoundingBox;
class vtkDataObject;
class vtkDataSet;
class vtkInformationVector;
class vtkPolyData;

/// A hand goes through all of a surface, whichever ranks its pieces are on, and a measurement on a part is wrong.
/// Every rank must ask, and asks in the same order. The number of this rank; 0 where there is one alone.
VTKHAPTICPIPELINE_EXPORT int vtkHapticRank();

/// How many ranks there are.
VTKHAPTICPIPELINE_EXPORT int vtkHapticRanks();

/// All pieces of a surface, on every rank; where there is one rank the surface itself. Null if there is none.
VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkDataObject> vtkHapticWholeSurface(vtkDataObject* piece);

/// All pieces of a surface as one, on the first rank; the others have nothing.
VTKHAPTICPIPELINE_EXPORT void vtkHapticGatherSurface(vtkPolyData* piece, vtkPolyData* whole);

/// All pieces of a surface or of cells that fill space as one data set, whose points are no two in one place, on the
/// first rank; the others have an empty one. Where there is one rank the data set itself. Null if there is none.
VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkDataSet> vtkHapticGatherDataSet(vtkDataSet* piece);

/// Whether it holds on every rank. Who fails alone leaves the others waiting in the filter that comes next.
VTKHAPTICPIPELINE_EXPORT bool vtkHapticHoldsOnAllRanks(bool own);

/// Of a number that each rank has: the sum and the largest; and around the boxes of all.
VTKHAPTICPIPELINE_EXPORT double vtkHapticSumOfRanks(double own);
VTKHAPTICPIPELINE_EXPORT double vtkHapticLargestOfRanks(double own);
VTKHAPTICPIPELINE_EXPORT vtkBoundingBox vtkHapticBoxOfRanks(const vtkBoundingBox& own);

/// The one piece of a path or of marks that has points or rows, on every rank; null if several have: nothing says in
/// which order they follow one another.
VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkDataObject> vtkHapticOnePiece(vtkDataObject* piece);

/// Asks for a whole image on this rank: to be called where the extent of an input is requested. Readers and sources of
/// images give every rank its requested extent.
VTKHAPTICPIPELINE_EXPORT void vtkHapticAskForWholeImage(vtkInformationVector* input);

#endif
