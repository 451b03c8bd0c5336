// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/inputs/Bodies.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

constexpr std::size_t bytesOfForce = 3 * sizeof(std::uint32_t) + 9 * sizeof(double);

template<class Io, class Body, class Packet>
void layHead(const Io& io, Body& body, Packet& snapshot)
{
  io(body.revision);
  io(body.period_s);
  io(body.touch.surface);
  io(snapshot.version);
  io(snapshot.builtFromTick);
  io(snapshot.energy_Nu);
  io(snapshot.residual_N);
  io(snapshot.mostGradient);
}

template<class Io, class Packet>
void layPlace(const Io& io, Packet& snapshot, std::size_t place)
{
  io(snapshot.near[place]);
  io(snapshot.springs[place].hertz);
  io(snapshot.springs[place].patch);
  io(snapshot.patchRadius_u[place]);
}

/// At the first knot a spring is 0, and level.
template<class Io, class Spring>
void layKnots(const Io& io, Spring& spring)
{
  io(spring.across);
  for (std::size_t k = 1; k < SubgridSpring::knots; ++k)
  {
    io(spring.depth_u[k]);
    io(spring.rise[k]);
  }
}

/// A spring that never gets shallower.
bool rises(const SubgridSpring& spring)
{
  bool usable = spring.across >= 0.0 && std::isfinite(spring.across);
  for (std::size_t k = 1; k < SubgridSpring::knots; ++k)
  {
    usable = usable && spring.depth_u[k] >= spring.depth_u[k - 1] && std::isfinite(spring.depth_u[k]) &&
             spring.rise[k] >= 0.0 && std::isfinite(spring.rise[k]);
  }
  return usable;
}

/// It is symmetric to the bit: half of it says all.
template<class Io, class Matrix>
void layLowerHalf(const Io& io, Matrix& square)
{
  for (Eigen::Index column = 0; column < square.cols(); ++column)
  {
    for (Eigen::Index row = column; row < square.rows(); ++row)
    {
      io(square(row, column));
    }
  }
}

void readPlaces(ByteReader& in, ComplianceSnapshot& snapshot)
{
  const std::uint64_t places = in.count(sizeof(std::uint32_t) + 3 * sizeof(double));
  in.failUnless(places > 0 && places <= ComplianceSnapshot::mostVertices);
  if (!in.ok())
  {
    return;
  }
  snapshot.near.resize(places);
  snapshot.springs.resize(places);
  snapshot.patchRadius_u.resize(places);
  for (std::size_t i = 0; i < places; ++i)
  {
    layPlace(Get{ in }, snapshot, i);
  }
  const auto rows = static_cast<Eigen::Index>(3 * places);
  if (in.has(static_cast<std::size_t>(rows * (rows + 1) / 2) * sizeof(double)))
  {
    snapshot.compliance.resize(rows, rows);
    layLowerHalf(Get{ in }, snapshot.compliance);
    snapshot.compliance = snapshot.compliance.selfadjointView<Eigen::Lower>().toDenseMatrix();
  }
}

void readForces(ByteReader& in, ComplianceSnapshot& snapshot)
{
  const std::uint64_t forces = in.count(bytesOfForce);
  in.failUnless(forces <= BodyHand::most);
  snapshot.forceAt.resize(in.ok() ? forces : 0);
  snapshot.force_N.resize(snapshot.forceAt.size());
  for (std::size_t i = 0; i < snapshot.forceAt.size(); ++i)
  {
    in.get(snapshot.forceAt[i]);
    in.get(snapshot.force_N[i]);
  }
}

/// Numbers that the tick computes with, and indices that it follows.
bool isUsable(const ComplianceSnapshot& snapshot)
{
  const std::size_t vertices = snapshot.placeOf.size();
  const std::size_t places = snapshot.near.size();
  const auto below = [](std::size_t end) { return [end](std::size_t index) { return index < end; }; };
  return std::ranges::all_of(snapshot.placeOf, below(places)) && std::ranges::all_of(snapshot.near, below(vertices)) &&
         snapshot.compliance.allFinite() &&
         std::ranges::all_of(snapshot.patchRadius_u, [](double a) { return a > 0.0 && std::isfinite(a); }) &&
         std::ranges::all_of(snapshot.springs,
           [](const SubgridSpring& s)
           {
             return s.hertz >= 0.0 && std::isfinite(s.hertz) && s.patch >= 0.0 && std::isfinite(s.patch) &&
                    (s.hertz == 0.0 || s.patch > 0.0);
           }) &&
         std::ranges::all_of(snapshot.forceAt,
           [&below, vertices](const SurfacePoint& p) {
             return std::ranges::all_of(p.vertices, below(vertices)) && p.weights.allFinite() && p.x_W.allFinite();
           }) &&
         std::ranges::all_of(snapshot.force_N, [](const Vec3& f) { return f.allFinite(); }) &&
         std::isfinite(snapshot.energy_Nu);
}

} // namespace

void putBody(ByteWriter& payload, const PressedBody& body)
{
  const ComplianceSnapshot& snapshot = *body.snapshot;
  const Put put{ payload };
  layHead(put, body, snapshot);
  put(static_cast<std::uint64_t>(snapshot.near.size()));
  for (std::size_t i = 0; i < snapshot.near.size(); ++i)
  {
    layPlace(put, snapshot, i);
  }
  layLowerHalf(put, snapshot.compliance);
  put(snapshot.placeOf);
  put(static_cast<std::uint64_t>(snapshot.forceAt.size()));
  for (std::size_t i = 0; i < snapshot.forceAt.size(); ++i)
  {
    put(snapshot.forceAt[i]);
    put(snapshot.force_N[i]);
  }
}

void putKnots(ByteWriter& payload, const PressedBody& body)
{
  const Put put{ payload };
  const std::vector<SubgridSpring>& springs = body.snapshot->springs;
  const double step = springs.empty() ? 0.0 : springs.front().step;
  put(step);
  for (std::size_t i = 0; step > 0.0 && i < springs.size(); ++i)
  {
    layKnots(put, springs[i]);
  }
}

void readKnots(ByteReader& in, PressedBody& body)
{
  double step = 0.0;
  in.get(step);
  in.failUnless(step >= 0.0 && std::isfinite(step));
  auto snapshot = std::make_shared<ComplianceSnapshot>(*body.snapshot);
  for (std::size_t i = 0; in.ok() && step > 0.0 && i < snapshot->springs.size(); ++i)
  {
    snapshot->springs[i].step = step;
    layKnots(Get{ in }, snapshot->springs[i]);
    in.failUnless(rises(snapshot->springs[i]));
  }
  body.touch.snapshot = snapshot.get();
  body.snapshot = std::move(snapshot);
}

void putHeld(ByteWriter& payload, const PressedBody& body)
{
  const TriangleMesh faces = body.heldFaces ? *body.heldFaces : TriangleMesh{};
  payload.put(faces.vertices_W);
  payload.put(faces.triangles);
}

void readHeld(ByteReader& in, PressedBody& body)
{
  TriangleMesh faces;
  in.get(faces.vertices_W);
  in.get(faces.triangles);
  const auto isThere = [&faces](std::uint32_t v) { return v < faces.vertices_W.size(); };
  in.failUnless(std::ranges::all_of(faces.vertices_W, [](const Vec3& x_W) { return x_W.allFinite(); }) &&
                std::ranges::all_of(faces.triangles,
                  [&isThere](const auto& triangle) { return std::ranges::all_of(triangle, isThere); }));
  const bool some = in.ok() && !faces.triangles.empty();
  body.heldFaces = some ? std::make_shared<const TriangleMesh>(std::move(faces)) : nullptr;
}

std::shared_ptr<const PressedBody> readBody(ByteReader& in)
{
  auto body = std::make_shared<PressedBody>();
  auto snapshot = std::make_shared<ComplianceSnapshot>();
  layHead(Get{ in }, *body, *snapshot);
  readPlaces(in, *snapshot);
  in.get(snapshot->placeOf);
  readForces(in, *snapshot);
  in.failUnless(in.ok() && isUsable(*snapshot) && std::isfinite(body->period_s) && body->period_s >= 0.0);
  body->touch.snapshot = snapshot.get();
  body->snapshot = std::move(snapshot);
  return in.ok() ? body : nullptr;
}

namespace input
{

void Bodies::write(ByteWriter& payload, const PressedBody& body)
{
  putBody(payload, body);
  payload.put(body.beside);
  putKnots(payload, body);
  putHeld(payload, body);
}

void Bodies::read(ByteReader& payload, Recorded& recorded)
{
  std::shared_ptr<const PressedBody> body = readBody(payload);
  if (body)
  {
    auto whole = std::make_shared<PressedBody>(*body);
    payload.get(whole->beside);
    readKnots(payload, *whole);
    readHeld(payload, *whole);
    body = payload.ok() ? std::move(whole) : nullptr;
  }
  recorded.bodies.push_back(std::move(body));
}

} // namespace input
} // namespace palpate
