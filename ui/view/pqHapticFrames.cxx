// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticFrames.h"

#include "pqRenderView.h"
#include "pqServer.h"
#include "vtkActor.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkHapticToolProps.h"
#include "vtkMapper.h"
#include "vtkPVRenderView.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSession.h"

#include <QWidget>

namespace
{
/// Time for the person's own events between two frames [ms].
constexpr int pauseBetweenFrames = 16;
/// A hidden view never ends a frame: ask again after this long [ms].
constexpr int pauseWhenHidden = 250;
/// Balls this large, as a fraction of the scene's diagonal, are seen beside ParaView's panels too.
constexpr double relativeSize = 0.016;
/// Units of depth, more than a 16 bit depth buffer has.
constexpr double inFrontOfEverything = -66000.0;

vtkRenderer* RendererOf(pqRenderView* view)
{
  auto* object = vtkPVRenderView::SafeDownCast(view->getRenderViewProxy()->GetClientSideObject());
  return object ? object->GetRenderer(vtkPVRenderView::NON_COMPOSITED_RENDERER) : nullptr;
}

/// Whether a picture can be drawn at once: a view that closes has no widget, then no proxy, and one that waits for an
/// answer draws later.
bool CanDraw(pqRenderView& view)
{
  const QWidget* const widget = view.widget();
  return widget && widget->isVisible() && view.getViewProxy() &&
         !view.getViewProxy()->GetSession()->GetPendingProgress() && !view.getServer()->isProcessingPending();
}
} // namespace

pqHapticFrames::pqHapticFrames(QObject* parent) : Superclass(parent)
{
  this->Props->SetRelativeSize(relativeSize);
  // A hand that presses is inside the surface under it: drawn in front of it, else its depth could not be seen.
  vtkMapper* hand = this->Props->GetHandActor()->GetMapper();
  hand->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, inFrontOfEverything);
  this->Pause.setSingleShot(true);
  this->connect(&this->Pause, &QTimer::timeout, this, &pqHapticFrames::nextFrame);
}

pqHapticFrames::~pqHapticFrames()
{
  this->detach();
}

void pqHapticFrames::setSession(vtkHapticSession* session)
{
  this->Session = session;
  this->follow();
}

void pqHapticFrames::showTrace(bool shown)
{
  this->Props->SetShowTrace(shown);
  this->follow();
}

void pqHapticFrames::showPlaces(bool shown)
{
  this->Props->SetShowPlaces(shown);
}

void pqHapticFrames::setActive(bool active)
{
  if (active == this->Active)
  {
    return;
  }
  this->Active = active;
  if (active)
  {
    this->attach();
    this->Pause.start(0);
  }
  else
  {
    this->Pause.stop();
    this->follow();
  }
}

void pqHapticFrames::follow()
{
  if (this->Active)
  {
    return;
  }
  if (!this->Props->GetShowTrace() || !this->Session)
  {
    this->detach();
    return;
  }
  this->attach();
  this->Props->UpdateFrom(this->Session);
  if (this->View)
  {
    this->View->render();
  }
}

void pqHapticFrames::setView(pqRenderView* view)
{
  if (view == this->View)
  {
    return;
  }
  this->detach();
  this->View = view;
  if (this->Active)
  {
    this->attach();
    this->Pause.start(0);
  }
  this->follow();
}

void pqHapticFrames::attach()
{
  vtkRenderer* renderer = this->View ? RendererOf(this->View) : nullptr;
  if (renderer && !this->Attached)
  {
    this->Props->AddToRenderer(renderer);
    this->Kept.SetRenderer(renderer);
    this->FrameBegins = this->connect(this->View.data(), &pqView::beginRender, this, &pqHapticFrames::takeState);
    this->FrameEnded = this->connect(this->View.data(), &pqView::endRender, this, &pqHapticFrames::frameEnded);
    this->Attached = true;
  }
}

void pqHapticFrames::detach()
{
  this->disconnect(this->FrameBegins);
  this->disconnect(this->FrameEnded);
  if (this->Attached)
  {
    this->Kept.SetRenderer(nullptr);
    this->Props->RemoveFromRenderer();
    this->Attached = false;
    if (this->View)
    {
      this->View->render();
    }
  }
}

/// For pictures from any cause: while a camera turns, one frame follows the other and none of them was asked for here.
void pqHapticFrames::takeState()
{
  if (!this->Active || !this->Session)
  {
    return;
  }
  this->Session->GetSight()->FollowCamera(this->View->getRenderViewProxy()->GetActiveCamera());
  this->Session->Update();
  Q_EMIT this->updated();
  this->Props->UpdateFrom(this->Session);
}

void pqHapticFrames::nextFrame()
{
  if (this->Attached)
  {
    this->takeState(); // a hidden view draws nothing, but the touch goes on
    this->Pause.start(pauseWhenHidden);
    if (this->onlyTheHandMoved())
    {
      this->Kept.DrawHand();
      this->frameEnded();
      Q_EMIT this->handDrawn();
      return;
    }
    this->View->render();
  }
}

bool pqHapticFrames::onlyTheHandMoved() const
{
  return CanDraw(*this->View) && !this->View->getViewProxy()->GetNeedsUpdate() && this->Kept.IsCurrent();
}

void pqHapticFrames::frameEnded()
{
  if (this->Active)
  {
    this->Pause.start(pauseBetweenFrames);
  }
}
