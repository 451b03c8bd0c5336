// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticHeldWire.h"

#include "vtkHapticWireShape.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

vtkSmartPointer<vtkDoubleArray> vtkHapticWireWay(const palpate::WirePlan& plan, std::span<const palpate::Vec3> nodes_W)
{
  const std::vector<palpate::Vec3> first_W = vtkHapticWireRings(vtkHapticWireAtFirst(plan), plan.radius_u);
  const std::vector<palpate::Vec3> now_W =
    nodes_W.empty() ? first_W : vtkHapticWireRings(nodes_W, plan.radius_u); // as many nodes as the plan has
  auto gone = vtkSmartPointer<vtkDoubleArray>::New();
  gone->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < std::min(first_W.size(), now_W.size()); ++i)
  {
    const palpate::Vec3 gone_u = now_W[i] - first_W[i];
    gone->InsertNextTuple(gone_u.data());
  }
  return gone;
}

std::string vtkHapticHeldWireText(const palpate::MechanismNow& now)
{
  std::ostringstream text;
  text.precision(3);
  const double turned_deg = 0.01 * std::round(100.0 * vtkMath::DegreesFromRadians(now.wire.turned_rad)) + 0.0; // no -0
  text << "; pushed out " << now.wire.pushed_u << " u, turned " << turned_deg << " degrees; its tip is pushed with "
       << now.wire.tip_N << " N, the wall pushes with at most " << now.wire.wall_N << " N";
  text << (now.wire.leftOut > 0 ? "; it touches in more places than a tick can solve" : "")
       << (now.wire.crowded > 0 ? "; more triangles are around it than are looked at: use a coarser vessel" : "")
       << (now.capped ? "; it is not at rest yet, and goes on in the next tick" : "");
  return text.str();
}
