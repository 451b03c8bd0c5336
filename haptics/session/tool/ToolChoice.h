// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/tool/mesh/ToolMesh.h"

namespace palpate
{

/// A rigid tool in the hand in place of the proxy sphere.
struct ToolChoice
{
  std::shared_ptr<const ToolMesh> tool; ///< null: none
  double characteristic_u = 0.0; ///< lever arm that converts a rotation [rad] to a displacement [u]; 0: the tool's own

  /// The lever arm in use [u]; 0: no tool.
  [[nodiscard]] double weighs_u() const noexcept
  {
    return !this->tool ? 0.0 : this->characteristic_u > 0.0 ? this->characteristic_u : this->tool->gyration_u;
  }
  friend bool operator==(const ToolChoice&, const ToolChoice&) = default;
};

} // namespace palpate
