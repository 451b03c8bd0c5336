// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImplantRun.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>
#include <variant>

#include "CrossingJudge.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/tool/ToolChoice.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/support/Meshes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

constexpr double scale_u_per_m = 1000.0, tick_s = 1e-3, comes_s = 1.0, moves_s = 2.0, from_m = 0.04;

double wave(double rate_Hz, double time_s)
{
  return std::sin(2.0 * std::numbers::pi * rate_Hz * time_s);
}

/// In the device's frame, in which the implant fits at the origin.
Pose handAt_D(double time_s)
{
  Pose hand{ Vec3(0.0, -from_m * std::max(0.0, 1.0 - time_s / comes_s), 0.0), Quat::Identity() };
  const double moving_s = time_s - moves_s;
  if (moving_s > 0.0) // no two of these rates have a common period in a minute
  {
    hand.p = 1e-3 * Vec3(5.0 * wave(0.19, moving_s), 6.0 * wave(0.25, moving_s), 5.0 * wave(0.13, moving_s));
    hand.q = turnBy(Vec3(0.0, 0.1 * wave(0.11, moving_s), 0.05 * wave(0.07, moving_s)));
  }
  return hand;
}

Vec3 middleOf(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d bounds;
  for (const Vec3& v : mesh.vertices_W)
  {
    bounds.extend(v);
  }
  return bounds.center();
}

/// One play, and its recording.
class ImplantPlay
{
public:
  explicit ImplantPlay(const ImplantTask& task)
    : task_(task), tool_(std::make_shared<const ToolMesh>(makeTool(task.implant, middleOf(task.implant)).value)),
      path_(this->folder_.file("implant.palpate"))
  {
  }

  ImplantFigures play()
  {
    SimulatedDevice* device = this->begin();
    if (device != nullptr)
    {
      const auto ticks = static_cast<std::uint64_t>(std::lround(this->task_.seconds / tick_s));
      for (std::uint64_t i = 0; i < ticks; ++i)
      {
        device->lead(handAt_D(tick_s * static_cast<double>(i)));
        this->session_.step(1);
        this->see(this->session_.state());
      }
      this->note(this->session_.stop());
      this->judgeRecording();
    }
    return this->figures_;
  }

private:
  SimulatedDevice* begin()
  {
    HapticParameters parameters;
    parameters.stiffness_N_per_m = 1000.0;
    parameters.map.scale_u_per_m = scale_u_per_m;
    parameters.map.offset_W = this->tool_->centre_W;
    this->note(this->session_.setParameters(parameters));
    this->session_.setScene(sceneOf(this->task_.bone));
    this->session_.choose<ToolTask>({ this->tool_, 0.0 });
    SessionOptions options;
    options.virtualTime = true;
    options.recordFile = this->path_;
    auto made = std::make_unique<SimulatedDevice>(
      *deviceModel("simulated-6d"), *handModel("stylus"), HandPath{ { handAt_D(0.0).p } });
    SimulatedDevice* const device = made.get();
    this->note(this->session_.start(std::move(made), options));
    return this->figures_.problem.empty() ? device : nullptr;
  }

  void see(const HapticState& state)
  {
    ImplantFigures& seen = this->figures_;
    ++seen.ticks;
    seen.touching += state.contacts > 0 ? 1 : 0;
    seen.pressed_N = std::max(seen.pressed_N, state.force_D.norm());
    seen.step_N = std::max(seen.step_N, (state.force_D - this->before_N_).norm());
    seen.excess_J = std::max(seen.excess_J, state.energy.peakExcess_J);
    this->before_N_ = state.force_D;
    if (seen.ticks * tick_s <= moves_s)
    {
      seen.seatedOff_mm = (state.proxy_W.p - this->tool_->centre_W).norm();
    }
    if (state.fault != Fault::None && state.fault != Fault::NoHand && seen.ticks > 5)
    {
      this->note("it ends by a fault: " + std::to_string(static_cast<int>(state.fault)));
    }
  }

  void judgeRecording()
  {
    const auto read = readRecording(this->path_);
    if (const auto* problem = std::get_if<std::string>(&read))
    {
      this->note(*problem);
      return;
    }
    const BoxedMesh bone(cleanMesh(this->task_.bone).mesh, 0.0);
    const CrossingJudge judge(*this->tool_->shape_B, bone, 0);
    const auto look = [&](const TickOutput& output)
    {
      if (output.state.tool.placed && output.state.tick % static_cast<std::uint64_t>(this->task_.judgedEach) == 0)
      {
        const Pose& pose_W = output.state.proxy_W;
        this->figures_.crossings += judge.crossings(pose_W.p, pose_W.q.toRotationMatrix());
        ++this->figures_.judged;
      }
    };
    for (const unsigned workers : { 1U, 2U, 4U })
    {
      const std::function<void(const TickOutput&)> none;
      const ReplayResult again = replay(std::get<Recording>(read), {}, workers, workers == 1U ? look : none);
      this->note(again.problem + again.difference);
      this->note(again.ticks == this->figures_.ticks ? "" : "the replay has another number of ticks");
    }
  }

  /// The first problem is the one that is told.
  void note(const std::string& problem)
  {
    this->figures_.problem = this->figures_.problem.empty() ? problem : this->figures_.problem;
  }

  const ImplantTask& task_;
  std::shared_ptr<const ToolMesh> tool_;
  TemporaryFolder folder_;
  std::string path_;
  HapticSession session_;
  ImplantFigures figures_;
  Vec3 before_N_ = Vec3::Zero();
};

} // namespace

ImplantFigures playImplant(const ImplantTask& task)
{
  return ImplantPlay(task).play();
}

std::string describe(const ImplantFigures& figures)
{
  std::ostringstream text;
  text << figures.ticks << " ticks, " << figures.touching << " touching, at most " << figures.pressed_N
       << " N, largest step " << figures.step_N << " N, excess " << 1e3 * figures.excess_J << " mJ, seated "
       << figures.seatedOff_mm << " mm off; " << figures.crossings << " crossings in " << figures.judged << " poses; "
       << (figures.problem.empty() ? "replays bit for bit" : figures.problem);
  return text.str();
}

} // namespace palpate::test
