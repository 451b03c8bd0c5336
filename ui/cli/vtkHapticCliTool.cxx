// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "haptics/session/path/ToolTouch.h"
#include "vtkHapticCliOutput.h"
#include "vtkHapticCliPath.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"
#include "vtkHapticCliTicks.h"

namespace
{
palpate::ToolHold HoldOf(const vtkHapticCliTouchOptions& options)
{
  palpate::ToolHold hold;
  hold.stiffness_N_per_m = options.Settings.Number("Stiffness");
  hold.scale_u_per_m = options.Settings.Number("Scale");
  hold.lever_u = options.Tool.Lever_u;
  hold.friction = options.Settings.Friction().kinetic;
  if (options.Turning_N_m_per_rad)
  {
    // K_r = K_t (L / scale)^2.
    hold.lever_u = hold.scale_u_per_m * std::sqrt(*options.Turning_N_m_per_rad / hold.stiffness_N_per_m);
  }
  hold.coupling = options.Tool.VirtualCoupling ? palpate::ToolCoupling::Virtual : palpate::ToolCoupling::Constraints;
  return hold;
}

/// A tool feels surfaces as they are: what else was asked for would be lost.
void CheckToolAlone(const vtkHapticCliTouchOptions& options)
{
  const std::string setting =
    options.Settings.GivenBeside({ "Stiffness", "Scale", "FrictionStatic", "FrictionKinetic" });
  const std::string field = vtkHapticCliGivenOfField(options.Field);
  const std::string asked = !setting.empty()             ? setting
                            : !field.empty()             ? field
                            : options.Field.Any()        ? "--field"
                            : options.TwoD               ? "--two-d"
                            : options.Soft.Young_Pa      ? "--young"
                            : !options.Materials.Empty() ? "an array of the material"
                                                         : "";
  if (!asked.empty())
  {
    throw vtkHapticCliProblem(asked + ": a tool does not feel it; leave out this or --tool");
  }
}

/// The triangles of all files in one.
palpate::TriangleMesh ReadTogether(const std::vector<std::string>& files, std::optional<double> iso)
{
  palpate::TriangleMesh together;
  for (const std::string& file : files)
  {
    palpate::append(together, *vtkHapticCliReadSurface(file, iso).Input.mesh);
  }
  return together;
}

/// One row of what it did.
void WriteTool(
  vtkHapticCliOutput& output, const vtkHapticCliPathRow& row, const palpate::ToolTouched& touched, double cost_us)
{
  palpate::HapticState state;
  state.device_W = row.Pose_W;
  state.proxy_W = touched.pose_W;
  state.force_W = touched.wrench_W.force;
  state.contacts = touched.contacts;
  const palpate::Quat& q = touched.pose_W.q;
  const palpate::Vec3& torque = touched.wrench_W.torque;
  vtkHapticCliWriteTick(
    output, row.Time_s, state, cost_us, { q.w(), q.x(), q.y(), q.z(), torque.x(), torque.y(), torque.z() });
}

/// What a person is to know who reads the rows.
struct ToolShortfalls
{
  int Unsettled = 0;
  int LeadCut = 0;

  void Count(const palpate::ToolTouched& touched)
  {
    this->Unsettled += touched.settled ? 0 : 1;
    this->LeadCut += touched.leadCut ? 1 : 0;
  }

  void Tell() const
  {
    if (this->Unsettled > 0)
    {
      std::cerr << "palpate: in " << this->Unsettled << " rows the tool had not come to rest\n";
    }
    if (this->LeadCut > 0)
    {
      std::cerr << "palpate: in " << this->LeadCut << " rows the hand was turned so far ahead of the tool that it was "
                << "led by a part of that only\n";
    }
  }
};
} // namespace

int vtkHapticCliTouchWithTool(const vtkHapticCliTouchOptions& options)
{
  CheckToolAlone(options);
  const std::vector<vtkHapticCliPathRow> path = vtkHapticCliReadPath(options.Path, true);
  const palpate::TriangleMesh mesh = ReadTogether({ options.Tool.File }, {});
  std::vector<std::string> files = options.Files;
  files.insert(files.end(), options.Field.Surfaces.begin(), options.Field.Surfaces.end());
  const palpate::TriangleMesh scene = ReadTogether(files, options.Iso);
  std::string refusal;
  const auto touch = palpate::ToolTouch::make(mesh, scene, HoldOf(options), path.front().Pose_W, refusal);
  if (!touch)
  {
    throw vtkHapticCliProblem("--tool: " + options.Tool.File + ": " + refusal);
  }
  if (!touch->noWayOut().empty())
  {
    std::cerr << "palpate: the tool " << touch->noWayOut() << '\n';
  }
  std::vector<std::string> inputs = files;
  inputs.insert(inputs.end(), { options.Path, options.Tool.File });
  vtkHapticCliOutput output(options.Output, inputs);
  vtkHapticCliWriteHeader(output, ",proxy_qw,proxy_qx,proxy_qy,proxy_qz,torque_x,torque_y,torque_z");
  vtkHapticCliStopwatch stopwatch;
  ToolShortfalls shortfalls;
  for (const vtkHapticCliPathRow& row : path)
  {
    stopwatch.Start();
    const palpate::ToolTouched touched = touch->next(row.Pose_W);
    WriteTool(output, row, touched, stopwatch.Cost_us());
    shortfalls.Count(touched);
  }
  shortfalls.Tell();
  output.Commit();
  return 0;
}
