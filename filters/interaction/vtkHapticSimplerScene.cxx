// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSimplerScene.h"

#include <chrono>
#include <utility>

#include "haptics/contact/RadiusLimit.h"

vtkHapticSimplerScene::~vtkHapticSimplerScene()
{
  this->Cancel();
  if (this->Running.valid())
  {
    this->Running.wait();
  }
}

bool vtkHapticSimplerScene::Follow(std::shared_ptr<const palpate::Scene> full,
  std::vector<palpate::SurfaceChoice> choices, const palpate::SimplifyRules& rules, std::uint64_t revision)
{
  this->Cancel();
  this->Next = Order{ std::move(full), std::move(choices), rules, revision };
  return !this->Running.valid() && this->Launch();
}

void vtkHapticSimplerScene::Cancel()
{
  this->Stop.request_stop();
  this->Next.reset();
}

bool vtkHapticSimplerScene::Launch()
{
  this->Stop = std::stop_source();
  this->Next->Rules.stop = this->Stop.get_token();
  Order order = *std::exchange(this->Next, std::nullopt);
  const bool known = this->Simplifier.knows(*order.Full, order.Choices, order.Rules);
  this->Running = std::async(known ? std::launch::deferred : std::launch::async,
    [this, order = std::move(order)]() mutable { return this->Look(std::move(order)); });
  if (known)
  {
    this->Running.wait();
  }
  return known;
}

vtkHapticFoundScene vtkHapticSimplerScene::Look(Order order)
{
  vtkHapticFoundScene found{ this->Simplifier.simplify(
    *order.Full, std::move(order.Choices), order.Rules, order.Revision) };
  found.LargestRadius_u = found.scene ? palpate::radiusLimit(*found.scene, {}).largest_u : 0.0;
  return found;
}

std::optional<vtkHapticFoundScene> vtkHapticSimplerScene::Poll()
{
  if (!this->Running.valid() || this->Running.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
  {
    return std::nullopt;
  }
  const bool wanted = !this->Stop.stop_requested();
  vtkHapticFoundScene found = this->Running.get();
  if (this->Next)
  {
    this->Launch();
  }
  return wanted ? std::optional(std::move(found)) : std::nullopt;
}

std::optional<vtkHapticFoundScene> vtkHapticSimplerScene::Wait()
{
  while (this->Running.valid())
  {
    this->Running.wait();
    if (auto found = this->Poll())
    {
      return found;
    }
  }
  return std::nullopt;
}
