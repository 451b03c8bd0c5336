// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/solve/EliminationPath.h"

#include <algorithm>

#include "haptics/compliance/solve/Blas.h"

namespace palpate
{
namespace
{

/// The parent of a supernode is that of the first row below its own columns; -1: a root.
int parentOf(const SupernodalView& pattern, const std::vector<int>& supernodeOf, int s)
{
  return pattern.all(s) == pattern.own(s) ? -1 : supernodeOf[*pattern.rowsBelow(s)];
}

blas::Block columnsFrom(Eigen::MatrixXd& y, int first)
{
  return { y.data() + first * y.rows(), static_cast<int>(y.rows()) };
}

} // namespace

EliminationPath::EliminationPath(
  const SupernodalView& pattern, const double* values, const std::vector<std::int32_t>& rows)
  : pattern_(pattern), values_(values), placeOfRow_(placesOfRows(pattern)),
    place_(static_cast<std::size_t>(pattern.order), -1)
{
  const std::vector<int> supernodeOf = supernodesOfPlaces(pattern);
  std::vector<bool> reached(static_cast<std::size_t>(pattern.count), false);
  for (const std::int32_t row : rows)
  {
    for (int s = supernodeOf[this->placeOfRow_[row]]; s >= 0 && !reached[s]; s = parentOf(pattern, supernodeOf, s))
    {
      reached[s] = true;
    }
  }
  this->numberReached(reached);
}

EliminationPath::EliminationPath(const SupernodalView& pattern, const double* values)
  : pattern_(pattern), values_(values), placeOfRow_(placesOfRows(pattern)),
    place_(static_cast<std::size_t>(pattern.order), -1)
{
  this->numberReached(std::vector<bool>(static_cast<std::size_t>(pattern.count), true));
}

void EliminationPath::numberReached(const std::vector<bool>& reached)
{
  for (int s = 0; s < this->pattern_.count; ++s)
  {
    if (reached[s])
    {
      this->supernodes_.push_back(s);
      this->mostBelow_ = std::max(this->mostBelow_, this->pattern_.all(s) - this->pattern_.own(s));
      for (int k = this->pattern_.column[s]; k < this->pattern_.column[s + 1]; ++k)
      {
        this->place_[k] = this->size_++;
      }
    }
  }
}

Eigen::MatrixXd EliminationPath::rightSides(const SparseColumns& e) const
{
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(e.count()), this->size_);
  for (std::size_t c = 0; c < e.count(); ++c)
  {
    for (std::size_t i = e.start[c]; i < e.start[c + 1]; ++i)
    {
      y(static_cast<Eigen::Index>(c), this->place_[this->placeOfRow_[e.rows[i]]]) += e.values[i];
    }
  }
  return y;
}

void EliminationPath::forward(Eigen::MatrixXd& y) const
{
  const int sides = static_cast<int>(y.rows());
  Eigen::MatrixXd taken(sides, this->mostBelow_);
  for (const int s : this->supernodes_)
  {
    const int own = this->pattern_.own(s);
    const int all = this->pattern_.all(s);
    const double* const block = this->values_ + this->pattern_.valueStart[s];
    const int first = this->place_[this->pattern_.column[s]];
    if (y.middleCols(first, own).isZero(0.0)) // on no path from a right-hand side
    {
      continue;
    }
    const blas::Block solved = columnsFrom(y, first);
    blas::solveRight(sides, own, { block, all }, blas::Transposed::Yes, solved);
    if (all == own)
    {
      continue;
    }
    blas::multiply(sides, all - own, own, 1.0, { solved.values, sides }, { block + own, all }, blas::Transposed::Yes,
      0.0, { taken.data(), sides });
    for (int i = 0; i < all - own; ++i)
    {
      y.col(this->place_[this->pattern_.rowsBelow(s)[i]]) -= taken.col(i);
    }
  }
}

void EliminationPath::backward(Eigen::MatrixXd& y) const
{
  const int sides = static_cast<int>(y.rows());
  Eigen::MatrixXd known(sides, this->mostBelow_);
  for (auto it = this->supernodes_.rbegin(); it != this->supernodes_.rend(); ++it)
  {
    const int own = this->pattern_.own(*it);
    const int all = this->pattern_.all(*it);
    const double* const block = this->values_ + this->pattern_.valueStart[*it];
    const blas::Block solved = columnsFrom(y, this->place_[this->pattern_.column[*it]]);
    if (all > own)
    {
      for (int i = 0; i < all - own; ++i)
      {
        known.col(i) = y.col(this->place_[this->pattern_.rowsBelow(*it)[i]]);
      }
      blas::multiply(
        sides, own, all - own, -1.0, { known.data(), sides }, { block + own, all }, blas::Transposed::No, 1.0, solved);
    }
    blas::solveRight(sides, own, { block, all }, blas::Transposed::No, solved);
  }
}

Eigen::MatrixXd EliminationPath::readOff(const SparseColumns& e, const Eigen::MatrixXd& answer) const
{
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(e.count()), answer.rows());
  for (std::size_t c = 0; c < e.count(); ++c)
  {
    for (std::size_t i = e.start[c]; i < e.start[c + 1]; ++i)
    {
      found.row(static_cast<Eigen::Index>(c)) +=
        e.values[i] * answer.col(this->place_[this->placeOfRow_[e.rows[i]]]).transpose();
    }
  }
  return found;
}

} // namespace palpate
