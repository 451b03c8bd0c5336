// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Stage.h"

#include <utility>

#include "haptics/contact/view/SceneView.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{

void Stage::add(const TriangleMesh& mesh, Path path)
{
  this->add(sceneOf(mesh)->surfaces()[0], std::move(path));
}

void Stage::add(const Surface& surface, Path path)
{
  this->surfaces_.push_back(surface);
  this->paths_.push_back(std::move(path));
}

std::shared_ptr<const Scene> Stage::between(double from_s, double to_s)
{
  for (std::size_t i = 0; i < this->surfaces_.size(); ++i)
  {
    this->surfaces_[i].motion = { this->paths_[i](from_s), this->paths_[i](to_s) };
  }
  return std::make_shared<Scene>(++this->revision_, this->surfaces_, to_s - from_s);
}

Actor::Actor(Stage& stage, const ContactPlan& plan, const Vec3& start_W)
  : stage_(stage), plan_(plan), scene_(stage.between(0.0, snapshot_s()))
{
  static_cast<void>(moveGodObject(MovingScene(*this->scene_, 0.0), plan, start_W, this->state));
}

ContactResult Actor::tick(const Vec3& p_W)
{
  const std::shared_ptr<const Scene> old = this->scene_;
  const double shareBefore = this->share();
  if (this->inSnapshot_ == ticksPerSnapshot)
  {
    this->begin_s_ += snapshot_s();
    this->scene_ = this->stage_.between(this->begin_s_, this->begin_s_ + snapshot_s());
    this->inSnapshot_ = 0;
  }
  ++this->inSnapshot_;
  const MovingScene now(*this->scene_, this->share());
  if (this->carries)
  {
    this->carry = carryBall(MovingScene(*old, shareBefore), now, this->plan_, this->state);
  }
  return moveGodObject(now, this->plan_, p_W, this->state);
}

Vec3 Actor::inSurface(std::size_t surface) const
{
  const Pose pose_WS = this->pose(surface);
  return pose_WS.q.conjugate() * (this->state.x_W - pose_WS.p);
}

} // namespace palpate::test
