// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticWireShape_h
#define vtkHapticWireShape_h

#include <span>
#include <vector>

#include "haptics/mechanism/wire/WirePlan.h"
#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// The points of a tube around a wire whose nodes are there, a ring at each node, in the order of
/// vtkHapticWireShape(). Nodes at one place leave the ring as the one before is turned.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<palpate::Vec3> vtkHapticWireRings(
  std::span<const palpate::Vec3> nodes_W, double radius_u);

/// Where the nodes of a wire are before anything moves: in its sheath.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<palpate::Vec3> vtkHapticWireAtFirst(const palpate::WirePlan& plan);

/// The tube around a wire in its sheath, with the number of each point as vtkOriginalPointIds.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkPolyData> vtkHapticWireShape(const palpate::WirePlan& plan);

#endif
