// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticGlyphs_h
#define vtkHapticGlyphs_h

#include <cstdint>

#include "vtkHapticShape.h"
#include "vtkHapticViewsModule.h" // for the export macro

class vtkGlyph3DMapper;

/**
 * Copies of the mapper's glyph at each point of its input, scaled, turned and left out as vtkGlyph3DMapper draws them,
 * in the frame of its actor.
 *
 * A block of poly data for each data set of the mapper's input. Points have the arrays of the point that their glyph
 * stands at, and its id as vtkOriginalPointIds. At most `mostPolygons` polygons and lines are made: a picture draws one
 * glyph often, but each is felt by itself.
 */
[[nodiscard]] VTKHAPTICVIEWS_EXPORT vtkHapticShape vtkHapticGlyphsOf(
  vtkGlyph3DMapper* mapper, std::int64_t mostPolygons = 1000000);

/// Names all that these copies depend on: equal keys mean equal copies.
[[nodiscard]] VTKHAPTICVIEWS_EXPORT std::uint64_t vtkHapticGlyphsKey(vtkGlyph3DMapper* mapper);

#endif
