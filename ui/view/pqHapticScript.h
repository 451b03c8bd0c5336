// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticScript_h
#define pqHapticScript_h

#include <QObject>

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkObject;
class vtkPythonInterpreter;
class vtkSMProxy;

/**
 * Writes the settings of the session into Python traces and Python states.
 *
 * ParaView traces sources and views alone, and has no interface for further parts of a state. So every property that is
 * pushed while a trace is active becomes a call of palpate.simple in it, and once there is a Python interpreter its
 * function that makes states gets the settings that differ from the defaults at the end. A state says nothing of Touch:
 * it never moves a device.
 */
class pqHapticScript : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticScript(QObject* parent = nullptr);
  ~pqHapticScript() override;

  void setProxy(vtkSMProxy* proxy);

private:
  void trace(vtkObject* proxy, unsigned long event, void* property);
  void extendStates();

  vtkSmartPointer<vtkSMProxy> Proxy;
  unsigned long Observer = 0;
  vtkNew<vtkPythonInterpreter> Python; ///< heard when the interpreter begins
};

#endif
