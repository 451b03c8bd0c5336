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
void layHead(const Io& io, Body& body, Packet& packet)
{
  io(body.revision);
  io(body.period_s);
  io(body.touch.surface);
  io(packet.version);
  io(packet.builtFromTick);
  io(packet.energy_Nu);
  io(packet.residual_N);
  io(packet.mostGradient);
}

template<class Io, class Packet>
void layPlace(const Io& io, Packet& packet, std::size_t place)
{
  io(packet.near[place]);
  io(packet.springs[place].hertz);
  io(packet.springs[place].patch);
  io(packet.patchRadius_u[place]);
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

void readPlaces(ByteReader& in, CompliancePacket& packet)
{
  const std::uint64_t places = in.count(sizeof(std::uint32_t) + 3 * sizeof(double));
  in.failUnless(places > 0 && places <= CompliancePacket::mostVertices);
  if (!in.ok())
  {
    return;
  }
  packet.near.resize(places);
  packet.springs.resize(places);
  packet.patchRadius_u.resize(places);
  for (std::size_t i = 0; i < places; ++i)
  {
    layPlace(Get{ in }, packet, i);
  }
  const auto rows = static_cast<Eigen::Index>(3 * places);
  if (in.has(static_cast<std::size_t>(rows * (rows + 1) / 2) * sizeof(double)))
  {
    packet.compliance.resize(rows, rows);
    layLowerHalf(Get{ in }, packet.compliance);
    packet.compliance = packet.compliance.selfadjointView<Eigen::Lower>().toDenseMatrix();
  }
}

void readForces(ByteReader& in, CompliancePacket& packet)
{
  const std::uint64_t forces = in.count(bytesOfForce);
  in.failUnless(forces <= BodyHand::most);
  packet.forceAt.resize(in.ok() ? forces : 0);
  packet.force_N.resize(packet.forceAt.size());
  for (std::size_t i = 0; i < packet.forceAt.size(); ++i)
  {
    in.get(packet.forceAt[i]);
    in.get(packet.force_N[i]);
  }
}

/// Numbers that the tick computes with, and indices that it follows.
bool isUsable(const CompliancePacket& packet)
{
  const std::size_t vertices = packet.placeOf.size();
  const std::size_t places = packet.near.size();
  const auto below = [](std::size_t end) { return [end](std::size_t index) { return index < end; }; };
  return std::ranges::all_of(packet.placeOf, below(places)) && std::ranges::all_of(packet.near, below(vertices)) &&
         packet.compliance.allFinite() &&
         std::ranges::all_of(packet.patchRadius_u, [](double a) { return a > 0.0 && std::isfinite(a); }) &&
         std::ranges::all_of(packet.springs,
           [](const SubgridSpring& s)
           {
             return s.hertz >= 0.0 && std::isfinite(s.hertz) && s.patch >= 0.0 && std::isfinite(s.patch) &&
                    (s.hertz == 0.0 || s.patch > 0.0);
           }) &&
         std::ranges::all_of(packet.forceAt,
           [&below, vertices](const SurfacePoint& p) {
             return std::ranges::all_of(p.vertices, below(vertices)) && p.weights.allFinite() && p.x_W.allFinite();
           }) &&
         std::ranges::all_of(packet.force_N, [](const Vec3& f) { return f.allFinite(); }) &&
         std::isfinite(packet.energy_Nu);
}

} // namespace

void putBody(ByteWriter& payload, const PressedBody& body)
{
  const CompliancePacket& packet = *body.packet;
  const Put put{ payload };
  layHead(put, body, packet);
  put(static_cast<std::uint64_t>(packet.near.size()));
  for (std::size_t i = 0; i < packet.near.size(); ++i)
  {
    layPlace(put, packet, i);
  }
  layLowerHalf(put, packet.compliance);
  put(packet.placeOf);
  put(static_cast<std::uint64_t>(packet.forceAt.size()));
  for (std::size_t i = 0; i < packet.forceAt.size(); ++i)
  {
    put(packet.forceAt[i]);
    put(packet.force_N[i]);
  }
}

void putKnots(ByteWriter& payload, const PressedBody& body)
{
  const Put put{ payload };
  const std::vector<SubgridSpring>& springs = body.packet->springs;
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
  auto packet = std::make_shared<CompliancePacket>(*body.packet);
  for (std::size_t i = 0; in.ok() && step > 0.0 && i < packet->springs.size(); ++i)
  {
    packet->springs[i].step = step;
    layKnots(Get{ in }, packet->springs[i]);
    in.failUnless(rises(packet->springs[i]));
  }
  body.touch.packet = packet.get();
  body.packet = std::move(packet);
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
  auto packet = std::make_shared<CompliancePacket>();
  layHead(Get{ in }, *body, *packet);
  readPlaces(in, *packet);
  in.get(packet->placeOf);
  readForces(in, *packet);
  in.failUnless(in.ok() && isUsable(*packet) && std::isfinite(body->period_s) && body->period_s >= 0.0);
  body->touch.packet = packet.get();
  body->packet = std::move(packet);
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
