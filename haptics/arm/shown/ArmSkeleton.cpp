// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/shown/ArmSkeleton.h"

#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

using Lines = std::vector<std::vector<Vec3>>;

/// The polylines of each kind.
struct Skeleton
{
  const Arm& arm;
  const JointVector& q;
  Vec3 tip_D; ///< before the wrist

  [[nodiscard]] Vec3 at(int link, double along_m) const
  {
    return this->arm.linkPoint(this->q, link, Vec3(along_m, 0.0, 0.0)).p;
  }
  /// From a point through the origins of links in a chain.
  [[nodiscard]] std::vector<Vec3> through(const Vec3& from, int first, int count, const Vec3& to) const
  {
    std::vector<Vec3> line{ from };
    for (int link = first; link < first + count; ++link)
    {
      line.push_back(this->at(link, 0.0));
    }
    line.push_back(to);
    return line;
  }
  [[nodiscard]] Vec3 base(const Vec3& p) const { return this->arm.plan().base_D * p; }

  Lines operator()(const SerialGeometry& chain) const
  {
    return { this->through(this->base(Vec3::Zero()), 1, chain.count, this->tip_D) };
  }
  Lines operator()(const WoodenGeometry& wooden) const
  {
    return { { this->base(Vec3::Zero()), this->at(1, 0.0), this->at(1, wooden.upper_m), this->tip_D } };
  }
  Lines operator()(const DeltaGeometry& delta) const
  {
    Lines lines;
    for (int leg = 1; leg <= 3; ++leg)
    {
      lines.push_back({ this->base(Vec3::Zero()), this->at(leg, 0.0), this->at(leg, delta.arm_m),
        this->at(3 + leg, delta.forearm_m + delta.hinge_m), this->tip_D });
    }
    return lines;
  }
  Lines operator()(const FiveBarGeometry& bars) const
  {
    return { { this->at(1, 0.0), this->at(1, bars.arm_m), this->tip_D, this->at(2, bars.arm_m), this->at(2, 0.0) } };
  }
};

} // namespace

std::vector<std::vector<Vec3>> skeletonOf(const Arm& arm, const JointVector& q)
{
  const std::optional<Pose> tip = arm.forward(q);
  if (!tip)
  {
    return {};
  }
  const ArmPlan& plan = arm.plan();
  const Skeleton skeleton{ arm, q, arm.carrier(q).tip.p };
  Lines lines = std::visit(skeleton, plan.geometry);
  if (plan.wrist.count > 0)
  {
    lines.push_back(skeleton.through(skeleton.tip_D, linkCountOf(plan.geometry) + 1, plan.wrist.count, tip->p));
  }
  return lines;
}

} // namespace palpate
