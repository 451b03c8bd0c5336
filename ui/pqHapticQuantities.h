// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticQuantities_h
#define pqHapticQuantities_h

#include <QString>

#include <functional>

class vtkHapticSession;

/// What hapticCheck and hapticWaitFor can ask for of a session; null: no such name.
std::function<double(vtkHapticSession&)> pqHapticQuantityOf(const QString& name);

#endif
