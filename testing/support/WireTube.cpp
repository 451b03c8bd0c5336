// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/WireTube.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate::test
{
namespace
{

/// Of the centre line there: its tangent's angle about z.
double angleAt(const Tube& tube, double s_mm)
{
  return tube.angle_rad > 0.0 ? std::clamp((s_mm - tube.first_mm) / tube.bend_mm, 0.0, tube.angle_rad) : 0.0;
}

} // namespace

Vec3 Tube::centre_mm(double s_mm) const
{
  const double angle = angleAt(*this, s_mm);
  const double beyond_mm = std::max(s_mm - this->first_mm - this->bend_mm * this->angle_rad, 0.0);
  const Vec3 arc(this->bend_mm * std::sin(angle), this->bend_mm * (1.0 - std::cos(angle)), 0.0);
  return std::min(s_mm, this->first_mm) * Vec3::UnitX() + arc + beyond_mm * Vec3(std::cos(angle), std::sin(angle), 0.0);
}

TriangleMesh Tube::mesh() const
{
  TriangleMesh mesh;
  const int rings = static_cast<int>(std::ceil((this->before_mm + this->length_mm()) / this->ring_mm)) + 1;
  for (int i = 0; i < rings; ++i)
  {
    const double s_mm = -this->before_mm + (this->before_mm + this->length_mm()) * i / (rings - 1);
    const double angle = angleAt(*this, s_mm);
    const Vec3 across(-std::sin(angle), std::cos(angle), 0.0);
    for (int k = 0; k < this->around; ++k)
    {
      const double turn = 2.0 * std::numbers::pi * k / this->around;
      mesh.vertices_W.emplace_back(
        this->centre_mm(s_mm) + this->radius_mm * (std::cos(turn) * across + std::sin(turn) * Vec3::UnitZ()));
    }
  }
  const auto at = [this](int ring, int k)
  { return static_cast<std::uint32_t>(ring * this->around + k % this->around); };
  for (int i = 0; i + 1 < rings; ++i)
  {
    for (int k = 0; k < this->around; ++k)
    {
      mesh.triangles.push_back({ at(i, k), at(i, k + 1), at(i + 1, k) });
      mesh.triangles.push_back({ at(i, k + 1), at(i + 1, k + 1), at(i + 1, k) });
    }
  }
  if (this->blind)
  {
    const auto middle = static_cast<std::uint32_t>(mesh.vertices_W.size());
    mesh.vertices_W.push_back(this->centre_mm(this->length_mm()));
    for (int k = 0; k < this->around; ++k)
    {
      mesh.triangles.push_back({ at(rings - 1, k), at(rings - 1, k + 1), middle });
    }
  }
  return mesh;
}

WireDescription nitinolWire(double length_mm, int beams, double friction)
{
  WireDescription wire;
  wire.shape.length_u = length_mm;
  wire.shape.beams = beams;
  wire.diameter_u = 0.5;
  wire.young_N_per_u2 = 60e3;
  wire.friction = friction;
  return wire;
}

PushedWire::PushedWire(const WireDescription& description, const TriangleMesh& vessel_mm)
  : planned(planWire(description, vessel_mm, 1))
{
  if (!this->planned.plan)
  {
    throw std::runtime_error(this->planned.check.faults.front());
  }
}

const WireResult& PushedWire::tick(double hand_mm, double turn_rad)
{
  WireInput input;
  input.plan = this->planned.plan.get();
  const Quat& mouth = input.plan->mouth_W.q;
  const Vec3 along = mouth * Vec3::UnitX();
  input.hand_W = { hand_mm * along, Quat(Eigen::AngleAxisd(turn_rad, along)) };
  input.coupling_N_per_u = this->coupling_N_per_mm;
  input.turning_Nu_per_rad = this->turning_Nmm_per_rad;
  input.budget = this->budget;
  return this->ticks.step(input);
}

double nearestWall_mm(const WirePlan& plan, const WireState& state)
{
  constexpr int places = 10;
  const SurfaceData& vessel = plan.vessel->data();
  double nearest_mm = std::numeric_limits<double>::infinity();
  bool out = false; // of the sheath
  for (int b = 0; b < plan.wire.count; ++b)
  {
    for (int i = 0; i <= places; ++i)
    {
      const double share = static_cast<double>(i) / places;
      const Vec3 p = (1.0 - share) * state.places_M[b].p + share * state.places_M[b + 1].p;
      out = out || p.x() > 0.0;
      for (std::uint32_t t = 0; out && t < vessel.mesh.triangles.size(); ++t)
      {
        const auto [c, d, e] = vessel.cornersOf(t);
        if ((c - p).squaredNorm() < 25.0)
        {
          nearest_mm = std::min(nearest_mm, (nearestOnTriangle(p, c, d, e) - p).norm());
        }
      }
    }
  }
  return nearest_mm;
}

} // namespace palpate::test
