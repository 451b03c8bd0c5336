// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticScanView_h
#define vtkHapticScanView_h

#include "vtkHapticViewScan.h"
#include "vtkHapticViewsModule.h" // for the export macro

class vtkHapticDrafts;
class vtkHapticRemoteSurfaces;
class vtkHapticShapes;
class vtkSMProxy;

/// The options beside polygons.
struct vtkHapticScanOptions
{
  bool Lines = false;                              ///< also data drawn as lines alone
  bool Points = false;                             ///< also data drawn as points alone
  vtkHapticDrafts* Drafts = nullptr;               ///< with them a shown curve is where its widget draws it
  const vtkHapticRemoteSurfaces* Remote = nullptr; ///< fetched from a server
  vtkSMProxy* Drawing = nullptr;                   ///< a source that is not shown yet, where its widget draws it
};

/// GUI thread. `view` may be null or any kind of view: a view that cannot be followed is refused with a sentence.
/// `shapes` keeps the geometry of glyphs and slices from one look to the next.
VTKHAPTICVIEWS_EXPORT vtkHapticViewScan vtkHapticScanView(
  vtkSMProxy* view, vtkHapticShapes& shapes, const vtkHapticScanOptions& options = {});

#endif
