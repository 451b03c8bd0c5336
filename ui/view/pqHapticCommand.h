// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticCommand_h
#define pqHapticCommand_h

#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QString>

/// Sets a text of the session's proxy now. The same text once more is another command.
inline void pqHapticCommand(vtkSMProxy* proxy, const char* property, const QString& text)
{
  const QByteArray wanted = text.toUtf8();
  if (wanted == vtkSMPropertyHelper(proxy, property).GetAsString())
  {
    proxy->GetProperty(property)->Modified();
  }
  vtkSMPropertyHelper(proxy, property).Set(wanted.constData());
  proxy->UpdateVTKObjects();
}

#endif
