// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticUnits_h
#define pqHapticUnits_h

#include <QString>

/// The unit of the scene's lengths that the panel shows from now on; "u": not known. True: another one than before.
bool pqHapticSetLengthUnit(const QString& unit);

/// A text with quantities in u, in the unit of the scene's lengths: "2.5 u" becomes "2.5 mm".
QString pqHapticInUnits(QString text);
/// A unit alone: "u/m" becomes "mm/m".
QString pqHapticUnitIn(QString unit);

#endif
