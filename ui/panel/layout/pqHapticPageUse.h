// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticPageUse_h
#define pqHapticPageUse_h

#include <QMap>
#include <QString>

class vtkHapticSession;

/// Why pages of the panel have no use now, with the remedy, by the name of the page; "": it has one.
QMap<QString, QString> pqHapticPageReasons(vtkHapticSession* session);

#endif
