// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/contact/GodObject.h"
#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/TriangleGrid.h"

namespace palpate::test
{

/// Judges the path of a ball's centre with CGAL's exact predicates and a grid of its own; nothing of the code under
/// test is used. The triangles are closed; the mesh is taken as it is given, without cleaning.
class PathChecker final : public PathSink
{
public:
  /// `clearanceTolerance_u`: by how much the centre of a ball of radius r > 0 may come nearer than r.
  PathChecker(const TriangleMesh& mesh, double radius_u, double clearanceTolerance_u = 0.0);
  /// The same for another ball over the same mesh, whose grid is shared.
  PathChecker(const PathChecker& sameMesh, double radius_u, double clearanceTolerance_u);

  void segment(const Vec3& from_W, const Vec3& to_W) noexcept override;

  /// Judges the path since the last call and forgets it. Empty when every piece continues the one before, does not meet
  /// any triangle (touching included) and keeps its distance; else the first finding in words. `start_W` is where the
  /// centre was before.
  [[nodiscard]] std::string finding(const Vec3& start_W);

  /// Its grid of the mesh, to be shared.
  [[nodiscard]] const std::shared_ptr<const TriangleGrid>& grid() const noexcept { return this->grid_; }

  /// Pieces judged so far.
  [[nodiscard]] std::size_t judged() const noexcept { return this->judged_; }

private:
  struct Piece
  {
    Vec3 from_W, to_W;
  };
  [[nodiscard]] std::string findingFor(const Piece& piece) const;

  std::shared_ptr<const TriangleGrid> grid_;
  double leastDistance_u_;
  std::vector<Piece> pieces_;
  std::size_t judged_ = 0;
};

} // namespace palpate::test
