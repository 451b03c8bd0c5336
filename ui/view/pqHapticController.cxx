// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticController.h"

#include "devices/calibration/CalibrationFiles.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqHapticCommand.h"
#include "pqHapticFrames.h"
#include "pqHapticHandKeys.h"
#include "pqHapticMarks.h"
#include "pqHapticMouse.h"
#include "pqHapticPencil.h"
#include "pqHapticRecordings.h"
#include "pqHapticScript.h"
#include "pqHapticTouchKinds.h"
#include "pqHapticViewFollower.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqServerManagerObserver.h"
#include "pqUndoStack.h"
#include "vtkCommand.h"
#include "vtkHapticDeviceCheck.h"
#include "vtkHapticKnownDevices.h"
#include "vtkHapticMessageCapture.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyDefinitionManager.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <QAction>
#include <QIcon>
#include <QStringList>
#include <QTimer>

#include <cstdlib>
#include <cstring>

namespace
{
constexpr const char* managerName = "PALPATE_HAPTIC_CONTROLLER";
constexpr const char* proxyGroup = "haptics";
constexpr const char* proxyName = "HapticSession";

/// A new session starts with the settings of Edit / Settings / Haptics, with the device that is most likely meant, and
/// fits the hand to the shown data unless a scale is set there.
void ApplySettings(vtkSMSessionProxyManager* manager, vtkSMProxy* session)
{
  if (auto* object = vtkHapticSession::SafeDownCast(session->GetClientSideObject()))
  {
    vtkSMPropertyHelper(session, "DeviceName").Set(object->GetDevices()->GetPreferred());
    vtkSMPropertyHelper(session, "FitOnTouch").Set(1);
  }
  vtkSMProxy* settings = manager->GetProxy("settings", "HapticSettings");
  for (const char* name : { "Stiffness", "Radius", "Scale" })
  {
    if (settings)
    {
      vtkSMPropertyHelper(session, name).Set(vtkSMPropertyHelper(settings, name).GetAsDouble());
    }
  }
}
} // namespace

pqHapticController* pqHapticController::instance()
{
  auto* core = pqApplicationCore::instance();
  auto* present = qobject_cast<pqHapticController*>(core->manager(managerName));
  if (!present)
  {
    present = new pqHapticController(core);
    core->registerManager(managerName, present);
  }
  return present;
}

pqHapticController::pqHapticController(QObject* parent)
  : Superclass(parent), Follower(new pqHapticViewFollower(this)), Frames(new pqHapticFrames(this)),
    Mouse(new pqHapticMouse(this)), Pencil(new pqHapticPencil(this)), Recordings(new pqHapticRecordings(this)),
    Keys(new pqHapticHandKeys(this)), Script(new pqHapticScript(this)), Kinds(new pqHapticTouchKinds(this)),
    Marks(new pqHapticMarks(this))
{
  this->makeActions();
  this->connectApplication();
  this->Frames->setView(this->Follower->view());
  this->Mouse->setView(this->Follower->view());
  this->Pencil->setView(this->Follower->view());
  this->Marks->setView(this->Follower->view());
  this->connect(this->Follower, &pqHapticViewFollower::viewChanged, this->Frames, &pqHapticFrames::setView);
  this->connect(this->Follower, &pqHapticViewFollower::viewChanged, this->Mouse, &pqHapticMouse::setView);
  this->connect(this->Follower, &pqHapticViewFollower::viewChanged, this->Pencil, &pqHapticPencil::setView);
  this->connect(this->Follower, &pqHapticViewFollower::viewChanged, this->Marks, &pqHapticMarks::setView);
  this->connect(this->Follower, &pqHapticViewFollower::viewClosing, this->Marks, &pqHapticMarks::leaveView);
  this->connect(this->Frames, &pqHapticFrames::updated, this->Mouse, &pqHapticMouse::update);
  this->connect(this->Frames, &pqHapticFrames::handDrawn, this->Follower, &pqHapticViewFollower::refresh);
  this->connect(this->Mouse, &pqHapticMouse::depthChanged, this, &pqHapticController::setPressDepth);
  this->connect(this->Follower, &pqHapticViewFollower::viewClosing, this, &pqHapticController::release);
}

pqHapticController::~pqHapticController()
{
  this->shutdown();
}

void pqHapticController::connectApplication()
{
  auto* core = pqApplicationCore::instance();
  auto* model = core->getServerManagerModel();
  this->connect(model, &pqServerManagerModel::serverAdded, this, &pqHapticController::serverAdded);
  this->connect(model, &pqServerManagerModel::aboutToRemoveServer, this, &pqHapticController::serverLeaves);
  this->connect(model, &pqServerManagerModel::preServerRemoved, this, &pqHapticController::serverLeaves);

  auto* observer = core->getServerManagerObserver();
  using Registration = void (pqServerManagerObserver::*)(const QString&, const QString&, vtkSMProxy*);
  this->connect(observer, static_cast<Registration>(&pqServerManagerObserver::proxyRegistered), this,
    [this](const QString& group, const QString&, vtkSMProxy* proxy) { this->proxyRegistered(group, proxy); });
  this->connect(observer, static_cast<Registration>(&pqServerManagerObserver::proxyUnRegistered), this,
    [this](const QString& group, const QString&, vtkSMProxy* proxy) { this->proxyUnregistered(group, proxy); });

  // Interfaces of a plugin start before its proxies are defined.
  QTimer::singleShot(0, this, [this] { this->serverAdded(pqActiveObjects::instance().activeServer()); });
}

void pqHapticController::makeActions()
{
  this->TouchAction = new QAction(QIcon(":/palpate/icons/touch.svg"), tr("&Touch"), this);
  this->TouchAction->setObjectName("hapticTouchAction");
  this->TouchAction->setCheckable(true);
  this->TouchAction->setEnabled(false);
  this->TouchAction->setToolTip(tr("Touch every visible surface of the active view"));
  this->connect(this->TouchAction, &QAction::toggled, this, &pqHapticController::setTouching);

  this->ReleaseAction = new QAction(QIcon(":/palpate/icons/release.svg"), tr("&Let Go"), this);
  this->ReleaseAction->setObjectName("hapticReleaseAction");
  this->ReleaseAction->setEnabled(false);
  this->ReleaseAction->setToolTip(tr("Reduce the force to zero within 50 ms and stop touching"));
  this->connect(this->ReleaseAction, &QAction::triggered, this, &pqHapticController::release);

  this->MarkAction = new QAction(tr("&Mark"), this);
  this->MarkAction->setObjectName("hapticMarkAction");
  this->MarkAction->setShortcut(
    QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M)); // Shift is down while the mouse presses
  this->MarkAction->setToolTip(tr("Set a mark at the contact"));
  this->connect(this->MarkAction, &QAction::triggered, this, &pqHapticController::mark);

  this->DrawAction = new QAction(QIcon(":/palpate/icons/draw.svg"), tr("&Draw"), this);
  this->DrawAction->setObjectName("hapticDrawAction");
  this->DrawAction->setCheckable(true);
  this->DrawAction->setToolTip(tr("Draw lines in the view with the left mouse button, and touch them while drawing"));
  this->connect(this->DrawAction, &QAction::toggled, this->Pencil, &pqHapticPencil::setActive);
}

vtkSMProxy* pqHapticController::sessionProxy() const
{
  return this->Proxy;
}

vtkHapticSession* pqHapticController::session() const
{
  return this->Proxy ? vtkHapticSession::SafeDownCast(this->Proxy->GetClientSideObject()) : nullptr;
}

bool pqHapticController::touching() const
{
  return this->Proxy && vtkSMPropertyHelper(this->Proxy, "Touching").GetAsInt() != 0;
}

QString pqHapticController::refusal() const
{
  const pqServer* server = pqActiveObjects::instance().activeServer();
  if (this->Proxy)
  {
    return this->Follower->refusal();
  }
  return server && server->isRemote()
           ? tr("The server has not loaded the Palpate plugin. Start pvserver with PV_PLUGIN_PATH set to the plugin's "
                "folder, then choose File > Connect again.")
           : tr("There is no server connection. Choose File > Connect and the built-in server.");
}

void pqHapticController::setTouching(bool on)
{
  if (this->Proxy && on != this->touching())
  {
    this->Kinds->prepare(on);
    SCOPED_UNDO_SET(on ? tr("Touch") : tr("Let Go"));
    vtkSMPropertyHelper(this->Proxy, "Touching").Set(on ? 1 : 0);
    this->Proxy->UpdateVTKObjects();
  }
}

void pqHapticController::release()
{
  this->setTouching(false);
}

void pqHapticController::mark()
{
  if (this->Proxy)
  {
    const vtkHapticMessageCapture saidByThePanel; // else ParaView's messages open over it
    this->Proxy->InvokeCommand("AddMark");
  }
}

void pqHapticController::showTrace(bool shown)
{
  this->Frames->showTrace(shown);
}

void pqHapticController::showPlaces(bool shown)
{
  this->Frames->showPlaces(shown);
}

void pqHapticController::fitWorkspace()
{
  if (this->Proxy)
  {
    this->Proxy->InvokeCommand("FitWorkspace");
  }
}

void pqHapticController::fitSelection()
{
  QStringList names;
  for (pqServerManagerModelItem* item : pqActiveObjects::instance().selection())
  {
    auto* port = qobject_cast<pqOutputPort*>(item);
    auto* source = port ? port->getSource() : qobject_cast<pqPipelineSource*>(item);
    names << (source ? QStringList(source->getSMName()) : QStringList());
  }
  if (this->session() && !names.isEmpty())
  {
    this->Follower->handOver();
    this->session()->FinishScene();
    pqHapticCommand(this->Proxy, "FitToSources", names.join("\n"));
  }
}

void pqHapticController::alignWithView()
{
  if (this->session() && this->Follower->view())
  {
    this->session()->GetSight()->FollowCamera(this->Follower->view()->getRenderViewProxy()->GetActiveCamera());
    this->Proxy->InvokeCommand("AlignWithView");
  }
}

void pqHapticController::setPressDepth(double depth_m)
{
  SCOPED_UNDO_SET(tr("Mouse goes in by"));
  vtkSMPropertyHelper(this->Proxy, "PressDepth").Set(depth_m);
  this->Proxy->UpdateVTKObjects();
}

void pqHapticController::shutdown()
{
  this->release();
  this->adopt(nullptr);
}

void pqHapticController::serverAdded(pqServer* server)
{
  vtkSMSessionProxyManager* manager = server ? server->proxyManager() : nullptr;
  if (!manager || !manager->GetProxyDefinitionManager()->HasDefinition(proxyGroup, proxyName))
  {
    return;
  }
  if (vtkSMProxy* present = manager->GetProxy(proxyGroup, proxyName))
  {
    this->adopt(present);
    return;
  }
  SCOPED_UNDO_EXCLUDE(); // no person made it, so it cannot be undone
  auto proxy = vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy(proxyGroup, proxyName));
  proxy->UpdateVTKObjects(); // its object says which devices there are
  ApplySettings(manager, proxy);
  proxy->UpdateVTKObjects();
  manager->RegisterProxy(proxyGroup, proxyName, proxy); // proxyRegistered() adopts it
}

void pqHapticController::serverLeaves(pqServer* server)
{
  if (this->Proxy && this->Proxy->GetSession() == server->session())
  {
    this->shutdown();
  }
}

void pqHapticController::proxyRegistered(const QString& group, vtkSMProxy* proxy)
{
  if (group != proxyGroup || proxy == this->Proxy || std::strcmp(proxy->GetXMLName(), proxyName) != 0)
  {
    return;
  }
  proxy->UpdateVTKObjects(); // a script may register it before its object exists
  if (!vtkHapticSession::SafeDownCast(proxy->GetClientSideObject()))
  {
    return;
  }
  this->release();
  const vtkSmartPointer<vtkSMProxy> replaced = this->Proxy;
  this->adopt(proxy);
  if (replaced)
  {
    replaced->GetSessionProxyManager()->UnRegisterProxy(proxyGroup, proxyName, replaced);
  }
}

void pqHapticController::proxyUnregistered(const QString& group, vtkSMProxy* proxy)
{
  if (group == proxyGroup && proxy == this->Proxy)
  {
    this->shutdown();
  }
}

void pqHapticController::adopt(vtkSMProxy* proxy)
{
  if (this->Proxy)
  {
    this->Proxy->RemoveObserver(this->ProxyObserver);
  }
  if (this->session())
  {
    this->session()->GetDeviceCheck()->Stop(); // it could not be followed, or stopped, any more
  }
  this->Frames->setActive(false);
  this->Mouse->setActive(false);
  this->Follower->setActive(false);
  this->Proxy = proxy;
  if (this->session() && *this->session()->GetDeviceCheck()->GetCalibrationFolder() == '\0')
  {
    const std::string folder = palpate::userCalibrationFolder(std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME"));
    this->session()->GetDeviceCheck()->SetCalibrationFolder(folder.c_str());
  }
  this->Follower->setSession(this->session());
  this->Frames->setSession(this->session());
  this->Mouse->setSession(this->session());
  this->Pencil->setSession(this->session());
  this->Recordings->setProxy(proxy);
  this->Keys->setProxy(proxy);
  this->Script->setProxy(proxy);
  this->Marks->setProxy(proxy);
  if (proxy)
  {
    this->ProxyObserver = proxy->AddObserver(vtkCommand::UpdateEvent, this, &pqHapticController::proxyChanged);
  }
  Q_EMIT this->sessionChanged(proxy);
  this->proxyChanged();
}

void pqHapticController::proxyChanged()
{
  if (this->touching() && !this->session()->GetTouching())
  {
    this->setTouching(false); // it could not start: the panel shows why
    return;
  }
  const bool on = this->touching();
  this->TouchAction->setEnabled(this->Proxy != nullptr);
  this->TouchAction->setChecked(on);
  this->ReleaseAction->setEnabled(on);
  this->Recordings->follow();
  this->Follower->setActive(on);
  this->Frames->setActive(on);
  this->Mouse->setActive(on);
}
