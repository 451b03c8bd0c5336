// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSourceParts_h
#define vtkHapticSourceParts_h

#include <string>

#include "vtkHapticViewsModule.h" // for the export macro

class vtkSMSourceProxy;

/// The kinds of things that a source of the pipeline can be touched as.
enum class vtkHapticTouchKind
{
  Surface,
  Lines,
  Field,
  Tool,
  Tissue,
  Mechanism
};

/// The parts of the first output of a source that a hand can feel.
struct vtkHapticSourceParts
{
  bool Known = false;     ///< false: the source has made nothing yet
  bool Faces = false;     ///< polygons, or the border of a solid
  bool Lines = false;     ///< cells of one dimension
  bool Solid = false;     ///< cells that fill space
  bool Arrays = false;    ///< numbers at points or cells
  bool Body = false;      ///< tetrahedra with a material, made by the filter Soft Body
  bool Mechanism = false; ///< bodies and constraints, made by Haptic Mechanism
};

/// Of data on a server only the type is known: poly data may then be faces or lines.
[[nodiscard]] VTKHAPTICVIEWS_EXPORT vtkHapticSourceParts vtkHapticPartsOf(vtkSMSourceProxy* source);

/// Reason why such parts cannot be touched as that kind, and the remedy, after the name of the source; "": they can, or
/// nothing is known of them yet.
[[nodiscard]] VTKHAPTICVIEWS_EXPORT std::string vtkHapticMisfit(
  const vtkHapticSourceParts& parts, vtkHapticTouchKind kind);

#endif
