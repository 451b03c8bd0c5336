// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticWireFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "vtkHapticConversion.h"
#include "vtkHapticReaders.h"
#include "vtkPolyData.h"

namespace
{
using Node = vtkHapticSceneNode;

constexpr double UsualBeam_diameters = 8.0;

palpate::WireTip TipOf(const Node& node)
{
  const std::string name = node.text("tip", vtkHapticWireTips.front());
  for (std::size_t i = 0; i < vtkHapticWireTips.size(); ++i)
  {
    if (name == vtkHapticWireTips[i])
    {
      return static_cast<palpate::WireTip>(i);
    }
  }
  node.fail("tip", "unknown tip \"" + name + "\"; valid tips: straight, angled, hook, helix");
}

palpate::WireShape ShapeOf(const Node& node, double diameter_u)
{
  palpate::WireShape shape;
  shape.length_u = node.needsNumber("length");
  shape.tip = TipOf(node);
  shape.tip_u = node.size("tip_length");
  shape.radius_u = node.size("tip_radius");
  shape.pitch_u = node.number("tip_pitch", 0.0);
  const double usual = std::clamp(
    std::ceil(shape.length_u / (UsualBeam_diameters * diameter_u)), 1.0, static_cast<double>(palpate::Wire::mostBeams));
  const double beams = node.number("beams", std::isfinite(usual) ? usual : 1.0);
  if (!(beams >= 1.0 && beams <= palpate::Wire::mostBeams) || beams != std::floor(beams))
  {
    std::ostringstream text;
    text << "must be a whole number from 1 to " << palpate::Wire::mostBeams << ": beams of "
         << shape.length_u / palpate::Wire::mostBeams << " would do";
    node.fail("beams", text.str());
  }
  shape.beams = static_cast<int>(beams);
  return shape;
}

palpate::WireDescription WireOf(const Node& node, double unit_m)
{
  palpate::WireDescription wire;
  const double perUnit2 = unit_m * unit_m;
  wire.diameter_u = node.needsNumber("diameter");
  wire.shape = ShapeOf(node, wire.diameter_u);
  wire.young_N_per_u2 = perUnit2 * node.needsNumber("young_Pa");
  wire.tipYoung_N_per_u2 = perUnit2 * node.size("tip_young_Pa");
  wire.poisson = node.number("poisson", wire.poisson);
  wire.friction = node.size("friction");
  wire.mouth_W = node.vector("mouth", wire.mouth_W);
  wire.direction_W = node.vector("direction", wire.direction_W);
  return wire;
}

std::shared_ptr<const palpate::TriangleMesh> VesselOf(const Node& node, const std::string& folder)
{
  const std::string path = (std::filesystem::path(folder) / node.needed("vessel")).string();
  const vtkHapticReadResult read = vtkHapticReadSurface(path, {});
  node.accept("vessel", read.Surface ? "" : read.Problem);
  const vtkHapticConversionResult converted = vtkHapticToMesh(read.Surface);
  node.accept("vessel", converted.Mesh ? "" : path + ": " + converted.Problem);
  return converted.Mesh;
}

} // namespace

std::shared_ptr<const palpate::PlannedWire> vtkHapticReadWire(const vtkHapticSceneNode& node, const std::string& folder,
  double unit_m, const std::shared_ptr<const palpate::TriangleMesh>& given_W)
{
  const palpate::WireDescription description = WireOf(node, unit_m);
  const auto vessel_W = given_W && !node.has("vessel") ? given_W : VesselOf(node, folder);
  auto planned = std::make_shared<palpate::PlannedWire>(palpate::planWire(description, *vessel_W, 1));
  planned->vessel_W = vessel_W;
  return planned;
}

std::vector<std::string> vtkHapticWireText(const palpate::WireCheck& check)
{
  std::ostringstream beams, bends, mouth, cost;
  bends.precision(3);
  mouth.precision(3);
  beams << check.beams << " beams, at most " << check.contacts << " contacts at once";
  bends << "follows bends of a radius of at least " << check.tightest_u << " u, the length of three beams";
  mouth << "clearance at the mouth " << check.clearance_u << " u";
  cost << "a tick takes at most three steps of " << check.work << " units of work without contacts";
  std::vector<std::string> lines{ beams.str(), bends.str(), mouth.str(), cost.str() };
  lines.insert(lines.end(), check.remarks.begin(), check.remarks.end());
  return lines;
}
