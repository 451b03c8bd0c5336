// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticPencil.h"

#include "pqUndoStack.h"
#include "vtkCommand.h"
#include "vtkHapticPencil.h"
#include "vtkHapticSession.h"
#include "vtkSMRenderViewProxy.h"

#include <QCursor>

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
  if (this->View && view != this->View)
  {
    this->View->setCursor(QCursor());
  }
  this->View = view;
  this->Pencil->SetView(view ? view->getProxy() : nullptr);
  this->showCursor();
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
    // At once: until then what is shown has the points of the finished line, and the cells of the one before.
    this->View->forceRender();
  }
}
