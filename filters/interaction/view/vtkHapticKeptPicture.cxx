// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticKeptPicture.h"

#include <algorithm>
#include <vector>

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
/// Values of OpenGL's own header, which VTK hands on under another name with each of its loaders.
constexpr unsigned int colourBufferBit = 0x4000, depthBufferBit = 0x100, nearest = 0x2600;

std::vector<vtkRenderer*> LayersBelow(vtkRenderer& hand)
{
  std::vector<vtkRenderer*> below;
  vtkRendererCollection* const all = hand.GetRenderWindow()->GetRenderers();
  vtkCollectionSimpleIterator it;
  all->InitTraversal(it);
  while (vtkRenderer* renderer = all->GetNextRenderer(it))
  {
    if (renderer->GetLayer() < hand.GetLayer())
    {
      below.push_back(renderer);
    }
  }
  return below;
}

/// When the data of a prop were last modified; its pipeline is not brought up to date, as this is no picture of it.
vtkMTimeType DrawnSince(vtkProp& prop)
{
  auto* const actor = vtkActor::SafeDownCast(&prop);
  auto* const volume = vtkVolume::SafeDownCast(&prop);
  vtkAbstractMapper3D* const mapper = actor    ? static_cast<vtkAbstractMapper3D*>(actor->GetMapper())
                                      : volume ? volume->GetMapper()
                                               : nullptr;
  const bool fed = mapper && mapper->GetNumberOfInputConnections(0) > 0;
  vtkMTimeType time = prop.GetMTime();
  for (vtkObject* part :
    { static_cast<vtkObject*>(mapper), static_cast<vtkObject*>(volume ? volume->GetProperty() : nullptr),
      static_cast<vtkObject*>(fed ? mapper->GetInputDataObject(0, 0) : nullptr) })
  {
    time = std::max(time, part ? part->GetMTime() : vtkMTimeType{ 0 });
  }
  return time;
}

/// The renderer's own time is left out: each conversion of a place on the screen modifies a renderer.
vtkMTimeType DrawnSince(vtkRenderer& renderer)
{
  vtkMTimeType time = renderer.GetActiveCamera()->GetMTime();
  vtkCollectionSimpleIterator it;
  renderer.GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer.GetLights()->GetNextLight(it))
  {
    time = std::max(time, light->GetMTime());
  }
  renderer.GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = renderer.GetViewProps()->GetNextProp(it))
  {
    time = std::max(time, DrawnSince(*prop));
  }
  return time;
}

void Copy(vtkOpenGLRenderWindow& window, vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to)
{
  vtkOpenGLState& state = *window.GetState();
  state.PushFramebufferBindings();
  from.Bind(vtkOpenGLFramebufferObject::GetReadMode());
  from.ActivateReadBuffer(0);
  to.Bind(vtkOpenGLFramebufferObject::GetDrawMode());
  to.ActivateDrawBuffer(0);
  const int* const size = window.GetSize();
  state.vtkglViewport(0, 0, size[0], size[1]);
  state.vtkglScissor(0, 0, size[0], size[1]);
  state.vtkglBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], colourBufferBit | depthBufferBit, nearest);
  state.PopFramebufferBindings();
}
} // namespace

vtkHapticKeptPicture::vtkHapticKeptPicture() = default;

vtkHapticKeptPicture::~vtkHapticKeptPicture()
{
  this->SetRenderer(nullptr);
}

vtkOpenGLRenderWindow* vtkHapticKeptPicture::Window() const
{
  return this->Hand ? vtkOpenGLRenderWindow::SafeDownCast(this->Hand->GetRenderWindow()) : nullptr;
}

void vtkHapticKeptPicture::SetRenderer(vtkRenderer* hand)
{
  if (hand == this->Hand)
  {
    return;
  }
  this->Release();
  if (this->Hand)
  {
    this->Hand->RemoveObserver(this->Observer);
  }
  this->Hand = hand;
  if (hand)
  {
    this->Observer = hand->AddObserver(vtkCommand::StartEvent, this, &vtkHapticKeptPicture::LayersAreDrawn);
  }
}

void vtkHapticKeptPicture::Release()
{
  vtkOpenGLRenderWindow* const window = this->Window();
  if (window && this->Holds())
  {
    window->MakeCurrent();
    this->Kept->ReleaseGraphicsResources(window);
  }
  this->Size[0] = this->Size[1] = 0;
}

/// A window whose context ended, as where a view is moved into another window, released the kept picture.
bool vtkHapticKeptPicture::Holds() const
{
  return this->Size[0] > 0 && this->Kept->GetFBOIndex() != 0;
}

void vtkHapticKeptPicture::LayersAreDrawn()
{
  if (vtkOpenGLRenderWindow* const window = this->Window())
  {
    this->PuttingBack ? this->PutBack(*window) : this->Keep(*window);
  }
}

void vtkHapticKeptPicture::Keep(vtkOpenGLRenderWindow& window)
{
  const int* const size = window.GetSize();
  const int samples = window.GetRenderFramebuffer()->GetMultiSamples();
  if (!this->Holds() || samples != this->Samples)
  {
    this->Kept->ReleaseGraphicsResources(&window);
    this->Kept->SetContext(&window);
    window.GetState()->PushFramebufferBindings();
    // The formats are those of the window's own buffer, without which depths of several samples cannot be copied.
    const bool whole = this->Kept->PopulateFramebuffer(
      size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, 32, samples, window.GetStencilCapable() != 0);
    window.GetState()->PopFramebufferBindings();
    if (!whole)
    {
      this->Size[0] = this->Size[1] = 0;
      return;
    }
  }
  else if (size[0] != this->Size[0] || size[1] != this->Size[1])
  {
    this->Kept->Resize(size[0], size[1]);
  }
  std::copy_n(size, 2, this->Size);
  this->Samples = samples;
  Copy(window, *window.GetRenderFramebuffer(), *this->Kept);
  this->KeptAt.Modified();
}

void vtkHapticKeptPicture::PutBack(vtkOpenGLRenderWindow& window)
{
  Copy(window, *this->Kept, *window.GetRenderFramebuffer());
}

bool vtkHapticKeptPicture::IsCurrent() const
{
  vtkOpenGLRenderWindow* const window = this->Window();
  const bool twoEyes = window && window->GetStereoRender() != 0; // each of which has a picture of its own
  if (!window || twoEyes || !this->Holds() || window->GetSize()[0] != this->Size[0] ||
      window->GetSize()[1] != this->Size[1])
  {
    return false;
  }
  const auto below = LayersBelow(*this->Hand);
  return std::all_of(below.begin(), below.end(),
    [this](vtkRenderer* renderer) { return DrawnSince(*renderer) < this->KeptAt.GetMTime(); });
}

void vtkHapticKeptPicture::DrawHand()
{
  std::vector<vtkRenderer*> drawn;
  for (vtkRenderer* renderer : LayersBelow(*this->Hand))
  {
    if (renderer->GetDraw())
    {
      renderer->DrawOff();
      drawn.push_back(renderer);
    }
  }
  this->PuttingBack = true;
  this->Hand->GetRenderWindow()->Render();
  this->PuttingBack = false;
  for (vtkRenderer* renderer : drawn)
  {
    renderer->DrawOn();
  }
}
