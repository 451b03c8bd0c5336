// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHeldWire_h
#define vtkHapticHeldWire_h

#include "haptics/mechanism/wire/WirePlan.h"
#include "haptics/tick/base/HapticState.h"
#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"

#include <span>
#include <string>

/// How far the points of vtkHapticWireShape() have gone when the nodes are there [u]; no nodes: nowhere.
[[nodiscard]] vtkSmartPointer<vtkDoubleArray> vtkHapticWireWay(
  const palpate::WirePlan& plan, std::span<const palpate::Vec3> nodes_W);

/// State of a wire in the hand, as the end of a line.
[[nodiscard]] std::string vtkHapticHeldWireText(const palpate::MechanismNow& now);

#endif
