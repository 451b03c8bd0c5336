// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticScript.h"

#include "haptics/session/settings/SessionSettings.h"
#include "vtkCommand.h"
#include "vtkPVPluginTracker.h"
#include "vtkPythonInterpreter.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMTrace.h"
#include "vtkSMVectorProperty.h"

#include <QDir>
#include <QFileInfo>
#include <QMap>
#include <QString>
#include <QStringList>

namespace
{
/// Used by a program to move the hand, not a setting.
bool IsCommand(const QString& property)
{
  return property == "HandPosition" || property == "Step";
}

QString InPython(vtkSMProperty* property, unsigned int element)
{
  const vtkSMPropertyHelper value(property);
  if (vtkSMStringVectorProperty::SafeDownCast(property))
  {
    QString text = QString::fromUtf8(value.GetAsString(element));
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'").replace("\n", "\\n") + "'";
  }
  return vtkSMDoubleVectorProperty::SafeDownCast(property) ? QString::number(value.GetAsDouble(element), 'g', 17)
                                                           : QString::number(value.GetAsInt(element));
}

/// Empty for a property without a value.
QString ValueOf(vtkSMProperty* property)
{
  auto* vector = vtkSMVectorProperty::SafeDownCast(property);
  const unsigned int count = vector ? vector->GetNumberOfElements() : 0;
  QStringList values;
  for (unsigned int i = 0; i < count; ++i)
  {
    values << InPython(property, i);
  }
  return count > 1 ? "[" + values.join(", ") + "]" : values.join("");
}

/// The call of palpate.simple that sets a property; "": the property is a command that has no such function.
QString CallOf(const QString& property, const QString& value)
{
  static const QMap<QString, QString> held = { { "ToolSource", "HoldTool" }, { "SoftSource", "PressBody" },
    { "MechanismSource", "HoldMechanism" } };
  if (property == "Touching")
  {
    return value == "0" ? "LetGo()" : "Touch()";
  }
  if (held.contains(property))
  {
    return held[property] + "(" + (value == "''" ? "" : value) + ")";
  }
  return palpate::findSetting(property.toStdString()) ? QString("SetHaptics(%1=%2)").arg(property, value) : QString();
}

/// The package is imported once in a trace.
QString WithImport(const QString& call)
{
  const QString import = "from palpate.simple import *";
  const bool present = QString::fromStdString(vtkSMTrace::GetActiveTracer()->GetCurrentTrace()).contains(import);
  return present ? call : import + "\n" + call;
}

/// The Python package lies beside the folder of ParaView's plugins, where it is built and where it is installed.
std::string PythonFolder()
{
  vtkPVPluginTracker* const plugins = vtkPVPluginTracker::GetInstance();
  for (unsigned int i = 0; i < plugins->GetNumberOfPlugins(); ++i)
  {
    if (const char* file = plugins->GetPluginFileName(i); file && QFileInfo(file).baseName() == "Palpate")
    {
      return QDir::cleanPath(QFileInfo(file).absolutePath() + "/../../../python").toStdString();
    }
  }
  return {};
}

/// Runs in ParaView's interpreter, with the folder of the package.
constexpr const char* OfferPackage = R"python(
import sys, paraview
sys.path.append(%1)
paraview.palpate_panel = True  # it follows the views
)python";

/// Runs in ParaView's interpreter. There is no other place where a plugin could add to a state.
constexpr const char* ExtendStates = R"python(
def _palpate_extend_states():
    from paraview import servermanager, smstate

    def plain(value):
        return value if isinstance(value, (int, float, str)) else [x for x in value]

    def lines():
        session = servermanager.ProxyManager().GetProxy('haptics', 'HapticSession')
        changed = []
        for name in session.ListProperties() if session else []:
            value = session.SMProxy.GetProperty(name)
            if value.GetInformationOnly() or value.GetIsInternal() or not value.IsA('vtkSMVectorProperty'):
                continue
            if value.GetNumberOfElements() and not value.IsValueDefault():
                changed.append('    haptics.SetPropertyWithName(%r, %r)' % (name, plain(session.GetPropertyValue(name))))
        return ['', '# touched sources and tool, and what it feels like',
                'haptics = servermanager.ProxyManager().GetProxy(%r, %r)' % ('haptics', 'HapticSession'),
                'if haptics:', *changed] if changed else []

    own = smstate.get_state

    def get_state(*arguments, **options):
        state = own(*arguments, **options)
        return state + lines() if isinstance(state, list) else state + '\n'.join(lines()) + '\n'

    smstate.get_state = get_state


_palpate_extend_states()
del _palpate_extend_states
)python";
} // namespace

pqHapticScript::pqHapticScript(QObject* parent) : Superclass(parent)
{
  this->Python->AddObserver(vtkCommand::EnterEvent, this, &pqHapticScript::extendStates);
  if (vtkPythonInterpreter::IsInitialized())
  {
    this->extendStates();
  }
}

pqHapticScript::~pqHapticScript()
{
  this->setProxy(nullptr);
}

void pqHapticScript::extendStates()
{
  const QString folder = "'" + QString::fromStdString(PythonFolder()).replace("'", "\\'") + "'";
  vtkPythonInterpreter::RunSimpleString(QString(OfferPackage).arg(folder).toUtf8().constData());
  vtkPythonInterpreter::RunSimpleString(ExtendStates);
}

void pqHapticScript::setProxy(vtkSMProxy* proxy)
{
  if (this->Proxy)
  {
    this->Proxy->RemoveObserver(this->Observer);
  }
  this->Proxy = proxy;
  if (proxy)
  {
    this->Observer = proxy->AddObserver(vtkCommand::UpdatePropertyEvent, this, &pqHapticScript::trace);
  }
}

void pqHapticScript::trace(vtkObject*, unsigned long, void* property)
{
  const QString name = QString::fromUtf8(static_cast<const char*>(property));
  const QString value = vtkSMTrace::GetActiveTracer() && property && !IsCommand(name)
                          ? ValueOf(this->Proxy->GetProperty(name.toUtf8().constData()))
                          : QString();
  if (!value.isEmpty())
  {
    const QString call = CallOf(name, value);
    const QString line =
      call.isEmpty()
        ? QString("servermanager.ProxyManager().GetProxy('haptics', 'HapticSession').SetPropertyWithName('%1', %2)")
            .arg(name, value)
        : WithImport(call);
    SM_SCOPED_TRACE(TraceText).arg(line.toUtf8().constData()).arg("comment", "touched sources and tool");
  }
}
