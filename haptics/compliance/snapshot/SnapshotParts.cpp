// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "haptics/compliance/snapshot/SnapshotMaker.h"

namespace palpate
{

/// Null: forces there act on the patch of the vertex, as they do where nodes are halfway between vertices as well.
const PressedPart* SnapshotMaker::partAt(const SnapshotRequest& request, std::uint32_t vertex) const
{
  const auto found = std::ranges::find(request.parts, vertex, &PressedPart::at);
  return found != request.parts.end() && this->body_.points().halves.empty() ? &*found : nullptr;
}

/// Three columns per vertex, those of its part in place of its patch.
SparseColumns SnapshotMaker::columnsOf(
  const SnapshotRequest& request, Spread& spread, std::span<const std::uint32_t> vertices) const
{
  SparseColumns columns;
  for (const std::uint32_t v : vertices)
  {
    const PressedPart* const part = this->partAt(request, v);
    const SparseColumns patch = part ? SparseColumns() : spread.patches.columnsOf({ &v, 1 });
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (std::size_t k = 0; part && k < part->vertices.size(); ++k)
      {
        const std::uint32_t node = this->surface_.vertices[part->vertices[k]];
        columns.rows.push_back(static_cast<std::int32_t>(3 * node + axis));
        columns.values.push_back(part->shares[k]);
      }
      for (std::size_t i = part ? 0 : patch.start[axis]; !part && i < patch.start[axis + 1]; ++i)
      {
        columns.rows.push_back(patch.rows[i]);
        columns.values.push_back(patch.values[i]);
      }
      columns.start.push_back(columns.rows.size());
    }
  }
  return columns;
}

/// Columns of parts are solved for in each snapshot: parts change as the surfaces that touch do.
void SnapshotMaker::addParts(const SnapshotRequest& request, Spread& spread, ComplianceSnapshot& snapshot) const
{
  std::vector<std::uint32_t> at;
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < snapshot.near.size(); ++i)
  {
    if (this->partAt(request, snapshot.near[i]))
    {
      at.push_back(snapshot.near[i]);
      rows.push_back(3 * static_cast<Eigen::Index>(i));
    }
  }
  if (at.empty())
  {
    return;
  }
  const Eigen::MatrixXd columns =
    this->body_.compliance(this->columnsOf(request, spread, snapshot.near), this->columnsOf(request, spread, at));
  for (std::size_t p = 0; p < rows.size(); ++p)
  {
    const auto column = columns.middleCols<3>(3 * static_cast<Eigen::Index>(p));
    snapshot.compliance.middleCols<3>(rows[p]) = column;
    snapshot.compliance.middleRows<3>(rows[p]) = column.transpose();
  }
  // The pairs among the parts are asymmetric by rounding: one half counts.
  snapshot.compliance = Eigen::MatrixXd(snapshot.compliance.selfadjointView<Eigen::Lower>());
}

Eigen::VectorXd SnapshotMaker::loadOf(const SnapshotRequest& request, Spread& spread) const
{
  Eigen::VectorXd load = Eigen::VectorXd::Zero(this->body_.displacement().size());
  for (std::size_t i = 0; i < request.forceAt.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::uint32_t v = request.forceAt[i].vertices[corner];
      const Vec3 force_N = request.forceAt[i].weights[corner] * request.force_N[i];
      const PressedPart* const part = this->partAt(request, v);
      if (part == nullptr)
      {
        spread.patches.addForce(v, force_N, load);
        continue;
      }
      for (std::size_t k = 0; k < part->vertices.size(); ++k)
      {
        const std::uint32_t node = this->surface_.vertices[part->vertices[k]];
        load.segment<3>(3 * static_cast<Eigen::Index>(node)) += part->shares[k] * force_N;
      }
    }
  }
  return load;
}

} // namespace palpate
