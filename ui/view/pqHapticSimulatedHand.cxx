// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSimulatedHand.h"

#include "devices/simulated/DeviceModels.h"
#include "pqHapticController.h"
#include "pqHapticViewFollower.h"
#include "pqRenderView.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"

#include <QTimer>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int placesOfRow = 24;     // each costs a picture of the view
constexpr double leastCosine = 0.5; // of the angle between normal and camera: beyond 60 degrees a press slides off
constexpr double lift_m = 0.01;     // of the hand, in front of the surface
/// Rows of the screen that are looked at until one shows the surface; shares of the height of the data.
constexpr std::array rows = { 0.5, 0.65, 0.35, 0.8, 0.2 };

/// Lower and upper corner of the data on the screen [pixels].
std::array<double, 4> ExtentOnScreen(vtkRenderer& renderer, const vtkBoundingBox& box)
{
  std::array<double, 4> extent = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int i = 0; i < 8; ++i)
  {
    double corner[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCorner(i, corner);
    renderer.SetWorldPoint(corner);
    renderer.WorldToDisplay();
    const double* const at = renderer.GetDisplayPoint();
    extent = { std::min(extent[0], at[0]), std::min(extent[1], at[1]), std::max(extent[2], at[0]),
      std::max(extent[3], at[1]) };
  }
  const int* const size = renderer.GetSize();
  return { std::max(extent[0], 0.0), std::max(extent[1], 0.0), std::min(extent[2], size[0] - 1.0),
    std::min(extent[3], size[1] - 1.0) };
}

bool IsKnown(const double* vector)
{
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}
} // namespace

pqHapticSimulatedHand::pqHapticSimulatedHand(pqHapticController* controller)
  : Superclass(controller), Controller(controller)
{
}

pqHapticSimulatedHand::~pqHapticSimulatedHand()
{
  this->forget();
}

void pqHapticSimulatedHand::forget()
{
  if (this->Prepared)
  {
    this->Prepared->RemoveObserver(this->Observer);
  }
  this->Prepared = nullptr;
  this->Way.clear();
}

void pqHapticSimulatedHand::prepare()
{
  vtkHapticSession* const session = this->Controller->session();
  pqRenderView* const view = this->Controller->follower()->view();
  this->forget();
  if (!session || !view || !palpate::deviceModel(session->GetSettingText("DeviceName")) ||
      session->GetNumberOfStrokePoints() > 0)
  {
    return;
  }
  this->Controller->follower()->handOver();
  session->FinishScene(); // the workspace is fitted to the scene before the hand is led
  this->Way = seenIn(*view);
  this->Prepared = session;
  this->Observer = session->AddObserver(vtkCommand::StartEvent, this, &pqHapticSimulatedHand::lead);
}

pqHapticSimulatedHand::Places pqHapticSimulatedHand::seenIn(pqRenderView& view)
{
  vtkRenderer& renderer = *view.getRenderViewProxy()->GetRenderer();
  double bounds[6];
  renderer.ComputeVisiblePropBounds(bounds);
  const vtkBoundingBox box(bounds);
  if (!box.IsValid())
  {
    return {};
  }
  Point toCamera{}, middle{}, front{};
  renderer.GetActiveCamera()->GetDirectionOfProjection(toCamera.data());
  vtkMath::MultiplyScalar(toCamera.data(), -1.0);
  const auto [left, low, right, high] = ExtentOnScreen(renderer, box);
  for (const double row : rows)
  {
    const Places seen = seenInRow(view, low + row * (high - low), left, right, toCamera);
    if (seen.size() > 1)
    {
      return seen;
    }
  }
  box.GetCenter(middle.data());
  for (int k = 0; k < 3; ++k)
  {
    front[k] = middle[k] + box.GetDiagonalLength() / 2.0 * toCamera[k];
  }
  return { { front, toCamera }, { middle, toCamera } };
}

/// The longest part of the row whose places face the camera.
pqHapticSimulatedHand::Places pqHapticSimulatedHand::seenInRow(
  pqRenderView& view, double y, double from, double to, const Point& toCamera)
{
  Places longest, run;
  for (int i = 0; i < placesOfRow; ++i)
  {
    const int pixel[2] = { static_cast<int>(from + (i + 0.5) / placesOfRow * (to - from)), static_cast<int>(y) };
    Place place;
    const bool hit =
      view.getRenderViewProxy()->ConvertDisplayToPointOnSurface(pixel, place.At_W.data(), place.Normal_W.data());
    place.Normal_W = IsKnown(place.Normal_W.data()) ? place.Normal_W : toCamera;
    const double cosine = vtkMath::Dot(place.Normal_W.data(), toCamera.data());
    if (!hit || !IsKnown(place.At_W.data()) || std::abs(cosine) < leastCosine)
    {
      run.clear();
      continue;
    }
    vtkMath::MultiplyScalar(place.Normal_W.data(), cosine < 0.0 ? -1.0 : 1.0);
    run.push_back(place);
    longest = run.size() > longest.size() ? run : longest;
  }
  return longest;
}

/// The session has its scale now, and makes the device next.
void pqHapticSimulatedHand::lead()
{
  vtkHapticSession* const session = this->Prepared;
  const double scale = session->GetSetting("Scale"), depth_u = scale * session->GetSetting("PressDepth");
  const auto add = [session](const Place& place, double out_u)
  {
    session->AddStrokePoint(place.At_W[0] + out_u * place.Normal_W[0], place.At_W[1] + out_u * place.Normal_W[1],
      place.At_W[2] + out_u * place.Normal_W[2]);
  };
  if (!this->Way.empty())
  {
    add(this->Way.front(), scale * lift_m);
  }
  for (const Place& place : this->Way)
  {
    add(place, -depth_u);
  }
  this->forget();
  const vtkWeakPointer<vtkHapticSession> led = session;
  QTimer::singleShot(0, this,
    [led]
    {
      if (led)
      {
        led->ClearStrokePoints(); // another view or another scene has another path
      }
    });
}
