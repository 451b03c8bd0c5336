// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticPencil.h"

#include "pqUndoStack.h"
#include "vtkCommand.h"
#include "vtkHapticPencil.h"
#include "vtkHapticSession.h"
#include "vtkSMRenderViewProxy.h"

#include <QCursor>
#include <QWidget>

pqHapticPencil::pqHapticPencil(QObject* parent) : Superclass(parent)
{
  this->Pencil->AddObserver(vtkCommand::StartInteractionEvent, this, &pqHapticPencil::begin);
  this->Pencil->AddObserver(vtkCommand::InteractionEvent, this, &pqHapticPencil::showLine);
  this->Pencil->AddObserver(vtkCommand::EndInteractionEvent, this, &pqHapticPencil::end);
}

pqHapticPencil::~pqHapticPencil() = default;

void pqHapticPencil::setSession(vtkHapticSession* session)
{
  this->Pencil->SetSession(session);
}

void pqHapticPencil::setView(pqRenderView* view)
{
  if (view != this->View)
  {
    this->leaveView();
    this->View = view;
  }
  this->Pencil->SetView(view ? view->getProxy() : nullptr);
  this->showCursor();
}

void pqHapticPencil::leaveView()
{
  const QPointer<pqRenderView> left = this->View;
  const bool drawn = this->Pencil->GetLine() != nullptr;
  this->View = nullptr;
  this->Pencil->SetView(nullptr);
  // ParaView 5.13 takes the widget out of a closing view before it says that another view is active.
  if (left && left->widget())
  {
    left->setCursor(QCursor());
  }
  if (left && drawn)
  {
    // Its line is finished now. With its next frame, not at once: a view that is left may be closing.
    left->render();
  }
}

void pqHapticPencil::setActive(bool active)
{
  this->Pencil->SetActive(active);
  this->showCursor();
}

void pqHapticPencil::showCursor()
{
  if (this->View)
  {
    this->View->setCursor(this->Pencil->GetActive() ? QCursor(Qt::CrossCursor) : QCursor());
  }
}

void pqHapticPencil::begin()
{
  BEGIN_UNDO_SET(tr("Draw"));
}

void pqHapticPencil::showLine()
{
  if (this->View)
  {
    this->View->render();
  }
}

void pqHapticPencil::end()
{
  END_UNDO_SET();
  if (this->View)
  {
    // At once: until then the shown data have the points of the finished line, and the cells of the one before.
    this->View->forceRender();
  }
}
