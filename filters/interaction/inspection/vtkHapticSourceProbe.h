// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSourceProbe_h
#define vtkHapticSourceProbe_h

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "haptics/core/Types.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkCell;
class vtkDataObject;
class vtkDataSet;
class vtkStaticCellLocator;

/// The data of a source at a point.
struct vtkHapticProbed
{
  vtkIdType Cell = -1;  ///< nearest to the place; of the source itself if the data name it, else of the data
  vtkIdType Point = -1; ///< of that cell, the one that counts most there
  palpate::Vec3 Nearest = palpate::Vec3::Zero(); ///< to the place, of that cell
  /// Arrays of points, interpolated, and of cells; of more components each as name_0, name_1 and so on.
  std::vector<std::pair<std::string, double>> Values;
};

/// Looks up cells, points and arrays at places of data sets. The search structure is made for each data set
/// with the first place that is asked for (about a second for a million cells) and kept while that stays the same.
class vtkHapticSourceProbe
{
public:
  vtkHapticSourceProbe();
  ~vtkHapticSourceProbe();

  /// `data`: a data set, or a composite of them. `at`: in its own frame.
  vtkHapticProbed Look(vtkDataObject* data, const palpate::Vec3& at);
  /// Whether a cell of that id, as Look() gives it, has the place, but for rounding to single precision.
  static bool Holds(vtkDataObject* data, vtkIdType cell, const palpate::Vec3& at);
  /// Forgets all but the data sets that were asked for since the last call.
  void Forget();

private:
  struct Known
  {
    vtkSmartPointer<vtkStaticCellLocator> Locator;
    vtkMTimeType MTime = 0;
    bool Used = false;
  };
  vtkStaticCellLocator* LocatorOf(vtkDataSet* data);

  std::map<vtkSmartPointer<vtkDataSet>, Known> Sets;
};

#endif
