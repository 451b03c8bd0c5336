// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticColourRange_h
#define vtkHapticColourRange_h

#include <string>

class vtkSMProxy;

/// A colour map that is seen, and the array that it colours.
struct vtkHapticColourMap
{
  std::string Array; ///< "": a representation that is hidden, or coloured by none
  double Low = 0.0, High = 0.0;
  bool Drawn = false;  ///< a person drew the opacity: it is more than one straight line
  double Opaque = 0.0; ///< values below it are less than half as opaque as the most opaque value
};
/// `representation`: null has none.
vtkHapticColourMap vtkHapticColourMapOf(vtkSMProxy* representation);

/// Gives a session's settings the ranges of a view's colour maps of arrays that are felt and seen: to an array of
/// stiffness, friction or texture the ends of its map as data range; to the values of a field the lowest value that the
/// map shows half as opaque as any as isovalue (the middle where all are alike), its low end as first level and an
/// eighth of it from level to level. A line for each that was given, "" where nothing that is felt is coloured by.
std::string vtkHapticTakeColourRange(vtkSMProxy* view, vtkSMProxy* session);

#endif
