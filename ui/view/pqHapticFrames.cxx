// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticFrames.h"

#include "pqRenderView.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkHapticToolProps.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPVRenderView.h"
#include "vtkSMRenderViewProxy.h"

#include <algorithm>

namespace
{
/// A frame begins so long after the one before, and leaves the person's own events so long in any case [ms].
constexpr int frameToFrame = 25, leastPause = 4;
/// A frame of full quality that takes longer is drawn as while the camera turns: less than 20 a second are seen [ms].
constexpr int slowFrame = 50;
/// A hand that stops is drawn in full quality after this time [ms].
constexpr qint64 moment = 400;
/// The hand is seen to move by this share of its distance from the eye.
constexpr double seenShare = 1e-3;
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
} // namespace

pqHapticFrames::pqHapticFrames(QObject* parent) : Superclass(parent)
{
  this->Props->SetRelativeSize(relativeSize);
  // A hand that presses is inside what it presses on: drawn in front of it, else nobody would see how deep.
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
    this->Props->RemoveFromRenderer();
    this->Attached = false;
    if (this->View)
    {
      this->View->render();
    }
  }
}

/// Whoever draws: while a camera turns, one frame follows the other and none of them was asked for here.
void pqHapticFrames::takeState()
{
  if (!this->Active || !this->Session)
  {
    return;
  }
  this->Frame.start();
  this->Session->GetSight()->FollowCamera(this->View->getRenderViewProxy()->GetActiveCamera());
  this->Session->Update();
  Q_EMIT this->updated();
  this->Props->UpdateFrom(this->Session);
}

void pqHapticFrames::nextFrame()
{
  if (this->Attached)
  {
    this->takeState(); // a hidden view draws nothing, and what it touches goes on
    this->Pause.start(pauseWhenHidden);
    this->Whole = this->Took <= slowFrame || !this->handMoves();
    this->Whole ? this->View->render() : this->View->getRenderViewProxy()->InteractiveRender();
  }
}

bool pqHapticFrames::handMoves()
{
  const double* const hand = this->Session->GetHandPosition();
  const double* const eye = this->View->getRenderViewProxy()->GetActiveCamera()->GetPosition();
  const double far2 = vtkMath::Distance2BetweenPoints(hand, eye);
  if (vtkMath::Distance2BetweenPoints(hand, this->Hand.data()) > seenShare * seenShare * far2)
  {
    this->Moved.start();
  }
  std::copy(hand, hand + 3, this->Hand.begin());
  return this->Moved.isValid() && this->Moved.elapsed() < moment;
}

void pqHapticFrames::frameEnded()
{
  if (this->Active)
  {
    const qint64 took = this->Frame.isValid() ? this->Frame.elapsed() : 0;
    this->Took = this->Whole ? took : this->Took;
    this->Pause.start(std::max(leastPause, frameToFrame - static_cast<int>(took)));
  }
}
