// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/Mechanism.h"
#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{
namespace
{

constexpr double heaviest_kg_per_m3 = 1e6; ///< no known solid is a tenth of that
/// Of the cube of a mesh's size: a smaller volume is rounding.
constexpr double leastVolume = 1e-9;

BodyMass massOf(const EnclosedVolume& enclosed, double density_kg_per_m3, double unit_m)
{
  const double perVolume = density_kg_per_m3 * std::pow(unit_m, 4); // kilograms times metres a unit
  const Mat3& second = enclosed.second_u5;
  return { perVolume * enclosed.volume_u3, perVolume * (second.trace() * Mat3::Identity() - second) };
}

std::string refuseDensity(double density_kg_per_m3)
{
  return density_kg_per_m3 > 0.0 && density_kg_per_m3 <= heaviest_kg_per_m3
           ? ""
           : "must be above 0 and at most 1e6 kg/m^3: omit the density for a body without mass, which is at rest in "
             "each tick";
}

} // namespace

MassGiven giveMass(MechanismBody& body, double density_kg_per_m3, double unit_m)
{
  MassGiven given;
  given.refusal = refuseDensity(density_kg_per_m3);
  if (!given.refusal.empty())
  {
    return given;
  }
  TriangleMesh mesh = body.mesh ? body.mesh->rightHanded() : boxOf(body.halfSize_u);
  const EnclosedVolume enclosed = enclosedBy(mesh);
  const double size_u = body.mesh ? body.mesh->diagonal_u : 2.0 * body.halfSize_u.norm();
  if (!(enclosed.volume_u3 > leastVolume * std::pow(size_u, 3)))
  {
    given.refusal = "gives no mass: the body encloses no volume";
    return given;
  }
  given.centre_u = body.mesh ? enclosed.centre_u : Vec3(Vec3::Zero());
  for (Vec3& p : mesh.vertices_W)
  {
    p -= given.centre_u;
  }
  auto made = makeRigidMesh(mesh);
  given.refusal = made.ok() ? "" : "gives no mass: " + made.problem;
  body.mesh = std::move(made.value);
  body.pose_W.p = body.pose_W * given.centre_u;
  body.mass = massOf(enclosed, density_kg_per_m3, unit_m);
  return given;
}

} // namespace palpate
