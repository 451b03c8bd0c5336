// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticWireFile_h
#define vtkHapticWireFile_h

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "haptics/core/JsonNode.h"
#include "haptics/mechanism/wire/WirePlan.h"
#include "vtkHapticJson.h"

/// The names of tips in a scene file, in the order of palpate::WireTip.
inline constexpr std::array<const char*, 4> vtkHapticWireTips{ "straight", "angled", "hook", "helix" };

/// An object of a scene file.
using vtkHapticSceneNode = palpate::JsonNode<nlohmann::json>;

/// The wire that a body of a scene file describes (docs/mechanisms.md), in its vessel, whose file is looked for in
/// `folder`; where none is named, in the one that is given, if any. A wrong value of a key fails there; its check has
/// the faults of the wire as a whole.
[[nodiscard]] std::shared_ptr<const palpate::PlannedWire> vtkHapticReadWire(const vtkHapticSceneNode& node,
  const std::string& folder, double unit_m, const std::shared_ptr<const palpate::TriangleMesh>& given_W);

/// The lines of a check for a person.
[[nodiscard]] std::vector<std::string> vtkHapticWireText(const palpate::WireCheck& check);

#endif
