// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticQuantities_h
#define pqHapticQuantities_h

#include <QString>

#include <functional>

class vtkHapticSession;

/// The quantities of a session for hapticCheck and hapticWaitFor; null: no such name.
std::function<double(vtkHapticSession&)> pqHapticQuantityOf(const QString& name);

#endif
