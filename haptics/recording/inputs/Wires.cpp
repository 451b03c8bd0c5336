// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/inputs/Wires.h"

#include <algorithm>
#include <cmath>

#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/recording/bytes/RecordingLayout.h"
#include "haptics/recording/inputs/Places.h"

namespace palpate
{
namespace
{

template<class Io, class Plan>
void layWire(const Io& io, Plan& plan)
{
  io(plan.revision);
  io(plan.wire.count);
  io(plan.radius_u);
  io(plan.friction);
  io(plan.mouth_W);
  io(plan.mouthAway_u);
}

template<class Io, class Beam>
void layBeam(const Io& io, Beam& beam)
{
  for (auto* const number :
    { &beam.section.stretch_N, &beam.section.shear_N, &beam.section.bend_Nu2, &beam.section.twist_Nu2, &beam.length_u })
  {
    io(*number);
  }
  io(beam.first);
  io(beam.second);
}

bool isPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

/// A beam may be stiff against shear without limit.
bool isUsable(const WireBeam& beam)
{
  const BeamSection& section = beam.section;
  return isPositive(section.stretch_N) && section.shear_N > 0.0 && isPositive(section.bend_Nu2) &&
         isPositive(section.twist_Nu2) && isPositive(beam.length_u) && isTurn(beam.first) && isTurn(beam.second);
}

} // namespace

void putWire(ByteWriter& payload, const WirePlan& plan)
{
  const Put put{ payload };
  layWire(put, plan);
  for (int i = 0; i < plan.wire.count; ++i)
  {
    layBeam(put, plan.wire.beams[static_cast<std::size_t>(i)]);
  }
  payload.put(plan.vessel->data().mesh.vertices_W);
  payload.put(plan.vessel->data().mesh.triangles);
}

std::shared_ptr<const WirePlan> readWire(ByteReader& in, TriangleMesh& vessel_W)
{
  auto plan = std::make_shared<WirePlan>();
  layWire(Get{ in }, *plan);
  in.failUnless(plan->wire.count > 0 && plan->wire.count <= Wire::mostBeams && isPositive(plan->radius_u) &&
                std::isfinite(plan->friction) && plan->friction >= 0.0 && isPlace(plan->mouth_W) &&
                isPositive(plan->mouthAway_u));
  for (int i = 0; in.ok() && i < plan->wire.count; ++i)
  {
    WireBeam& beam = plan->wire.beams[static_cast<std::size_t>(i)];
    layBeam(Get{ in }, beam);
    in.failUnless(isUsable(beam));
  }
  in.get(vessel_W.vertices_W);
  in.get(vessel_W.triangles);
  return in.ok() ? plan : nullptr;
}

bool isUsable(const WireState& state)
{
  const bool numbers = std::isfinite(state.grip_u) && std::isfinite(state.led_u) && std::isfinite(state.handTurn_rad) &&
                       std::isfinite(state.turned_rad);
  return numbers && isTurn(state.hand_W) && state.pressCount >= 0 && state.pressCount <= WireTouch::most &&
         std::ranges::all_of(state.places_M, [](const Pose& pose) { return isPlace(pose); }) &&
         std::ranges::all_of(state.presses, [](const WirePress& press)
           { return press.at_M.allFinite() && press.axes_N.allFinite() && press.force_M.allFinite(); });
}

} // namespace palpate
