// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSight.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/core/PoseMath.h"
#include "vtkCamera.h"
#include "vtkHapticContactForce.h"
#include "vtkHapticFieldShape.h"
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticServerSurfaces.h"
#include "vtkHapticSessionInternals.h"
#include "vtkHapticTool.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"

namespace
{
using palpate::Vec3;

/// Work that a person waits for once, beyond the limits of a tick.
constexpr std::uint32_t nodesToVisit = 1u << 24;

/// The plane that holds the ball where it was stopped; against its direction where a point met an edge or a corner.
template<class SceneView>
Vec3 NormalAt(const SceneView& scene, const palpate::SweepHit& hit, const palpate::SweepQuery& query, const Vec3& x_W)
{
  if (hit.feature.kind != palpate::FeatureKind::Face && query.radius_u == 0.0)
  {
    return (query.from_W - query.to_W).normalized();
  }
  const auto& surface = palpate::surfaceOf(scene, hit.feature.surface);
  return palpate::planeOf(surface, hit.feature, x_W, query.radius_u).n;
}

Vec3 RowOf(vtkMatrix4x4* matrix, int row)
{
  return { matrix->GetElement(row, 0), matrix->GetElement(row, 1), matrix->GetElement(row, 2) };
}

template<class SceneView>
bool Meets(const SceneView& scene, const palpate::SweepQuery& query, Vec3& x_W, Vec3& n_W)
{
  const palpate::SweepHit hit = palpate::sweepBall(scene, query, nodesToVisit);
  if (hit.hit)
  {
    x_W = query.from_W + hit.t * (query.to_W - query.from_W);
    n_W = NormalAt(scene, hit, query, x_W);
  }
  return hit.hit;
}
/// Whether the servo has the held tool or mechanism, turned as the hand: else it will begin as its data has it.
template<class Behind>
bool IsInHand(const Behind& impl)
{
  return impl.Core.running() && (impl.State.tool.held || impl.State.mechanism.held);
}

template<class Behind>
std::optional<vtkHapticHeldAxis> HeldBy(const Behind& impl)
{
  const auto ofMechanism = impl.Mechanism.Axis();
  return ofMechanism ? ofMechanism : impl.Tool.Axis();
}

/// The turn of the held tool or mechanism where a program holds the hand: it follows the turns of the hand from a
/// beginning of its own.
template<class Behind>
palpate::Quat HeldTurn(const Behind& impl, const vtkHapticHeldAxis& held)
{
  const auto& now_W = impl.State.mechanism.held ? impl.State.mechanism.hand_W.q : impl.State.tool.hand_W.q;
  return IsInHand(impl) ? palpate::Quat(impl.HandTurn_W * impl.State.device_W.q.conjugate() * now_W) : held.Begin_WB;
}
} // namespace

vtkSmartPointer<vtkHapticSight> vtkHapticSight::Of(vtkHapticSession& session)
{
  return vtkSmartPointer<vtkHapticSight>::Take(new vtkHapticSight(session));
}

vtkMTimeType vtkHapticSight::GetMaterialTime() const
{
  return this->Behind().MaterialTime.GetMTime();
}

bool vtkHapticSight::GetUsesMaterialArrays() const
{
  return !this->Behind().Materials.Empty();
}

bool vtkHapticSight::PickSurface(
  const double from_W[3], const double to_W[3], double ball_W[3], double normal_W[3]) const
{
  auto& impl = this->Behind();
  if (!impl.Scene.built().scene || impl.Scene.built().scene->empty())
  {
    return false;
  }
  const palpate::Scene& scene = *impl.Scene.built().scene;
  palpate::SweepQuery query;
  query.from_W = Vec3(from_W);
  query.to_W = Vec3(to_W);
  query.radius_u = impl.Asked.touch(impl.Scene.built()).plan.radius_u;
  query.resolution.include(query.from_W);
  query.resolution.include(query.to_W);
  query.resolution.include(Vec3::Constant(query.radius_u + scene.mostCoat_u()));
  const double share = impl.State.sceneRevision == scene.revision() ? impl.State.sceneShare : 0.0;
  Vec3 x_W;
  Vec3 n_W;
  if (!(scene.moves() ? Meets(palpate::MovingScene(scene, share), query, x_W, n_W) : Meets(scene, query, x_W, n_W)))
  {
    return false;
  }
  Eigen::Map<Vec3>{ ball_W } = x_W;
  Eigen::Map<Vec3>{ normal_W } = n_W;
  return true;
}

void vtkHapticSight::SetEye(const double p_W[3])
{
  this->Behind().Eye_W = Vec3(p_W);
}

bool vtkHapticSight::PrepareSurface(const char* name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  return this->Behind().Surfaces.Prepare(name ? name : "surface", data, matrix);
}

void vtkHapticSight::ForgetPrepared()
{
  this->Behind().Surfaces.ForgetPrepared();
}

int vtkHapticSight::GetScenesCancelled() const
{
  return this->Behind().ScenesCancelled;
}

bool vtkHapticSight::AddRemoteField(const char* name, const vtkHapticFieldResult& made)
{
  return this->Behind().FeelField(name, made);
}

void vtkHapticSight::SetComparedField(vtkDataObject* compared, vtkDataObject* snap)
{
  auto& impl = this->Behind();
  const vtkMTimeType time = std::max(compared ? compared->GetMTime() : 0, snap ? snap->GetMTime() : 0);
  if (impl.CompareData != compared || impl.SnapData != snap || impl.BesideTime != time)
  {
    impl.BesideTime = time;
    impl.CompareData = compared;
    impl.SnapData = snap;
    this->Behind().FeelFieldAnew();
  }
}

void vtkHapticSight::GetFieldShape(vtkPolyData* shape) const
{
  const std::shared_ptr<const palpate::FieldBlock>& brick = this->Behind().Core.brick();
  shape->Initialize();
  const palpate::Vec3& proxy_W = this->Behind().State.field.proxy_W;
  if (brick && proxy_W.allFinite())
  {
    vtkHapticFieldShape(
      brick->finestAt(proxy_W), this->Behind().Asked.asked().field, palpate::Vec3(this->Behind().Hand), proxy_W, shape);
  }
}

vtkHapticServerSurfaces& vtkHapticSight::ServerSurfaces() const
{
  this->Behind().Server.SetHand(this->Behind().Hand_W);
  return this->Behind().Server;
}

void vtkHapticSight::GetToolShape(vtkPolyData* shape) const
{
  vtkPolyData* const ofMechanism = this->Behind().Mechanism.HeldShape();
  ofMechanism ? shape->ShallowCopy(ofMechanism) : this->Behind().Tool.GetShape(shape);
}

bool vtkHapticSight::GetLooseWay(const char* name, vtkMatrix4x4* way) const
{
  const std::optional<palpate::Pose> gone = this->Behind().LooseWay(name ? name : "");
  if (gone)
  {
    const Eigen::Isometry3d to_W = Eigen::Translation3d(gone->p) * gone->q;
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = to_W.matrix();
    way->DeepCopy(rows.data());
  }
  return gone.has_value();
}

bool vtkHapticSight::GetHasLoose() const
{
  return !this->Behind().Surfaces.Styles().Densities().empty();
}

void vtkHapticSight::SetUnitOfFiles(const char* unit)
{
  const std::string known = unit ? unit : "";
  if (known != this->Behind().UnitOfFiles)
  {
    this->Behind().UnitOfFiles = known;
    this->Behind().FollowLoose();
  }
}

void vtkHapticSight::LookForLoose(const std::function<bool(const std::string& name)>& isThere)
{
  std::set<std::string>& gone = this->Behind().LooseGone;
  gone.clear();
  for (const auto& [name, density] : this->Behind().Surfaces.Styles().Densities())
  {
    if (!isThere(name))
    {
      gone.insert(name);
    }
  }
}

void vtkHapticSight::GetContactForces(vtkPolyData* points) const
{
  vtkHapticPutForces(this->Behind().ContactForces(this->Behind().State), *points);
}

double vtkHapticSight::GetToolReach(const double direction_W[3]) const
{
  const vtkHapticTool& tool = this->Behind().Tool;
  const std::optional<vtkHapticHeldAxis> held = tool.Axis();
  if (!held)
  {
    return 0.0;
  }
  const Vec3 direction_B = HeldTurn(this->Behind(), *held).conjugate() * Vec3(direction_W);
  double reach_u = -std::numeric_limits<double>::infinity();
  for (const Vec3& v : tool.Choice().tool->shape_B->mesh().vertices_W)
  {
    reach_u = std::max(reach_u, direction_B.dot(held->Tip_B - v));
  }
  return reach_u;
}

bool vtkHapticSight::GetHoldsMechanism() const
{
  return this->Behind().Mechanism.Axis().has_value();
}

double vtkHapticSight::GetLargestDepth() const
{
  return this->Behind().Core.parameters().safety.maxForce_N / this->Behind().FeltStiffness();
}

bool vtkHapticSight::GetFeelsField() const
{
  return this->Behind().FeltField.hasSource();
}

bool vtkHapticSight::GetFieldIsReady(const double p_W[3]) const
{
  const auto& impl = this->Behind();
  const auto& brick = impl.Core.brick();
  const bool inside = vtkBoundingBox(impl.FieldBounds.data()).ContainsPoint(p_W[0], p_W[1], p_W[2]) != 0;
  return brick && (!inside || brick->grid().roomAt_u(Vec3(p_W)) > 0.0);
}

bool vtkHapticSight::GetHeldAxis(double tip_W[3], double axis_W[3]) const
{
  const auto& impl = this->Behind();
  const std::optional<vtkHapticHeldAxis> held = HeldBy(impl);
  if (held)
  {
    const palpate::Quat turn_W = HeldTurn(impl, *held);
    Eigen::Map<Vec3>{ tip_W } = turn_W * held->Tip_B;
    Eigen::Map<Vec3>{ axis_W } = turn_W * held->Along_B;
  }
  return held.has_value();
}

void vtkHapticSight::TurnHeldAxis(const double direction_W[3])
{
  Vec3 tip_W;
  Vec3 axis_W;
  auto& impl = this->Behind();
  if (IsInHand(impl) && this->GetHeldAxis(tip_W.data(), axis_W.data()))
  {
    impl.HandTurn_W = (palpate::shortestTurn(axis_W, Vec3(direction_W)) * impl.HandTurn_W).normalized();
    impl.Feed();
  }
}

bool vtkHapticSight::GetMetBounds(double bounds[6]) const
{
  const auto& impl = this->Behind();
  vtkBoundingBox met = impl.Mechanism.MetBounds();
  if (impl.IsFittable())
  {
    met.AddBounds(impl.Fittable().bounds.data());
  }
  met.GetBounds(bounds);
  return met.IsValid();
}

void vtkHapticSight::FollowCamera(vtkCamera* camera)
{
  vtkMatrix4x4* const view = camera ? camera->GetViewTransformMatrix() : nullptr;
  this->Behind().View_WD = view ? palpate::viewRotation(RowOf(view, 0), RowOf(view, 1)) : std::nullopt;
}

bool vtkHapticSight::GetDeviceHand(double hand_D[3], double turn_D[4], vtkMatrix4x4* toScene) const
{
  auto& impl = this->Behind();
  const palpate::HapticState& state = impl.State;
  if (!impl.Core.running() || state.tick == 0 || state.held)
  {
    return false;
  }
  const palpate::HandPlace hand{ state.handle_D, state.device_W.p };
  const palpate::WorkspaceMap map = palpate::keepingHand(impl.Asked.asked().map, hand);
  const palpate::Quat turn = map.q_WD.conjugate() * state.device_W.q;
  const palpate::Mat3 axes = map.scale_u_per_m * map.q_WD.toRotationMatrix();
  std::copy(state.handle_D.begin(), state.handle_D.end(), hand_D);
  for (int row = 0; row < 3; ++row)
  {
    turn_D[1 + row] = turn.vec()[row];
    for (int column = 0; column < 3; ++column)
    {
      toScene->SetElement(row, column, axes(row, column));
    }
    toScene->SetElement(row, 3, map.offset_W[row]);
  }
  turn_D[0] = turn.w();
  return true;
}

void vtkHapticSight::GetWorkspaceCorners(double corners_W[24]) const
{
  auto& impl = this->Behind();
  for (const Vec3& corner_W : palpate::workspaceCorners(impl.Asked.asked().map, impl.InfoNow().workspaceRadius_m.value))
  {
    corners_W = std::copy(corner_W.begin(), corner_W.end(), corners_W);
  }
}
