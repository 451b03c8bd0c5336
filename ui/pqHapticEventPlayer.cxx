// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticEventPlayer.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqDataRepresentation.h"
#include "pqEventDispatcher.h"
#include "pqHapticController.h"
#include "pqHapticLayoutChecks.h"
#include "pqHapticPanelChecks.h"
#include "pqHapticQuantities.h"
#include "pqHapticViewFollower.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "vtkCamera.h"
#include "vtkHapticDeviceCheck.h"
#include "vtkHapticSession.h"
#include "vtkPythonInterpreter.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTrace.h"
#include "vtkSmartPointer.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QMouseEvent>
#include <QStringList>
#include <QWidget>
#include <QtDebug>

#include <algorithm>
#include <functional>
#include <map>

namespace
{
/// Long enough for the panel's next refresh.
constexpr int settle_ms = 150;
/// Of a pointer that glides.
constexpr int betweenMoves_ms = 30;

pqPipelineSource* SourceOf(const QString& name)
{
  return pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(name);
}

} // namespace

pqHapticEventPlayer::pqHapticEventPlayer(pqHapticController* controller, QObject* parent)
  : Superclass(parent), Controller(controller)
{
}

bool pqHapticEventPlayer::playEvent(QObject* object, const QString& command, const QString& arguments, bool& failed)
{
  const QStringList list = arguments.split(',');
  const std::map<QString, std::function<bool()>> commands = {
    { "hapticProperty", [&] { return this->setProperty(list); } },
    { "hapticShow", [&] { return this->show(list); } },
    { "hapticCamera", [&] { return this->checkCamera(list); } },
    { "hapticHas", [&] { return pqHapticHas(object, arguments); } },
    { "hapticWaitHas", [&] { return this->waitForText(object, arguments); } },
    { "hapticTrace", [&] { return vtkSMTrace::StartTrace() != nullptr; } },
    { "hapticTraced", [&] { return this->checkScript(vtkSMTrace::StopTrace(), arguments); } },
    { "hapticPythonState", [&] { return this->checkScript(vtkSMTrace::GetState(nullptr), arguments); } },
    { "hapticPython", [&] { return this->runPython(arguments); } },
    { "hapticUndo", [&] { return this->undo(arguments.toInt()); } },
    { "hapticUndoStep", [&] { return pqHapticIsUndoStep(arguments); } },
    { "hapticDevice", [&] { return this->chooseDevice(arguments); } },
    { "hapticPose", [&] { return this->pose(list); } },
    { "hapticStroke", [&] { return this->addStrokePoint(list); } },
    { "hapticVirtualTime", [&] { return this->setVirtualTime(arguments.toInt() != 0); } },
    { "hapticGlide", [&] { return this->glide(qobject_cast<QWidget*>(object), list); } },
    { "hapticMove", [&] { return this->move(list); } },
    { "hapticStep", [&] { return this->step(arguments.toInt()); } },
    { "hapticWindow", [&] { return this->resizeWindow(list); } },
    { "hapticWait", [&] { return this->wait(arguments.toInt()); } },
    { "hapticWaitUntilReleased", [&] { return this->waitUntilReleased(arguments.toInt()); } },
    { "hapticWaitFor", [&] { return this->waitFor(list); } },
    { "hapticCheck", [&] { return this->check(list); } },
    { "hapticMnemonics", [&] { return pqHapticHasMnemonics(object); } },
    { "hapticExplains", [&] { return pqHapticExplains(object, list); } },
    { "hapticTip", [&] { return pqHapticHasTip(object, arguments); } },
    { "hapticText",
      [&] { return pqHapticHasReadableText(object, list.value(0).toDouble(), list.value(1).toDouble()); } },
    { "hapticDark", [&] { return pqHapticGoDark(); } },
    { "hapticWatchFiles", [&] { return this->watchFiles(); } },
    { "hapticOpened", [&] { return this->opened(arguments); } },
    { "hapticAnotherSession", [&] { return this->replaceSession(); } },
    { "hapticPlaces",
      [&]
      {
        this->Places = pqHapticPlacesIn(object);
        return !this->Places.isEmpty();
      } },
    { "hapticStill", [&] { return pqHapticIsStill(object, this->Places); } },
    { "hapticSeen", [&] { return pqHapticIsSeen(object, arguments == "whole"); } },
    { "hapticTabOrder", [&] { return pqHapticHasTabOrder(object, list); } },
  };
  const auto found = commands.find(command);
  if (found == commands.end())
  {
    return false;
  }
  failed = !found->second();
  return true;
}

bool pqHapticEventPlayer::wait(int time_ms)
{
  pqEventDispatcher::processEventsAndWait(time_ms);
  return true;
}

bool pqHapticEventPlayer::resizeWindow(const QStringList& size)
{
  QWidget* window = pqCoreUtilities::mainWidget();
  if (!window || size.size() != 2)
  {
    return false;
  }
  window->setGeometry(0, 0, size[0].toInt(), size[1].toInt());
  return true;
}

/// Source, property, number; then applied, and all of it in view.
bool pqHapticEventPlayer::setProperty(const QStringList& arguments)
{
  pqPipelineSource* source = SourceOf(arguments.value(0));
  if (!source || !source->getProxy()->GetProperty(arguments.value(1).toUtf8().constData()))
  {
    return false;
  }
  vtkSMPropertyHelper(source->getProxy(), arguments.value(1).toUtf8().constData()).Set(arguments.value(2).toDouble());
  source->getProxy()->UpdateVTKObjects();
  source->updatePipeline();
  pqView* view = pqActiveObjects::instance().activeView();
  view->forceRender();
  view->resetDisplay();
  return true;
}

/// Source, 0 or 1: as its eye in the pipeline browser does.
bool pqHapticEventPlayer::show(const QStringList& arguments)
{
  pqPipelineSource* source = SourceOf(arguments.value(0));
  pqDataRepresentation* shown =
    source ? source->getRepresentation(0, pqActiveObjects::instance().activeView()) : nullptr;
  if (!shown)
  {
    return false;
  }
  shown->setVisible(arguments.value(1).toInt() != 0);
  shown->renderViewEventually();
  return true;
}

/// Least and largest distance of the camera from its focal point [u].
bool pqHapticEventPlayer::checkCamera(const QStringList& range) const
{
  pqRenderView* view = this->Controller->follower()->view();
  const double distance = view ? view->getRenderViewProxy()->GetActiveCamera()->GetDistance() : 0.0;
  const bool inside = view && distance >= range.value(0).toDouble() && distance <= range.value(1).toDouble();
  if (!inside)
  {
    qCritical() << "hapticCamera" << range << ": it is" << distance << "away";
  }
  return inside;
}

/// Milliseconds, words: waits until the object says them.
bool pqHapticEventPlayer::waitForText(QObject* object, const QString& arguments)
{
  QElapsedTimer time;
  time.start();
  const QString words = arguments.section(',', 1);
  while (!pqHapticSaidBy(object).contains(words) && time.elapsed() < arguments.section(',', 0, 0).toInt())
  {
    pqEventDispatcher::processEventsAndWait(settle_ms);
  }
  return pqHapticHas(object, words);
}

bool pqHapticEventPlayer::checkScript(const std::string& script, const QString& part) const
{
  const bool has = QString::fromStdString(script).contains(part);
  if (!has)
  {
    qCritical() << "no line of this script has" << part << ":" << QString::fromStdString(script);
  }
  return has;
}

bool pqHapticEventPlayer::runPython(const QString& statement) const
{
  return vtkPythonInterpreter::RunSimpleString(statement.toUtf8().constData()) == 0;
}

bool pqHapticEventPlayer::undo(int steps) const
{
  pqUndoStack* stack = pqApplicationCore::instance()->getUndoStack();
  for (; stack && steps > 0 && stack->canUndo(); --steps)
  {
    stack->undo();
  }
  for (; stack && steps < 0 && stack->canRedo(); ++steps)
  {
    stack->redo();
  }
  return stack != nullptr;
}

/// As a script does it: no person can choose a device that only a program can lead.
bool pqHapticEventPlayer::chooseDevice(const QString& name)
{
  vtkSMProxy* proxy = this->Controller->sessionProxy();
  if (proxy)
  {
    vtkSMPropertyHelper(proxy, "DeviceName").Set(name.toUtf8().constData());
    proxy->UpdateVTKObjects();
  }
  return proxy != nullptr;
}

bool pqHapticEventPlayer::setVirtualTime(bool on)
{
  vtkHapticSession* session = this->Controller->session();
  if (session)
  {
    session->SetSetting("VirtualTime", on);
  }
  return session != nullptr;
}

bool pqHapticEventPlayer::move(const QStringList& arguments)
{
  vtkHapticSession* session = this->Controller->session();
  const int ticks = arguments.size() == 4 ? arguments[3].toInt() : 0;
  if (!session || ticks < 1)
  {
    return false;
  }
  session->FinishScene();
  const double from_W[3] = { this->Hand_W[0], this->Hand_W[1], this->Hand_W[2] };
  for (int i = 1; i <= ticks; ++i)
  {
    const double t = static_cast<double>(i) / ticks;
    for (int k = 0; k < 3; ++k)
    {
      this->Hand_W[k] = (1.0 - t) * from_W[k] + t * arguments[k].toDouble();
    }
    session->SetHandPosition(this->Hand_W);
    session->Step(1);
  }
  return this->wait(settle_ms);
}

bool pqHapticEventPlayer::pose(const QStringList& numbers)
{
  vtkHapticSession* session = this->Controller->session();
  if (!session || numbers.size() != 3)
  {
    return false;
  }
  std::transform(numbers.begin(), numbers.end(), this->Hand_W, [](const QString& text) { return text.toDouble(); });
  session->SetHandPosition(this->Hand_W);
  return true;
}

bool pqHapticEventPlayer::addStrokePoint(const QStringList& numbers)
{
  vtkHapticSession* session = this->Controller->session();
  if (!session || numbers.size() != 3)
  {
    return false;
  }
  session->AddStrokePoint(numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble());
  return true;
}

bool pqHapticEventPlayer::glide(QWidget* widget, const QStringList& arguments)
{
  const int steps = arguments.size() == 5 ? arguments[4].toInt() : 0;
  for (int i = 0; widget && i <= steps; ++i)
  {
    const double t = static_cast<double>(i) / steps;
    const auto along = [&](int from, int to)
    { return (1.0 - t) * arguments[from].toDouble() + t * arguments[to].toDouble(); };
    const QPointF at(along(0, 2) * widget->width(), along(1, 3) * widget->height());
    QMouseEvent move(
      QEvent::MouseMove, at, widget->mapToGlobal(at.toPoint()), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(widget, &move);
    this->wait(betweenMoves_ms);
  }
  return widget && steps > 0;
}

bool pqHapticEventPlayer::step(int ticks)
{
  vtkHapticSession* session = this->Controller->session();
  if (!session)
  {
    return false;
  }
  session->FinishScene();
  session->Step(ticks);
  return this->wait(settle_ms);
}

bool pqHapticEventPlayer::waitUntilReleased(int limit_ms)
{
  QElapsedTimer time;
  time.start();
  while (this->Controller->touching() && time.elapsed() < limit_ms)
  {
    pqEventDispatcher::processEventsAndWait(settle_ms);
  }
  return !this->Controller->touching();
}

bool pqHapticEventPlayer::waitFor(const QStringList& arguments)
{
  QElapsedTimer time;
  time.start();
  const QStringList range = arguments.mid(0, 3);
  while (time.elapsed() < arguments.value(3).toInt())
  {
    if (this->holds(range))
    {
      return true;
    }
    pqEventDispatcher::processEventsAndWait(settle_ms);
  }
  return this->check(range);
}

bool pqHapticEventPlayer::holds(const QStringList& range) const
{
  vtkHapticSession* session = this->Controller->session();
  if (!session || range.size() != 3)
  {
    return false;
  }
  session->Update();
  const auto quantity = pqHapticQuantityOf(range[0]);
  return quantity && quantity(*session) >= range[1].toDouble() && quantity(*session) <= range[2].toDouble();
}

bool pqHapticEventPlayer::watchFiles()
{
  this->Opened.clear();
  QDesktopServices::setUrlHandler("file", this, "keepUrl");
  return true;
}

void pqHapticEventPlayer::keepUrl(const QUrl& url)
{
  this->Opened = url;
}

bool pqHapticEventPlayer::opened(const QString& target) const
{
  const auto contentOf = [](const QString& name)
  {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  };
  const QString file = this->Opened.toLocalFile();
  const QString page = contentOf(QFileInfo(file).path() + "/" + target.section('#', 0, 0));
  const QString anchor = target.section('#', 1);
  const bool leads = contentOf(file).contains("url=" + target + "\"");
  const bool there = page.contains(anchor.isEmpty() ? "<h1" : "id=\"" + anchor + "\"");
  if (!leads || !there)
  {
    qCritical() << "hapticOpened" << target << ": opened is" << file << (leads ? "" : "which leads elsewhere")
                << (there ? "" : "and the page or its anchor is missing");
  }
  return leads && there;
}

/// As a script does it. The one before must be left in peace.
bool pqHapticEventPlayer::replaceSession()
{
  vtkSMProxy* before = this->Controller->sessionProxy();
  const vtkSmartPointer<vtkHapticSession> left = this->Controller->session();
  if (!left)
  {
    return false;
  }
  vtkSMSessionProxyManager* manager = before->GetSessionProxyManager();
  const auto proxy = vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("haptics", "HapticSession"));
  manager->RegisterProxy("haptics", "another", proxy);
  const bool quiet = !left->GetTouching() && left->GetDeviceCheck()->GetState() != vtkHapticDeviceCheck::CheckRuns;
  return quiet && this->Controller->session() != left;
}

bool pqHapticEventPlayer::check(const QStringList& range)
{
  const bool inside = this->holds(range);
  vtkHapticSession* session = this->Controller->session();
  if (!inside && session)
  {
    const auto quantity = pqHapticQuantityOf(range.value(0));
    qCritical() << "hapticCheck" << range << ": it is" << (quantity ? quantity(*session) : qQNaN()) << "; force"
                << session->GetForceMagnitude() << "N, depth" << session->GetDepth() << "u, contacts"
                << session->GetContacts() << ", ticks" << session->GetTicks() << "; state" << session->GetStateText()
                << session->GetFaultText() << session->GetProblem() << ";" << this->Controller->follower()->report()
                << session->GetSceneReport();
  }
  return inside;
}
