// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{

/// What a surface is made of. The defaults are a wall as stiff as the coupling, with the friction of the contact plan.
struct Material
{
  static constexpr double asPlanned = -1.0;
  static constexpr double largestFriction = 10.0;

  double stiffnessFactor = 1.0;       ///< of the coupling's stiffness, 0..1
  double frictionStatic = asPlanned;  ///< mu_s; below 0: the contact plan's
  double frictionKinetic = asPlanned; ///< mu_k

  [[nodiscard]] bool isPlain() const noexcept
  {
    return this->stiffnessFactor == 1.0 && this->frictionStatic < 0.0 && this->frictionKinetic < 0.0;
  }
  /// Empty, or one sentence that names the value that cannot be used.
  [[nodiscard]] std::string validate() const;
};

/// The same from data: one value a vertex, interpolated over faces and edges. An empty array: the surface's own value.
struct MaterialFields
{
  std::vector<double> stiffnessFactor;
  std::vector<double> frictionStatic;
  std::vector<double> frictionKinetic;
  std::vector<double> height_u; ///< texture: how far the felt surface stands out along its normal

  [[nodiscard]] bool empty() const noexcept
  {
    return this->stiffnessFactor.empty() && this->frictionStatic.empty() && this->frictionKinetic.empty() &&
           this->height_u.empty();
  }
};

/// Fields of a cleaned mesh from those of the mesh it came from.
struct FittedFields
{
  MaterialFields fields;
  std::string refusal;        ///< not empty: an array is not as long as the mesh has vertices
  std::size_t replaced = 0;   ///< values that were NaN or out of range: the surface's own took their place
};

/// `sourceVertex`: for each cleaned vertex its number in the raw mesh; `rawVertices` how many that had.
[[nodiscard]] FittedFields fitFields(const MaterialFields& raw, const Material& own,
  const std::vector<std::uint32_t>& sourceVertex, std::size_t rawVertices);

} // namespace palpate
