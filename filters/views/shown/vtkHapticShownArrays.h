// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticShownArrays_h
#define vtkHapticShownArrays_h

#include "vtkHapticViewsModule.h"

#include <set>
#include <string>

class vtkSMProxy;

/// Names of the arrays with numbers of points and cells of the sources that a view shows, however they are drawn.
/// Unlike a scan of the view this takes part in nothing that is touched, and may be asked at any time. Null has none.
VTKHAPTICVIEWS_EXPORT std::set<std::string> vtkHapticShownArrays(vtkSMProxy* view);

#endif
