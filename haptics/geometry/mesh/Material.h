// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

struct TriangleMesh;

/// Material of a surface. The defaults are a wall as stiff as the coupling, with the friction of the contact plan.
///
/// The stiffness k is the one that is felt. A spring k behind the coupling's K would be felt as K k / (K + k). So the
/// wall is made so much stiffer that both in series are k, up to a rigid wall, which is felt as K: felt is the smaller
/// of k and K.
struct Material
{
  static constexpr double asPlanned = -1.0;
  static constexpr double largestFriction = 10.0;
  static constexpr double rigid_N_per_m = std::numeric_limits<double>::infinity();

  double stiffness_N_per_m = rigid_N_per_m; ///< as felt, >= 0; no more than the coupling's is
  double frictionStatic = asPlanned;        ///< mu_s; below 0: the contact plan's
  double frictionKinetic = asPlanned;       ///< mu_k

  [[nodiscard]] bool isPlain() const noexcept
  {
    return this->stiffness_N_per_m == rigid_N_per_m && this->frictionStatic < 0.0 && this->frictionKinetic < 0.0;
  }
  /// Empty, or one sentence that names the value that cannot be used.
  [[nodiscard]] std::string validate() const;
  friend bool operator==(const Material&, const Material&) = default;
};

/// How a texture varies over its surface: its mean, which is felt where the texture is too fine for a moving hand, and
/// how fine it is.
struct TextureScale
{
  double largest_u = 0.0; ///< height: there the surface is met
  double mean_u = 0.0;    ///< height, by area
  double period_u =
    std::numeric_limits<double>::infinity(); ///< 2 pi rms(height - mean) / rms(slope); of a wave: its length
};

/// The same from data: one value a vertex, interpolated over faces and edges. An empty array: the surface's own value.
struct MaterialFields
{
  std::vector<double> stiffness_N_per_m;
  std::vector<double> frictionStatic;
  std::vector<double> frictionKinetic;
  std::vector<double> height_u; ///< texture: its highest places are the surface itself, lower ones are hollows in it
  TextureScale texture;         ///< of height_u

  [[nodiscard]] bool empty() const noexcept
  {
    return this->stiffness_N_per_m.empty() && this->frictionStatic.empty() && this->frictionKinetic.empty() &&
           this->height_u.empty();
  }
};

/// Fields of a cleaned mesh from those of the mesh it came from.
struct FittedFields
{
  MaterialFields fields;
  std::string refusal;      ///< not empty: an array is not as long as the mesh has vertices
  std::size_t replaced = 0; ///< values that were NaN or out of range: the surface's own took their place, its top
                            ///< that of a height
};

/// Largest, mean and period of heights, one a vertex. The period is Rice's mean distance of two upward crossings of the
/// mean.
[[nodiscard]] TextureScale measureTexture(const TriangleMesh& mesh, const std::vector<double>& height_u);

/// `sourceVertex`: for each cleaned vertex its number in the raw mesh; `rawVertices` how many that had.
[[nodiscard]] FittedFields fitFields(const MaterialFields& raw, const Material& own,
  const std::vector<std::uint32_t>& sourceVertex, std::size_t rawVertices);

} // namespace palpate
