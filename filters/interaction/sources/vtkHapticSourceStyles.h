// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSourceStyles_h
#define vtkHapticSourceStyles_h

#include <map>
#include <string>
#include <string_view>

#include "haptics/geometry/mesh/Material.h"

/// How a source is touched by itself, beside its arrays.
struct vtkHapticSourceStyle
{
  bool Touched = true;
  palpate::Material Material; ///< where no array says otherwise
  double Density = 0.0;       ///< of a loose body [kg/m3]; 0: it is fixed
  friend bool operator==(const vtkHapticSourceStyle&, const vtkHapticSourceStyle&) = default;
};

/// "", or why no source has that density [kg/m3].
[[nodiscard]] std::string vtkHapticRefuseDensity(double density);

/// The sources that are touched in another way than a session's, by name, and as a text that state files and scripts
/// hold.
class vtkHapticSourceStyles
{
public:
  /// The usual one for a name that nothing was said of.
  [[nodiscard]] vtkHapticSourceStyle Of(const std::string& name) const;
  void Set(const std::string& name, const vtkHapticSourceStyle& style);
  /// Those that are loose: their densities by name.
  [[nodiscard]] std::map<std::string, double> Densities() const;
  /// Comma-separated with a header line: Source, Touched (0 or 1), Stiffness [N/m], FrictionStatic, FrictionKinetic,
  /// and Density [kg/m3] only if any is loose, so that releases without loose sources read the others. Sorted by name;
  /// "" if all are usual.
  [[nodiscard]] std::string ToText() const;
  /// Empty, or one line with the fault; then nothing has changed.
  [[nodiscard]] std::string FromText(std::string_view text);

private:
  std::map<std::string, vtkHapticSourceStyle> Styles; ///< those that are not the usual one
};

#endif
