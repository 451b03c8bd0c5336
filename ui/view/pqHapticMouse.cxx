// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMouse.h"

#include "pqHapticStatusBar.h"
#include "vtkCommand.h"
#include "vtkHapticMouse.h"
#include "vtkHapticMouseInput.h"
#include "vtkHapticSession.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"

#include <QApplication>
#include <QWidget>

namespace
{
/// Rounding of a depth that nothing limits.
constexpr double sameDepth = 1.0 - 1e-9;
constexpr int untilTheNext = 0; ///< [ms]

bool Holds(const QWidget* parent, const QWidget* child)
{
  return parent && child && (parent == child || parent->isAncestorOf(child));
}
} // namespace

pqHapticMouse::pqHapticMouse(QObject* parent) : Superclass(parent)
{
  this->Input->SetMouse(this->Mouse);
  this->Mouse->AddObserver(vtkCommand::InteractionEvent, this, &pqHapticMouse::deepened);
  this->connect(qApp, &QApplication::focusChanged, this, &pqHapticMouse::focusMoved);
  this->connect(qApp, &QGuiApplication::applicationStateChanged, this,
    [this](Qt::ApplicationState state)
    {
      if (state != Qt::ApplicationActive)
      {
        this->Mouse->Leave();
      }
    });
}

pqHapticMouse::~pqHapticMouse() = default;

void pqHapticMouse::setSession(vtkHapticSession* session)
{
  this->Mouse->SetSession(session);
}

void pqHapticMouse::setView(pqRenderView* view)
{
  this->View = view;
  vtkSMRenderViewProxy* proxy = view ? view->getRenderViewProxy() : nullptr;
  this->Mouse->SetRenderer(proxy ? proxy->GetRenderer() : nullptr);
  this->Input->SetInteractor(proxy ? proxy->GetInteractor() : nullptr);
}

void pqHapticMouse::setActive(bool active)
{
  const bool leads = active && this->Mouse->GetSession() && this->Mouse->GetSession()->GetFollowsMouse();
  if (leads != this->Active)
  {
    this->Active = leads;
    this->Mouse->Leave();
    this->showStatus();
  }
}

void pqHapticMouse::update()
{
  this->Mouse->Update();
  this->showStatus();
}

void pqHapticMouse::showStatus()
{
  QString text;
  if (this->Active)
  {
    const vtkHapticSession* session = this->Mouse->GetSession();
    const QString how =
      session->GetPlaneWorld() ? tr("The hand follows the pointer in the plane; keys: see the panel.")
      : this->Mouse->GetAdvances()
        ? tr("The pointer aims, Shift + left button advances, Shift + wheel by steps; keys: see the panel.")
        : tr("Shift + left button presses, the wheel presses deeper; keys: see the panel.");
    text = tr("%1 N: %2").arg(session->GetForceMagnitude(), 0, 'f', 2).arg(how);
  }
  if (text != this->Status)
  {
    this->Status = text;
    pqHapticSayInStatusBar(text, untilTheNext);
  }
}

QString pqHapticMouse::help() const
{
  vtkHapticSession* session = this->Mouse->GetSession();
  if (!session || !session->GetFollowsMouse())
  {
    return QString();
  }
  if (session->GetPlaneWorld())
  {
    return tr("Move the pointer over the view: the hand follows the pointer in the plane of the lines, and walls stop "
              "the hand. Arrow keys also move the hand, Ctrl+Shift+P reduces its motion, Ctrl+Shift+C keeps it in "
              "place. All other input moves the camera.");
  }
  if (this->Mouse->GetAdvances())
  {
    return tr("Move the pointer over the view to aim. Shift + left button advances until it is released, Shift + wheel "
              "by 2 mm of the hand, the handle at the left edge of the view to any depth. Keys: arrows aim, Page Down "
              "advances, Page Up draws back, Home draws back to the "
              "beginning. All other input moves the camera.");
  }
  QString text =
    tr("Move the pointer over the view. Shift + left button presses, the wheel presses deeper. Keys: arrows move, Page "
       "Down presses deeper, Page Up less deep, Home lifts. While pressed, Ctrl+Shift+P reduces the hand's motion and "
       "Ctrl+Shift+C keeps the hand in place. All other input moves the camera.");
  const double used = this->Mouse->GetUsedDepth();
  if (used < sameDepth * session->GetSetting("PressDepth") * session->GetSetting("Scale"))
  {
    text += tr(" Presses only %1 u, 1/20 of the scene: choose Fit for a larger depth.").arg(used, 0, 'g', 3);
  }
  return text;
}

void pqHapticMouse::deepened()
{
  Q_EMIT this->depthChanged(this->Mouse->GetSession()->GetSetting("PressDepth"));
}

void pqHapticMouse::focusMoved(QWidget* from, QWidget* to)
{
  const QWidget* view = this->View ? this->View->widget() : nullptr;
  if (Holds(view, from) && !Holds(view, to))
  {
    this->Mouse->Leave();
  }
}
