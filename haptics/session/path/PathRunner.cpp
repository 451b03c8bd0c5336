// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/path/PathRunner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/session/path/PathKind.h"
#include "haptics/session/path/TickCost.h"

namespace palpate
{
namespace
{

constexpr std::size_t ticksBetweenLooks = 1000; ///< at whether it goes on

std::unique_ptr<PathKind> kindOf(const PathInputs& inputs, PathReport& report)
{
  report.refusal = refusePathSettings(inputs.settings);
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const bool loose =
    std::ranges::any_of(inputs.surfaces, [](const PathSurface& each) { return each.density_kg_per_m3 != 0.0; });
  return inputs.mechanism                        ? mechanismAlongPath(inputs, report)
         : loose || (inputs.tool && inputs.body) ? handAmongBodiesAlongPath(inputs, report)
         : inputs.tool                           ? toolAlongPath(inputs, report)
                                                 : ballAlongPath(inputs, report);
}

} // namespace

void noteTicks(PathReport& report, int ticks, const std::string& what)
{
  if (ticks > 0)
  {
    report.notes.push_back("in " + std::to_string(ticks) + " ticks " + what);
  }
}

PathRunner::PathRunner(PathInputs inputs) : inputs_(std::move(inputs)), kind_(kindOf(this->inputs_, this->report_))
{
  this->columns_ = this->kind_ ? this->kind_->columns() : std::vector<PathColumn>{};
}

PathRunner::~PathRunner() = default;

const BodyMaker* PathRunner::body() const noexcept
{
  return this->kind_ ? this->kind_->body() : nullptr;
}

bool PathRunner::run(const std::function<bool(double)>& goes,
  const std::function<void(std::size_t, const PathSample&, const PathTick&)>& take)
{
  const auto count = static_cast<double>(this->inputs_.path.size());
  TickCost cost;
  PathTick tick;
  for (std::size_t i = 0; i < this->inputs_.path.size(); ++i)
  {
    if (i % ticksBetweenLooks == 0 && !goes(static_cast<double>(i) / count))
    {
      return false;
    }
    const PathSample& sample = this->inputs_.path[i];
    cost.start();
    this->kind_->next(sample, tick);
    tick.cost_us = cost.cost_us();
    take(i, sample, tick);
  }
  this->kind_->finish(this->report_);
  return true;
}

} // namespace palpate
