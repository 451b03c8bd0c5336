// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/solve/Supernodes.h"

#include <algorithm>

#include "haptics/compliance/solve/Blas.h"

namespace palpate
{
namespace
{

/// Columns that are subtracted at a time: enough for BLAS, and few enough that little of a triangle is wasted.
constexpr int mostAtOnce = 128;

/// Subtracts the products of one supernode from those to its right.
class Update
{
public:
  Update(const SupernodalView& pattern, const std::vector<int>& supernodeOf, double* values)
    : pattern_(pattern), supernodeOf_(supernodeOf), values_(values)
  {
  }

  void of(int s)
  {
    const int below = this->pattern_.all(s) - this->pattern_.own(s);
    const int* const rows = this->pattern_.rowsBelow(s);
    for (int begin = 0; begin < below;)
    {
      const int target = this->supernodeOf_[rows[begin]];
      int end = begin + 1;
      while (end < below && end - begin < mostAtOnce && rows[end] < this->pattern_.column[target + 1])
      {
        ++end;
      }
      this->takeOff(s, target, begin, end);
      begin = end;
    }
  }

private:
  /// Subtracts columns `begin` to `end` of L L^T below the supernode from those of the target.
  void takeOff(int s, int target, int begin, int end)
  {
    const int own = this->pattern_.own(s);
    const int all = this->pattern_.all(s);
    const int height = all - own - begin;
    const double* const from = this->values_ + this->pattern_.valueStart[s] + own + begin;
    this->product_.resize(static_cast<std::size_t>(height) * static_cast<std::size_t>(end - begin));
    blas::multiply(height, end - begin, own, 1.0, { from, all }, { from, all }, blas::Transposed::Yes, 0.0,
      { this->product_.data(), height });
    const int* const rows = this->pattern_.rowsBelow(s) + begin;
    this->findPlaces(target, rows, height);
    for (int c = 0; c < end - begin; ++c)
    {
      double* const to =
        this->values_ + this->pattern_.valueStart[target] +
        static_cast<std::ptrdiff_t>(rows[c] - this->pattern_.column[target]) * this->pattern_.all(target);
      const double* const product = this->product_.data() + static_cast<std::ptrdiff_t>(c) * height;
      for (int r = c; r < height; ++r)
      {
        to[this->places_[r]] -= product[r];
      }
    }
  }

  /// Finds each row among those of the target, which has them all.
  void findPlaces(int target, const int* rows, int count)
  {
    const int* const all = this->pattern_.rows + this->pattern_.rowStart[target];
    this->places_.resize(static_cast<std::size_t>(count));
    int place = 0;
    for (int r = 0; r < count; ++r)
    {
      while (all[place] < rows[r])
      {
        ++place;
      }
      this->places_[static_cast<std::size_t>(r)] = place;
    }
  }

  const SupernodalView& pattern_;
  const std::vector<int>& supernodeOf_;
  double* values_;
  std::vector<double> product_;
  std::vector<int> places_;
};

} // namespace

std::vector<int> placesOfRows(const SupernodalView& pattern)
{
  std::vector<int> place(static_cast<std::size_t>(pattern.order));
  for (int k = 0; k < pattern.order; ++k)
  {
    place[pattern.matrixRow[k]] = k;
  }
  return place;
}

std::vector<int> supernodesOfPlaces(const SupernodalView& pattern)
{
  std::vector<int> supernode(static_cast<std::size_t>(pattern.order));
  for (int s = 0; s < pattern.count; ++s)
  {
    std::fill(supernode.begin() + pattern.column[s], supernode.begin() + pattern.column[s + 1], s);
  }
  return supernode;
}

std::vector<int> slotsOf(const SupernodalView& pattern, const SparseLower& matrix)
{
  const std::vector<int> placeOf = placesOfRows(pattern);
  const std::vector<int> supernodeOf = supernodesOfPlaces(pattern);
  std::vector<int> slots;
  slots.reserve(matrix.rows.size());
  for (int c = 0; c < matrix.order(); ++c)
  {
    for (int i = matrix.start[c]; i < matrix.start[c + 1]; ++i)
    {
      const auto [column, row] = std::minmax(placeOf[c], placeOf[matrix.rows[i]]);
      const int s = supernodeOf[column];
      const int* const rows = pattern.rows + pattern.rowStart[s];
      const auto place = std::lower_bound(rows, rows + pattern.all(s), row) - rows;
      slots.push_back(pattern.valueStart[s] + (column - pattern.column[s]) * pattern.all(s) + static_cast<int>(place));
    }
  }
  return slots;
}

bool factorSupernodes(const SupernodalView& pattern, double* values)
{
  const std::vector<int> supernodeOf = supernodesOfPlaces(pattern);
  Update update(pattern, supernodeOf, values);
  for (int s = 0; s < pattern.count; ++s)
  {
    const int own = pattern.own(s);
    const int all = pattern.all(s);
    double* const block = values + pattern.valueStart[s];
    if (!blas::factorLower(own, { block, all }))
    {
      return false;
    }
    if (all > own)
    {
      blas::solveRight(all - own, own, { block, all }, blas::Transposed::Yes, { block + own, all });
      update.of(s);
    }
  }
  return true;
}

} // namespace palpate
