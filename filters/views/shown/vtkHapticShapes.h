// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticShapes_h
#define vtkHapticShapes_h

#include <cstdint>
#include <functional>
#include <map>

#include "vtkHapticShape.h"

class vtkGlyph3DMapper;
class vtkMapper;
class vtkPVImageSliceMapper;

/// Geometry that mappers draw, made anew only once their input has changed: a view is looked at with each picture.
class vtkHapticShapes
{
public:
  vtkHapticShape GlyphsOf(vtkGlyph3DMapper* mapper);
  vtkHapticShape SliceOf(vtkPVImageSliceMapper* mapper);
  /// Forgets the geometry that was not asked for since the last call.
  void Forget();

private:
  struct Made
  {
    std::uint64_t Key = 0;
    vtkHapticShape Shape;
    bool Used = false;
  };
  vtkHapticShape Find(vtkMapper* mapper, std::uint64_t key, const std::function<vtkHapticShape()>& make);

  std::map<const vtkMapper*, Made> Known; ///< another mapper at the same address has another key
};

#endif
