// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/session/scene/FieldSource.h"

namespace palpate
{

/// Snap targets given by a person, in W [u].
struct SnapPlaces
{
  std::vector<Vec3> points_W;
  std::vector<FieldBlockLine> lines_W;
};

/// A field whose scalar is compared with the scalar of another one, which has points of its own: its trilinear values
/// are taken at the points of the first. Where the other has no value there is nothing to compare.
[[nodiscard]] std::shared_ptr<const FieldSource> comparedWith(
  std::shared_ptr<const FieldSource> field, std::shared_ptr<const FieldSource> other);

/// A field that a hand snaps to given places of, instead of those that are found in its values: of points and of pieces
/// of lines those nearest to the place that a block is made around, FieldBlock::mostPlaces of each.
[[nodiscard]] std::shared_ptr<const FieldSource> snappingTo(
  std::shared_ptr<const FieldSource> field, SnapPlaces places);

} // namespace palpate
