// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticLayoutChecks_h
#define pqHapticLayoutChecks_h

#include <QMap>
#include <QRect>
#include <QString>

class QObject;

// Checks of where the widgets in an object are, for event scripts. Each reports a failure with qCritical().

/// Where each visible widget with a name is [pixels from the corner of the window].
using pqHapticPlaces = QMap<QString, QRect>;
pqHapticPlaces pqHapticPlacesIn(QObject* object);

/// None of them has moved by a pixel, and all of them are still there.
bool pqHapticIsStill(QObject* object, const pqHapticPlaces& before);

/// No visible widget in the object is cut off by another one around it: not at a side, and with `whole` not above or
/// below either.
bool pqHapticIsSeen(QObject* object, bool whole);

#endif
