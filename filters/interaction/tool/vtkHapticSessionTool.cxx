// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh in the hand in place of the ball.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "haptics/geometry/measure/ContactPlace.h"
#include "vtkHapticContactForce.h"
#include "vtkHapticSessionInternals.h"
#include "vtkHapticTool.h"

bool vtkHapticSession::AddTool(const char* name, vtkDataObject* data)
{
  return this->Impl->AddFelt(this->Impl->Tool, name, data);
}

std::string vtkHapticSession::Internals::FollowToolHandle()
{
  const auto handle = static_cast<vtkHapticToolHandle>(this->Settings.whole("ToolHandle"));
  const palpate::Vec3 point_T(this->Settings.of("ToolHandlePoint").numbers.data());
  const bool moved = handle == vtkHapticToolHandle::Handle && point_T != this->Tool.HandlePoint_T;
  const bool anew = handle != this->Tool.Handle || moved;
  this->Tool.Handle = handle;
  this->Tool.HandlePoint_T = point_T;
  this->Tool.TipPoint_T = palpate::Vec3(this->Settings.of("ToolTipPoint").numbers.data());
  this->Tool.Lever_u = this->Settings.number("ToolLever");
  this->Feel(this->Tool, anew ? this->Tool.TakeAgain() : this->Tool.TakeLever());
  return {};
}

void vtkHapticSession::SetHandTurn(double w, double x, double y, double z)
{
  const palpate::Quat turn(w, x, y, z);
  const double length = turn.norm();
  const bool usable = length > 0.0 && turn.coeffs().allFinite();
  const std::string problem =
    usable ? "" : "the rotation of the hand must be a quaternion (w, x, y, z) of length above 0";
  this->Impl->Refuse(problem);
  this->Impl->Follow("hand's rotation", problem);
  this->Impl->HandTurn_W = usable ? turn.normalized() : this->Impl->HandTurn_W;
  this->Impl->Feed();
}

std::vector<vtkHapticContactForce> vtkHapticSession::Internals::ContactForces(const palpate::HapticState& touched) const
{
  const auto mechanism = this->Core.feltMechanism();
  if (touched.mechanism.held && mechanism)
  {
    return vtkHapticFoundForces(touched.mechanism, *mechanism);
  }
  const auto& scene = this->Scene.built().scene;
  return scene ? vtkHapticToolForces(touched, *scene, this->Core.parameters().map.scale_u_per_m)
               : std::vector<vtkHapticContactForce>();
}

std::optional<palpate::ContactPlace> vtkHapticSession::Internals::PlaceOfContact(
  const palpate::HapticState& touched) const
{
  const palpate::Scene& scene = *this->Scene.built().scene;
  if (!touched.tool.held && !touched.mechanism.held)
  {
    return palpate::placeOf(scene, touched.proxy_W.p, touched.device_W.p);
  }
  const std::vector<vtkHapticContactForce> forces = this->ContactForces(touched);
  const auto most = std::max_element(forces.begin(), forces.end(),
    [](const auto& one, const auto& other) { return one.Force_N.norm() < other.Force_N.norm(); });
  return most == forces.end() ? std::nullopt
                              : palpate::placeOf(scene, most->At_W, most->At_W - most->Force_N.normalized());
}

const char* vtkHapticSession::Internals::SayToolContacts()
{
  const std::vector<vtkHapticContactForce> forces = this->ContactForces(this->State);
  double all_N = 0.0;
  for (const vtkHapticContactForce& force : forces)
  {
    all_N += force.Force_N.norm();
  }
  std::ostringstream lines;
  lines.precision(4);
  for (const vtkHapticContactForce& force : all_N > 0.0 ? forces : std::vector<vtkHapticContactForce>())
  {
    const palpate::Vec3& p_W = force.At_W;
    lines << force.Touched << " at (" << p_W.x() << ", " << p_W.y() << ", " << p_W.z() << ") u, "
          << std::lround(100.0 * force.Force_N.norm() / all_N) << " %\n";
  }
  this->Tool.Contacts = lines.str();
  return this->Tool.Contacts.c_str();
}
