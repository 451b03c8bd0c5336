// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Bender.h"

#include <stdexcept>
#include <utility>

#include "haptics/geometry/scene/SceneMotion.h"

namespace palpate::test
{

Bender::Bender(TriangleMesh mesh, Path path, int ticksPerSnapshot, Between between)
  : mesh_(std::move(mesh)), path_(std::move(path)), ticksPerSnapshot_(ticksPerSnapshot), between_(between)
{
  this->parameters.safety = SafetyLimits::none();
  this->parameters.damping_Ns_per_m = 0.0;
  this->parameters.passivity.enabled = false;
  this->compute = [this](const TickInput& input) { return renderTick(input, this->parameters, this->state); };
}

void Bender::addStanding(const TriangleMesh& mesh)
{
  SurfaceInput input;
  input.name = "standing " + std::to_string(this->standing_.size());
  input.mesh = std::make_shared<const TriangleMesh>(mesh);
  this->standing_.push_back(std::move(input));
}

std::shared_ptr<const Scene> Bender::snapshot(double time_s, const Scene* felt)
{
  auto mesh = std::make_shared<TriangleMesh>(this->mesh_);
  for (Vec3& v : mesh->vertices_W)
  {
    v = this->path_(v, time_s);
  }
  std::vector<SurfaceInput> inputs(1);
  inputs[0].name = "bending";
  inputs[0].mesh = std::move(mesh);
  inputs[0].lineRadius_u = this->lineRadius_u;
  inputs[0].pose_WS = this->poseAt(time_s);
  inputs[0].frame = this->frame;
  inputs.insert(inputs.end(), this->standing_.begin(), this->standing_.end());
  SceneBuildResult built = this->builder_.build(inputs, felt);
  for (const SurfaceReport& report : built.reports)
  {
    if (!report.refusal.empty() || (felt != nullptr && &report == &built.reports[0] && !report.refitted))
    {
      throw std::runtime_error("the surface was not refitted: " + report.refusal);
    }
  }
  return built.scene;
}

void Bender::nextSnapshot()
{
  const bool moves = this->between_ == Between::Moves;
  if (!this->scene_)
  {
    this->scene_ = this->snapshot(0.0, nullptr);
  }
  else
  {
    this->begin_s_ += this->snapshot_s();
  }
  const double share = this->scene_->shareAt(this->state.sceneAge_s);
  // A step shows the snapshot of now at once; a motion has to know where it leads.
  std::shared_ptr<const Scene> next =
    this->snapshot(this->begin_s_ + (moves ? this->snapshot_s() : 0.0), moves ? this->scene_.get() : nullptr);
  next = moves ? movingFrom(*this->scene_, share, next, this->snapshot_s()) : next;
  this->previous_ = std::exchange(this->scene_, std::move(next));
  this->inSnapshot_ = 0;
  if (this->onScene)
  {
    this->onScene(this->scene_);
  }
}

TickOutput Bender::tick(const Vec3& p_W)
{
  if (!this->scene_ || this->inSnapshot_ == this->ticksPerSnapshot_)
  {
    this->nextSnapshot();
  }
  ++this->inSnapshot_;
  TickInput input;
  input.tick = ++this->tick_;
  input.dt_s = 1e-3;
  input.sample.pose_D.p = p_W;
  input.sample.time_s = 1e-3 * static_cast<double>(this->tick_);
  input.scene = this->scene_.get();
  input.previousScene = this->tick_ > 1 ? this->previous_.get() : nullptr;
  const TickOutput output = this->compute(input);
  this->previous_.reset();
  return output;
}

Vec3 Bender::between(const Vec3& inMesh_S) const
{
  const double s = this->share();
  return (1.0 - s) * this->path_(inMesh_S, this->begin_s_) +
         s * this->path_(inMesh_S, this->begin_s_ + this->snapshot_s());
}

Pose Bender::pose_WS() const
{
  const double s = this->share();
  const Pose begin = this->poseAt(this->begin_s_), end = this->poseAt(this->begin_s_ + this->snapshot_s());
  const double sign = begin.q.dot(end.q) < 0.0 ? -1.0 : 1.0;
  const Quat mean(Eigen::Vector4d((1.0 - s) * begin.q.coeffs() + s * sign * end.q.coeffs()));
  return { (1.0 - s) * begin.p + s * end.p, mean.normalized() };
}

TriangleMesh Bender::mesh() const
{
  const Pose pose_WS = this->pose_WS();
  TriangleMesh felt = this->mesh_S();
  for (Vec3& v : felt.vertices_W)
  {
    v = pose_WS.q * v + pose_WS.p;
  }
  return felt;
}

TriangleMesh Bender::mesh_S() const
{
  TriangleMesh felt = this->mesh_;
  for (Vec3& v : felt.vertices_W)
  {
    v = this->between(v);
  }
  return felt;
}

} // namespace palpate::test
