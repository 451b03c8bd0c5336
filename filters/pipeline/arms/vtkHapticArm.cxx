// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticArm.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "haptics/arm/file/ArmFile.h"
#include "haptics/arm/shown/ArmSkeleton.h"
#include "haptics/arm/shown/ArmWorkSpaceMap.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticArm);

/// A hand as it was shown: position from the middle of the work space, turn, map into the scene by rows.
struct vtkHapticShownHand
{
  std::array<double, 3> Position{};
  std::array<double, 4> Turn{};
  std::array<double, 16> ToScene{};
  bool operator==(const vtkHapticShownHand&) const = default;
};

namespace
{
using palpate::JointVector;
using palpate::Vec3;

/// From the arm's frame to the output.
struct Placement
{
  palpate::Mat3 Axes = palpate::Mat3::Identity();
  Vec3 Origin = Vec3::Zero();

  Vec3 operator*(const Vec3& p_D) const { return this->Origin + this->Axes * p_D; }
};

Vec3 PositionOf(const vtkHapticShownHand& hand, const palpate::Arm& arm)
{
  return arm.plan().workSpace.centre_D + Vec3(hand.Position.data());
}

/// The hand's position is from the middle of the work space.
Placement PlacementOf(const vtkHapticShownHand& hand, const palpate::Arm& arm)
{
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> toScene(hand.ToScene.data());
  Placement placement;
  placement.Axes = toScene.topLeftCorner<3, 3>();
  placement.Origin = toScene.topRightCorner<3, 1>() - placement.Axes * arm.plan().workSpace.centre_D;
  return placement;
}

/// Joints for a hand, turned as the hand where the arm can be; nothing out of reach.
std::optional<JointVector> JointsAt(
  const vtkHapticShownHand& hand, const palpate::Arm& arm, const std::optional<JointVector>& before)
{
  const Vec3 p_D = PositionOf(hand, arm);
  const std::optional<JointVector> placed = before ? arm.inverse(p_D, *before) : arm.inverse(p_D);
  if (!placed || arm.joints() < palpate::mostJoints)
  {
    return placed;
  }
  const auto& [w, x, y, z] = hand.Turn;
  const std::optional<JointVector> turned = arm.inverse(palpate::Pose{ p_D, palpate::Quat(w, x, y, z) }, *placed);
  return turned ? turned : placed;
}

void DrawLinks(const palpate::Arm& arm, const JointVector& q, const Placement& placement, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const std::vector<Vec3>& line : palpate::skeletonOf(arm, q))
  {
    lines->InsertNextCell(static_cast<int>(line.size()));
    for (const Vec3& p : line)
    {
      lines->InsertCellPoint(points->InsertNextPoint(Vec3(placement * p).data()));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
}

vtkDoubleArray* Add(vtkPolyData* output, const char* name)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  output->GetPointData()->AddArray(array);
  return array; // the output keeps it
}

void DrawWorkSpace(const palpate::Arm& arm, const std::vector<palpate::ArmPlace>& places, const Placement& placement,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkDoubleArray* const condition = Add(output, "Condition");
  vtkDoubleArray* const force = Add(output, "LargestForce");
  vtkDoubleArray* const mass = Add(output, "ApparentMass");
  for (const palpate::ArmPlace& place : places)
  {
    if (!place.reached || !(place.measures.condition < arm.plan().maxCondition))
    {
      continue;
    }
    const vtkIdType id = points->InsertNextPoint(Vec3(placement * place.p_D).data());
    vertices->InsertNextCell(1, &id);
    condition->InsertNextValue(place.measures.condition);
    force->InsertNextValue(place.measures.leastForce_N);
    mass->InsertNextValue(place.measures.mostMass_kg);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->SetActiveScalars("Condition");
}
} // namespace

class vtkHapticArm::Internals
{
public:
  /// An arm as it was read, and its work space.
  std::string Name;
  int Steps = 0;
  std::optional<palpate::Arm> Arm;
  std::vector<palpate::ArmPlace> Places;

  std::optional<vtkHapticShownHand> Hand; ///< none: the typed one
  std::optional<JointVector> Joints;      ///< of the last hand that was in reach
  bool Warned = false;                    ///< that one was not
};

vtkHapticArm::vtkHapticArm() : Impl(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkHapticArm::~vtkHapticArm() = default;

void vtkHapticArm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arm: " << this->Arm << '\n';
  os << indent << "FollowHand: " << this->FollowHand << '\n';
}

bool vtkHapticArm::ShowHand(const double hand_D[3], const double turn_D[4], vtkMatrix4x4* toScene)
{
  vtkHapticShownHand hand;
  std::copy(hand_D, hand_D + 3, hand.Position.begin());
  std::copy(turn_D, turn_D + 4, hand.Turn.begin());
  std::copy(toScene->GetData(), toScene->GetData() + 16, hand.ToScene.begin());
  if (this->Impl->Hand == hand)
  {
    return false;
  }
  this->Impl->Hand = hand;
  this->Modified();
  return true;
}

bool vtkHapticArm::ShowTyped()
{
  const bool shown = this->Impl->Hand.has_value();
  this->Impl->Hand.reset();
  this->Impl->Joints.reset();
  this->Impl->Warned = false;
  if (shown)
  {
    this->Modified();
  }
  return shown;
}

/// The file is read anew but for another hand.
bool vtkHapticArm::Read()
{
  Internals& impl = *this->Impl;
  if (impl.Hand && impl.Arm && impl.Name == this->Arm && impl.Steps == this->Steps)
  {
    return true;
  }
  impl.Arm.reset();
  impl.Joints.reset();
  const palpate::Outcome<palpate::ArmPlan> plan = palpate::armNamed(this->Arm);
  if (!plan.ok())
  {
    vtkErrorMacro(<< plan.problem);
    return false;
  }
  impl.Name = this->Arm;
  impl.Steps = this->Steps;
  impl.Arm.emplace(plan.value);
  impl.Places = palpate::mapWorkSpace(*impl.Arm, this->Steps);
  return true;
}

void vtkHapticArm::WarnOfReach(bool follows)
{
  if (!follows || !std::exchange(this->Impl->Warned, true))
  {
    vtkWarningMacro(<< this->Arm << ": the hand is out of the arm's reach, so that "
                    << (follows ? "the links are drawn as they were last in reach" : "no links are drawn"));
  }
}

int vtkHapticArm::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (!this->Read())
  {
    return 0;
  }
  Internals& impl = *this->Impl;
  const palpate::Arm& arm = *impl.Arm;
  const vtkHapticShownHand* const hand = this->FollowHand && impl.Hand ? &*impl.Hand : nullptr;
  const Vec3 typed_D = arm.plan().workSpace.centre_D + Vec3(this->Hand);
  std::optional<JointVector> joints = hand ? JointsAt(*hand, arm, impl.Joints) : arm.inverse(typed_D);
  if (!joints)
  {
    this->WarnOfReach(hand != nullptr);
  }
  if (hand)
  {
    // Before any hand in reach that is the typed one.
    impl.Joints = joints ? joints : impl.Joints ? impl.Joints : arm.inverse(typed_D);
    joints = impl.Joints;
  }
  const Placement placement =
    hand ? PlacementOf(*hand, arm) : Placement{ this->Scale * palpate::Mat3::Identity(), Vec3::Zero() };
  if (joints)
  {
    DrawLinks(arm, *joints, placement, vtkPolyData::GetData(output, 0));
  }
  DrawWorkSpace(arm, impl.Places, placement, vtkPolyData::GetData(output, 1));
  return 1;
}
