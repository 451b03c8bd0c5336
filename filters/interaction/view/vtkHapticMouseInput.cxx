// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMouseInput.h"

#include <string>
#include <utility>
#include <vector>

#include "vtkCommand.h"
#include "vtkHapticMouse.h"
#include "vtkHapticSession.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

vtkStandardNewMacro(vtkHapticMouseInput);

namespace
{
/// Styles have 0, widgets 0.5: events that the hand takes must not turn the camera too.
constexpr float beforeOthers = 1.0F;
constexpr double deeper = 1.25; ///< a notch of the wheel, a key
constexpr double step_px = 10.0;
constexpr double smallStep_px = 1.0;
} // namespace

class vtkHapticMouseInput::Internals
{
public:
  vtkSmartPointer<vtkHapticMouse> Mouse;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  std::vector<unsigned long> Observers;
  bool ButtonTaken = false; ///< the left button went down to press, so until it is up its drag is no camera's

  /// True: no other observer is to hear of it.
  bool Heard(vtkObject*, unsigned long event, void*);
  bool Take(unsigned long event);
  bool TakeWheel(bool on);
  void GoDeeper(bool on);
  bool TakeKey(const std::string& key);
  /// In a plane world there is nothing to press.
  bool Presses() const { return !this->Mouse->GetSession()->GetPlaneWorld(); }
  void Forget();
};

bool vtkHapticMouseInput::Internals::Heard(vtkObject*, unsigned long event, void*)
{
  if (!this->Mouse || !this->Mouse->GetLeads())
  {
    this->ButtonTaken = false;
    return false;
  }
  const bool taken = this->Take(event);
  this->Mouse->Update();
  return taken;
}

bool vtkHapticMouseInput::Internals::Take(unsigned long event)
{
  const int* at = this->Interactor->GetEventPosition();
  switch (event)
  {
    case vtkCommand::LeaveEvent:
      this->Mouse->Leave();
      return false;
    case vtkCommand::LeftButtonPressEvent:
      if (this->Mouse->GrabDepth(at[0], at[1]))
      {
        return true;
      }
      this->Mouse->SetPointer(at[0], at[1]);
      this->Mouse->SetPressing(this->Presses() && this->Interactor->GetShiftKey() != 0);
      return this->ButtonTaken = this->Mouse->GetPressing();
    case vtkCommand::LeftButtonReleaseEvent:
      if (this->Mouse->GetDragsDepth())
      {
        this->Mouse->DropDepth();
        return true;
      }
      this->Mouse->SetPressing(this->Mouse->GetPressing() && !this->ButtonTaken);
      return std::exchange(this->ButtonTaken, false);
    case vtkCommand::MouseWheelForwardEvent:
      return this->TakeWheel(true);
    case vtkCommand::MouseWheelBackwardEvent:
      return this->TakeWheel(false);
    case vtkCommand::KeyPressEvent:
      return this->TakeKey(this->Interactor->GetKeySym() ? this->Interactor->GetKeySym() : "");
    default: // it enters or moves
      if (this->Mouse->GetDragsDepth())
      {
        this->Mouse->DragDepth(at[1]);
        return true;
      }
      this->Mouse->SetPointer(at[0], at[1]);
      return this->ButtonTaken && this->Mouse->GetPressing();
  }
}

/// A hand that advances goes on by a notch.
void vtkHapticMouseInput::Internals::GoDeeper(bool on)
{
  this->Mouse->GetAdvances() ? this->Mouse->Advance(on ? 1.0 : -1.0) : this->Mouse->Deepen(on ? deeper : 1.0 / deeper);
}

bool vtkHapticMouseInput::Internals::TakeWheel(bool on)
{
  const bool taken = this->Presses() && (this->Mouse->GetPressing() || this->Interactor->GetShiftKey());
  if (taken)
  {
    this->GoDeeper(on);
  }
  return taken;
}

bool vtkHapticMouseInput::Internals::TakeKey(const std::string& key)
{
  const double step = this->Interactor->GetShiftKey() ? smallStep_px : step_px;
  if (key == "Left" || key == "Right")
  {
    this->Mouse->MovePointer(key == "Left" ? -step : step, 0.0);
  }
  else if (key == "Down" || key == "Up")
  {
    this->Mouse->MovePointer(0.0, key == "Down" ? -step : step);
  }
  else if (!this->Presses())
  {
    return false;
  }
  else if (key == "Next" || key == "Prior")
  {
    const bool pressed = this->Mouse->GetPressing(), on = key == "Next";
    this->Mouse->MovePointer(0.0, 0.0);
    const bool advances = this->Mouse->GetAdvances();
    if (advances || pressed || !on) // the first press is as deep as the last one
    {
      this->GoDeeper(on);
    }
    this->Mouse->SetPressing(!advances && (pressed || on));
  }
  else if (key == "Home")
  {
    this->Mouse->Lift();
  }
  else
  {
    return false;
  }
  return true;
}

void vtkHapticMouseInput::Internals::Forget()
{
  for (unsigned long observer : this->Observers)
  {
    if (this->Interactor)
    {
      this->Interactor->RemoveObserver(observer);
    }
  }
  this->Observers.clear();
}

vtkHapticMouseInput::vtkHapticMouseInput() : Impl(std::make_unique<Internals>()) {}

vtkHapticMouseInput::~vtkHapticMouseInput()
{
  this->Impl->Forget();
}

void vtkHapticMouseInput::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Interactor: " << this->Impl->Interactor.Get() << "\n";
}

void vtkHapticMouseInput::SetMouse(vtkHapticMouse* mouse)
{
  this->Impl->Mouse = mouse;
}

void vtkHapticMouseInput::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  Internals& impl = *this->Impl;
  if (interactor == impl.Interactor)
  {
    return;
  }
  impl.Forget();
  impl.Interactor = interactor;
  for (unsigned long event : { vtkCommand::EnterEvent, vtkCommand::LeaveEvent, vtkCommand::MouseMoveEvent,
         vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent, vtkCommand::MouseWheelForwardEvent,
         vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent })
  {
    if (interactor)
    {
      impl.Observers.push_back(interactor->AddObserver(event, &impl, &Internals::Heard, beforeOthers));
    }
  }
}
