// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticNamedSource_h
#define pqHapticNamedSource_h

#include "pqHapticController.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <QString>

/// Sets the property of the session that names a source of the pipeline, as a trace has it; "": none.
inline void pqHapticNameSource(const char* property, const QString& name)
{
  if (vtkSMProxy* proxy = pqHapticController::instance()->sessionProxy())
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
    vtkSMPropertyHelper(proxy, property).Set(name.toUtf8().constData());
    proxy->UpdateVTKObjects();
  }
}

#endif
