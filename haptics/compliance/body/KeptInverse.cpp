// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/body/KeptInverse.h"

#include <algorithm>

#include "haptics/compliance/solve/Blas.h"

namespace palpate
{
namespace
{

/// Three columns per node, one for each component of its displacement.
SparseColumns unitColumns(std::span<const std::uint32_t> nodes)
{
  SparseColumns units;
  for (const std::uint32_t node : nodes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      units.rows.push_back(static_cast<std::int32_t>(3 * node) + axis);
      units.values.push_back(1.0);
      units.start.push_back(units.rows.size());
    }
  }
  return units;
}

} // namespace

KeptInverse::KeptInverse(const SoftBody& body, const std::vector<std::uint32_t>& nodes)
  : body_(body), placeOf_(body.points().rest_W.size())
{
  for (std::size_t n = 0; n < this->placeOf_.size(); ++n)
  {
    this->placeOf_[n] = body.isHeld(n) ? noPlace : elsewhere;
  }
  for (const std::uint32_t node : nodes)
  {
    if (this->placeOf_[node] == elsewhere && this->nodes_.size() < mostNodes)
    {
      this->placeOf_[node] = static_cast<std::int32_t>(this->nodes_.size());
      this->nodes_.push_back(node);
    }
  }
  this->columns_.resize((this->nodes_.size() + nodesAtOnce - 1) / nodesAtOnce);
}

bool KeptInverse::condenseNext()
{
  const std::size_t begin = this->known();
  if (begin == this->nodes_.size())
  {
    return false;
  }
  const std::size_t end = std::min(begin + nodesAtOnce, this->nodes_.size());
  const std::span<const std::uint32_t> all(this->nodes_.data(), end);
  this->columns_[begin / nodesAtOnce] = this->body_.compliance(unitColumns(all), unitColumns(all.subspan(begin)));
  this->known_.store(end, std::memory_order_release);
  return true;
}

bool KeptInverse::knows(const SparseColumns& h) const
{
  const auto known = static_cast<std::int32_t>(this->known());
  return std::ranges::all_of(h.rows,
    [this, known](std::int32_t row)
    {
      const std::int32_t place = this->placeOf_[static_cast<std::size_t>(row / 3)];
      return place == noPlace || (place >= 0 && place < known);
    });
}

/// Places of the free nodes, ascending.
std::vector<std::int32_t> KeptInverse::placesOf(const SparseColumns& h) const
{
  std::vector<bool> isAmong(this->nodes_.size(), false);
  for (const std::int32_t row : h.rows)
  {
    if (const std::int32_t place = this->placeOf_[static_cast<std::size_t>(row / 3)]; place >= 0)
    {
      isAmong[static_cast<std::size_t>(place)] = true;
    }
  }
  std::vector<std::int32_t> places;
  for (std::size_t i = 0; i < isAmong.size(); ++i)
  {
    if (isAmong[i])
    {
      places.push_back(static_cast<std::int32_t>(i));
    }
  }
  return places;
}

auto KeptInverse::between(std::int32_t earlier, std::int32_t later) const
{
  constexpr auto atOnce = static_cast<std::int32_t>(nodesAtOnce);
  return this->columns_[static_cast<std::size_t>(later / atOnce)].block<3, 3>(3 * earlier, 3 * (later % atOnce));
}

Eigen::MatrixXd KeptInverse::gather(
  const std::vector<std::int32_t>& rows, const std::vector<std::int32_t>& columns) const
{
  Eigen::MatrixXd found(3 * rows.size(), 3 * columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j)
  {
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      auto block = found.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j));
      if (rows[i] <= columns[j])
      {
        block = this->between(rows[i], columns[j]);
      }
      else
      {
        block = this->between(columns[j], rows[i]).transpose();
      }
    }
  }
  return found;
}

/// The same columns with rows numbered among the nodes at these places, without those of fixed nodes.
SparseColumns KeptInverse::among(const std::vector<std::int32_t>& places, const SparseColumns& h) const
{
  std::vector<std::int32_t> number(this->nodes_.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    number[static_cast<std::size_t>(places[i])] = static_cast<std::int32_t>(3 * i);
  }
  SparseColumns found;
  for (std::size_t c = 0; c < h.count(); ++c)
  {
    for (std::size_t i = h.start[c]; i < h.start[c + 1]; ++i)
    {
      if (const std::int32_t place = this->placeOf_[static_cast<std::size_t>(h.rows[i] / 3)]; place >= 0)
      {
        found.rows.push_back(number[static_cast<std::size_t>(place)] + h.rows[i] % 3);
        found.values.push_back(h.values[i]);
      }
    }
    found.start.push_back(found.rows.size());
  }
  return found;
}

Eigen::MatrixXd KeptInverse::compliance(const SparseColumns& h, const SparseColumns& n) const
{
  const std::vector<std::int32_t> rows = this->placesOf(h);
  const std::vector<std::int32_t> columns = this->placesOf(n);
  const SparseColumns onRows = this->among(rows, h);
  const SparseColumns onColumns = this->among(columns, n);
  const Eigen::MatrixXd inverse = this->gather(rows, columns);
  const auto count = static_cast<int>(n.count());
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(count, inverse.cols());
  for (std::size_t c = 0; c < n.count(); ++c)
  {
    for (std::size_t i = onColumns.start[c]; i < onColumns.start[c + 1]; ++i)
    {
      forces(static_cast<Eigen::Index>(c), onColumns.rows[i]) += onColumns.values[i];
    }
  }
  const auto moved = static_cast<int>(inverse.rows());
  Eigen::MatrixXd answers = Eigen::MatrixXd::Zero(count, moved);
  if (count > 0 && moved > 0 && inverse.cols() > 0)
  {
    blas::multiply(count, moved, static_cast<int>(inverse.cols()), 1.0, { forces.data(), count },
      { inverse.data(), moved }, blas::Transposed::Yes, 0.0, { answers.data(), count });
  }
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(h.count()), count);
  for (std::size_t c = 0; c < h.count(); ++c)
  {
    auto row = found.row(static_cast<Eigen::Index>(c));
    for (std::size_t i = onRows.start[c]; i < onRows.start[c + 1]; ++i)
    {
      row += onRows.values[i] * answers.col(onRows.rows[i]).transpose();
    }
  }
  return found;
}

} // namespace palpate
