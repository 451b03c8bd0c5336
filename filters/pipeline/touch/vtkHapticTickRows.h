// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticTickRows_h
#define vtkHapticTickRows_h

#include <cstddef>
#include <vector>

#include "haptics/core/Types.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

/// What happened in one tick, in W.
struct vtkHapticTickRow
{
  palpate::Vec3 Proxy_W;
  palpate::Vec3 Device_W;
  palpate::Vec3 Force_W; ///< on the hand [N]
  int Contacts = 0;
  double Time = 0.0; ///< [s]
};

/// The output of a touch along a path while it grows: the way of the proxy as a polyline, one row a tick.
class vtkHapticTickRows
{
public:
  explicit vtkHapticTickRows(std::size_t count);

  void Set(std::size_t row, const vtkHapticTickRow& tick);
  /// An array beside those of every touch; the rows hold it until MoveTo().
  vtkDoubleArray* Add(const char* name, int components);
  void MoveTo(vtkPolyData* output);

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Force;
  vtkNew<vtkDoubleArray> Depth;
  vtkNew<vtkIntArray> Contacts;
  vtkNew<vtkDoubleArray> Device;
  vtkNew<vtkDoubleArray> Time;
  std::vector<vtkSmartPointer<vtkDoubleArray>> More;
};

#endif
