// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/solve/EliminationPath.h"

#include <algorithm>

namespace palpate
{
namespace
{

using Block = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// The supernodes that a set of rows reaches, and where their columns stand among those reached.
struct Path
{
  std::vector<int> supernodes; ///< ascending: each before its parent
  std::vector<int> place;      ///< of each place of the factor, or -1
  int size = 0;
};

std::vector<int> placesOfRows(const SupernodalView& factor)
{
  std::vector<int> place(static_cast<std::size_t>(factor.order));
  for (int k = 0; k < factor.order; ++k)
  {
    place[factor.matrixRow[k]] = k;
  }
  return place;
}

std::vector<int> supernodeOfPlaces(const SupernodalView& factor)
{
  std::vector<int> supernode(static_cast<std::size_t>(factor.order));
  for (int s = 0; s < factor.count; ++s)
  {
    std::fill(supernode.begin() + factor.column[s], supernode.begin() + factor.column[s + 1], s);
  }
  return supernode;
}

/// The parent of a supernode is that of the first row below its own columns.
Path pathOf(const SupernodalView& factor, const SparseColumns& e, const std::vector<int>& placeOfRow)
{
  const std::vector<int> supernodeOf = supernodeOfPlaces(factor);
  std::vector<bool> reached(static_cast<std::size_t>(factor.count), false);
  for (const std::int32_t row : e.rows)
  {
    for (int s = supernodeOf[placeOfRow[row]]; s >= 0 && !reached[s];)
    {
      reached[s] = true;
      const int own = factor.column[s + 1] - factor.column[s];
      const bool root = factor.rowStart[s] + own == factor.rowStart[s + 1];
      s = root ? -1 : supernodeOf[factor.rows[factor.rowStart[s] + own]];
    }
  }
  Path path;
  path.place.assign(static_cast<std::size_t>(factor.order), -1);
  for (int s = 0; s < factor.count; ++s)
  {
    if (reached[s])
    {
      path.supernodes.push_back(s);
      for (int k = factor.column[s]; k < factor.column[s + 1]; ++k)
      {
        path.place[k] = path.size++;
      }
    }
  }
  return path;
}

/// Y <- L^-1 Y for one supernode: its own rows are solved, the rows below get their part taken off.
void eliminate(const SupernodalView& factor, const Path& path, int s, Eigen::MatrixXd& y, Eigen::MatrixXd& below)
{
  const int own = factor.column[s + 1] - factor.column[s];
  const int all = factor.rowStart[s + 1] - factor.rowStart[s];
  const double* const values = factor.values + factor.valueStart[s];
  auto solved = y.middleRows(path.place[factor.column[s]], own);
  Block(values, own, own, Eigen::OuterStride<>(all)).triangularView<Eigen::Lower>().solveInPlace(solved);
  if (all == own)
  {
    return;
  }
  below.noalias() = Block(values + own, all - own, own, Eigen::OuterStride<>(all)) * solved;
  const int* const rows = factor.rows + factor.rowStart[s] + own;
  for (int i = 0; i < all - own; ++i)
  {
    y.row(path.place[rows[i]]) -= below.row(i);
  }
}

} // namespace

Eigen::MatrixXd complianceOnPath(const SupernodalView& factor, const SparseColumns& e)
{
  const std::vector<int> placeOfRow = placesOfRows(factor);
  const Path path = pathOf(factor, e, placeOfRow);
  const auto columns = static_cast<Eigen::Index>(e.count());
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(path.size, columns);
  for (Eigen::Index c = 0; c < columns; ++c)
  {
    for (std::size_t i = e.start[c]; i < e.start[c + 1]; ++i)
    {
      y(path.place[placeOfRow[e.rows[i]]], c) += e.values[i];
    }
  }
  Eigen::MatrixXd below;
  for (const int s : path.supernodes)
  {
    eliminate(factor, path, s, y, below);
  }
  Eigen::MatrixXd half = Eigen::MatrixXd::Zero(columns, columns);
  half.selfadjointView<Eigen::Lower>().rankUpdate(y.transpose());
  return half.selfadjointView<Eigen::Lower>();
}

} // namespace palpate
