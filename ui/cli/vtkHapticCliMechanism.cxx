// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms: bodies and the laws that join them, from a scene file.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "haptics/session/mechanism/MechanismTouch.h"
#include "vtkHapticCliCommands.h"
#include "vtkHapticCliOutput.h"
#include "vtkHapticCliPath.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliTicks.h"
#include "vtkHapticMechanismData.h"

namespace
{
vtkHapticMechanismResult ReadScene(const std::string& file)
{
  vtkHapticMechanismResult read = vtkHapticReadMechanism(file);
  if (!read.Inputs)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  return read;
}

std::unique_ptr<palpate::MechanismTouch> MakeFelt(
  const std::string& file, const palpate::MechanismInputs& inputs, const palpate::MechanismHold& hold)
{
  std::string refusal;
  auto touch = palpate::MechanismTouch::make(inputs, hold, refusal);
  if (!touch)
  {
    throw vtkHapticCliProblem(file + ": " + refusal);
  }
  return touch;
}

/// A mechanism is felt as its laws say: what else was asked for would be lost.
void CheckMechanismAlone(const vtkHapticCliTouchOptions& options)
{
  const std::string setting = options.Settings.GivenBeside({ "Stiffness", "Scale" });
  const std::string asked = !setting.empty()             ? setting
                            : options.Field.Any()        ? "--field"
                            : options.TwoD               ? "--two-d"
                            : !options.Materials.Empty() ? "an array of the material"
                            : !options.Tool.File.empty() ? "--tool"
                            : options.Soft.Young_Pa      ? "--young"
                            : options.Iso                ? "--iso"
                            : options.Files.size() > 1   ? "another file"
                                                         : "";
  if (!asked.empty())
  {
    throw vtkHapticCliProblem(asked + ": a mechanism does not feel it; leave it out");
  }
}

palpate::MechanismHold MechanismHoldOf(const vtkHapticCliTouchOptions& options)
{
  palpate::MechanismHold hold;
  hold.stiffness_N_per_m = options.Settings.Number("Stiffness");
  hold.scale_u_per_m = options.Settings.Number("Scale");
  hold.turning_N_m_per_rad = options.Turning_N_m_per_rad.value_or(0.0);
  hold.lowRate_Hz = options.Soft.LowRate_Hz();
  return hold;
}

std::string MechanismColumns(const palpate::Mechanism& mechanism)
{
  std::string columns = ",proxy_qw,proxy_qx,proxy_qy,proxy_qz,torque_x,torque_y,torque_z,residual";
  for (const palpate::MechanismLaw& law : mechanism.laws)
  {
    for (const char* what : { "_fx", "_fy", "_fz", "_phase", "_inside" })
    {
      columns += "," + law.name + what;
    }
  }
  return columns;
}

/// One row of what it did.
void WriteMechanism(vtkHapticCliOutput& output, const vtkHapticCliPathRow& row, const palpate::MechanismPlan& plan,
  const palpate::MechanismResult& result, double cost_us)
{
  palpate::HapticState state;
  state.device_W = row.Pose_W;
  state.proxy_W = result.pose_W[plan.held];
  state.force_W = result.wrench_W.force;
  const palpate::Quat& q = state.proxy_W.q;
  const palpate::Vec3& torque = result.wrench_W.torque;
  std::vector<double> more{ q.w(), q.x(), q.y(), q.z(), torque.x(), torque.y(), torque.z(), result.residual_u };
  for (int i = 0; i < plan.lawCount; ++i)
  {
    const palpate::LawNow& law = result.laws[i];
    state.contacts += law.force_W.squaredNorm() > 0.0 ? 1 : 0;
    const palpate::Vec3& force = law.force_W;
    more.insert(more.end(), { force.x(), force.y(), force.z(), static_cast<double>(law.phase), law.inside_u });
  }
  vtkHapticCliWriteTick(output, row.Time_s, state, cost_us, more);
}

void TellEvents(const palpate::Mechanism& mechanism, const palpate::MechanismResult& result, double time_s)
{
  for (int i = 0; i < result.eventCount; ++i)
  {
    const palpate::MechanismEvent& event = result.events[i];
    std::cerr << "palpate: " << time_s << " s: " << mechanism.laws[event.law].name << ' '
              << vtkHapticCliSaid(event.change) << " at " << event.force_N << " N\n";
  }
}

/// Each pair when it begins to overlap.
void TellOverlaps(const std::vector<palpate::BodyPair>& now, std::vector<palpate::BodyPair>& before, double time_s)
{
  for (const palpate::BodyPair& pair : now)
  {
    if (std::ranges::find(before, pair) == before.end())
    {
      std::cerr << "palpate: " << time_s << " s: " << palpate::overlapText(pair) << '\n';
    }
  }
  before = now;
}
} // namespace

int vtkHapticCliCheckMechanism(const vtkHapticCliCheckOptions& options)
{
  const std::string& file = options.File;
  const vtkHapticMechanismResult read = ReadScene(file);
  palpate::MechanismHold hold = palpate::usualHold(read.Inputs->unit_m);
  hold.turning_N_m_per_rad = options.Turning_N_m_per_rad.value_or(0.0);
  const auto touch = MakeFelt(file, *read.Inputs, hold);
  const palpate::MechanismCheck& check = touch->check();
  if (options.Json)
  {
    const nlohmann::ordered_json described{ { "file", file }, { "touchable", true }, { "rows", check.rows },
      { "rank", check.rank }, { "free_turns", check.freeTurns }, { "condition", check.condition },
      { "redundant", check.redundant }, { "free", check.free }, { "remarks", check.remarks } };
    std::cout << described.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    return 0;
  }
  std::cout << file << ": it can be felt\n";
  for (const std::string& line : vtkHapticMechanismText(*read.Inputs, check))
  {
    std::cout << "  " << line << '\n';
  }
  return 0;
}

int vtkHapticCliTouchMechanism(const vtkHapticCliTouchOptions& options)
{
  CheckMechanismAlone(options);
  const std::string& file = options.Files.front();
  const std::vector<vtkHapticCliPathRow> path = vtkHapticCliReadPath(options.Path);
  const vtkHapticMechanismResult read = ReadScene(file);
  const auto touch = MakeFelt(file, *read.Inputs, MechanismHoldOf(options));
  vtkHapticCliOutput output(options.Output, { file, options.Path });
  vtkHapticCliWriteHeader(output, MechanismColumns(read.Inputs->mechanism));
  vtkHapticCliStopwatch stopwatch;
  int capped = 0;
  std::vector<palpate::BodyPair> overlaps;
  for (const vtkHapticCliPathRow& row : path)
  {
    stopwatch.Start();
    const palpate::MechanismResult result = touch->next(row.Time_s, row.Pose_W);
    WriteMechanism(output, row, touch->plan(), result, stopwatch.Cost_us());
    TellEvents(read.Inputs->mechanism, result, row.Time_s);
    TellOverlaps(touch->overlaps(), overlaps, row.Time_s);
    capped += result.capped ? 1 : 0;
  }
  if (capped > 0)
  {
    std::cerr << "palpate: in " << capped << " rows the laws were not met within a tick's work\n";
  }
  output.Commit();
  return 0;
}
