// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticViewScan_h
#define vtkHapticViewScan_h

#include "vtkDataObject.h"        // for vtkSmartPointer<vtkDataObject>
#include "vtkHapticViewsModule.h" // for the export macro
#include "vtkMatrix4x4.h"         // for vtkSmartPointer<vtkMatrix4x4>
#include "vtkSmartPointer.h"      // for the members

#include <cstdint>
#include <string>
#include <vector>

class vtkSMSourceProxy;

/**
 * The touchable data in a render view, and the reasons for the rest.
 *
 * Go by representation, not by prop: a renderer holds about fifteen props per source. The geometry of a surface is the
 * input of the active representation's full-resolution mapper, so there is none before the first render. Shapes of
 * glyphs and of image slices are made from that input, a curve under its widget is as the widget draws it, and the
 * surfaces that a server renders are fetched from there.
 */
struct VTKHAPTICVIEWS_EXPORT vtkHapticViewScan
{
  /// A shown surface: poly data or a composite of it in the actor's frame [u], shared with the pipeline.
  struct Surface
  {
    std::string Name;
    vtkSmartPointer<vtkDataObject> Data;
    vtkSmartPointer<vtkMatrix4x4> Matrix; ///< actor frame to W
    std::uint64_t GeometryKey = 0;        ///< equal while points and cells are the same objects, unmodified
    int Part = 0;                         ///< number of a part of remote data; 0: whole
    std::uint64_t ArraysKey = 0;          ///< equal while its arrays are the same, unmodified
  };

  /// The output of a source that is shown, whatever of it is drawn: a volume has no surface, and may be felt as a
  /// field.
  struct Source
  {
    std::string Name;
    vtkSmartPointer<vtkDataObject> Data{}; ///< null: they are on a server
    bool Moved = false;                    ///< it is drawn elsewhere than its numbers are
    vtkSMSourceProxy* Remote = nullptr;    ///< for remote data: their source
    unsigned int Port = 0;                 ///< and at which of its outputs
  };

  std::vector<Surface> Surfaces;
  std::vector<Source> Sources;
  std::vector<std::string> Refusals; ///< one sentence each: untouched source, reason, remedy
  bool Pending = false;              ///< something was not rendered yet: look again after the next frame

  /// Nothing of that name is a surface to be touched.
  void LeaveOut(const std::string& name)
  {
    std::erase_if(this->Surfaces, [&name](const Surface& surface) { return surface.Name == name; });
  }
  /// Same surfaces, same geometry, same transforms.
  bool SameAs(const vtkHapticViewScan& other) const;
  /// Of the same sources.
  bool SameNamesAs(const vtkHapticViewScan& other) const;
  /// The same arrays on surfaces that are the same.
  bool SameArraysAs(const vtkHapticViewScan& other) const;
};

#endif
