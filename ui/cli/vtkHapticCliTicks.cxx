// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliTicks.h"

#include <algorithm>
#include <array>

vtkHapticCliStopwatch::vtkHapticCliStopwatch()
{
  std::array<double, 1001> empty{};
  for (double& cost : empty)
  {
    this->Start();
    cost = this->Cost_us();
  }
  auto* const middle = empty.begin() + empty.size() / 2;
  std::nth_element(empty.begin(), middle, empty.end());
  this->Overhead_us = *middle;
}

double vtkHapticCliStopwatch::Cost_us() const
{
  constexpr double usPerNs = 1e-3;
  const double elapsed_us = static_cast<double>(this->Clock.now_ns() - this->Start_ns) * usPerNs;
  return std::max(0.0, elapsed_us - this->Overhead_us);
}

void vtkHapticCliWriteHeader(vtkHapticCliOutput& output, const std::string& more)
{
  output.Header("t,device_x,device_y,device_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contacts,cost_us" + more);
}

void vtkHapticCliWriteTick(vtkHapticCliOutput& output, double time_s, const palpate::HapticState& state, double cost_us,
  const std::vector<double>& more)
{
  output.Value(time_s);
  for (const palpate::Vec3& triple : { state.device_W.p, state.proxy_W.p, state.force_W })
  {
    output.Value(triple.x());
    output.Value(triple.y());
    output.Value(triple.z());
  }
  output.Value(state.contacts);
  output.Value(cost_us);
  for (const double value : more)
  {
    output.Value(value);
  }
  output.EndRow();
}

const char* vtkHapticCliSaid(palpate::LawChange change)
{
  switch (change)
  {
    case palpate::LawChange::Punctured:
      return "punctured";
    case palpate::LawChange::Withdrawn:
      return "withdrawn";
    case palpate::LawChange::Broken:
      return "broken";
    case palpate::LawChange::TornOut:
      return "torn out";
  }
  return "";
}
