// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/solve/NearestMotion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The active rows as an orthonormal basis times an upper triangular matrix.
class ActiveRows
{
public:
  ActiveRows(std::span<const MotionRow> rows, const Vec6& wish, NearestMotion& result) noexcept
    : rows_(rows), wish_(wish), result_(result)
  {
  }

  /// The part of a row that is orthogonal to the active ones.
  [[nodiscard]] Vec6 freePart(Vec6 j) const noexcept
  {
    for (int pass = 0; pass < 2; ++pass) // the second removes the rounding errors of the first
    {
      for (int i = 0; i < this->result_.count; ++i)
      {
        j -= this->basis_[i] * this->basis_[i].dot(j);
      }
    }
    return j;
  }

  /// Decrease of the pressures of the active rows while the pressure of another row grows by one.
  [[nodiscard]] std::array<double, 6> falls(const Vec6& j) const noexcept
  {
    std::array<double, 6> d{};
    for (int i = this->result_.count - 1; i >= 0; --i)
    {
      double sum = this->basis_[i].dot(j);
      for (int k = i + 1; k < this->result_.count; ++k)
      {
        sum -= this->upper_[k][i] * d[k];
      }
      d[i] = sum / this->upper_[i][i];
    }
    return d;
  }

  void add(int row) noexcept
  {
    this->result_.row[this->result_.count] = row;
    this->append(this->result_.count);
    ++this->result_.count;
  }

  void remove(int at) noexcept
  {
    NearestMotion& r = this->result_;
    std::copy(r.row.begin() + at + 1, r.row.begin() + r.count, r.row.begin() + at);
    std::copy(r.pressure.begin() + at + 1, r.pressure.begin() + r.count, r.pressure.begin() + at);
    const int left = r.count - 1;
    for (r.count = 0; r.count < left; ++r.count)
    {
      this->append(r.count);
    }
  }

  /// Motion and pressures from the active rows alone, so that no error of earlier steps stays.
  void resolve() noexcept
  {
    NearestMotion& r = this->result_;
    std::array<double, 6> along{};
    r.y = this->wish_;
    for (int i = 0; i < r.count; ++i)
    {
      const MotionRow& row = this->rows_[r.row[i]];
      double sum = row.bound - row.j.dot(this->wish_);
      for (int k = 0; k < i; ++k)
      {
        sum -= this->upper_[i][k] * along[k];
      }
      along[i] = sum / this->upper_[i][i];
      r.y += along[i] * this->basis_[i];
    }
    for (int i = r.count - 1; i >= 0; --i)
    {
      double sum = along[i];
      for (int k = i + 1; k < r.count; ++k)
      {
        sum -= this->upper_[k][i] * r.pressure[k];
      }
      r.pressure[i] = std::max(0.0, sum / this->upper_[i][i]);
    }
  }

private:
  /// Column `at` of the factors, whose row number is in the result; the columns before it are valid.
  void append(int at) noexcept
  {
    Vec6 rest = this->rows_[this->result_.row[at]].j;
    this->upper_[at] = {};
    for (int pass = 0; pass < 2; ++pass)
    {
      for (int i = 0; i < at; ++i)
      {
        const double along = this->basis_[i].dot(rest);
        this->upper_[at][i] += along;
        rest -= along * this->basis_[i];
      }
    }
    this->upper_[at][at] = rest.norm();
    this->basis_[at] = rest / this->upper_[at][at];
  }

  std::span<const MotionRow> rows_;
  const Vec6& wish_;
  NearestMotion& result_;
  std::array<Vec6, 6> basis_{};
  std::array<std::array<double, 6>, 6> upper_{}; ///< [column][row]
};

struct Violation
{
  int row = -1;
  double depth = 0.0;
};

/// The row that the motion violates most, beyond rounding.
Violation worst(std::span<const MotionRow> rows, const Vec6& y, double rounding) noexcept
{
  Violation found;
  found.depth = rounding;
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    const double depth = rows[k].bound - rows[k].j.dot(y);
    if (depth > found.depth)
    {
      found = { static_cast<int>(k), depth };
    }
  }
  return found;
}

double roundingOf(std::span<const MotionRow> rows, const Vec6& wish) noexcept
{
  double largest = wish.cwiseAbs().maxCoeff();
  for (const MotionRow& row : rows)
  {
    largest = std::max(largest, std::abs(row.bound));
  }
  return 16.0 * epsilon * largest;
}

/// Growth of the pressure of a violated row, and the active row that is released then.
struct PressureStep
{
  double length = 0.0;
  int leaves = -1; ///< none: the violated row becomes active
};

/// At most `length`: until the first decreasing pressure is zero.
PressureStep pressureStep(const NearestMotion& r, const std::array<double, 6>& falls, double length) noexcept
{
  PressureStep step{ length };
  for (int i = 0; i < r.count; ++i)
  {
    if (falls[i] > epsilon && r.pressure[i] < step.length * falls[i])
    {
      step = { r.pressure[i] / falls[i], i };
    }
  }
  return step;
}

/// Makes the violated row active and releases rows whose pressure would become negative. False: it contradicts the
/// others.
bool enforce(ActiveRows& active, const MotionRow& row, int broken, NearestMotion& r) noexcept
{
  constexpr double dependentBelow = 1e-11; // of a unit row: a smaller rest is rounding of orthogonalising twice
  double gained = 0.0;
  while (true)
  {
    const Vec6 free = active.freePart(row.j);
    const double free2 = free.squaredNorm();
    const bool moves = r.count < 6 && free2 > dependentBelow * dependentBelow;
    const std::array<double, 6> falls = active.falls(row.j);
    const double needed = (row.bound - row.j.dot(r.y)) / free2;
    const PressureStep step = pressureStep(r, falls, moves ? needed : std::numeric_limits<double>::infinity());
    if (step.leaves < 0 && !moves)
    {
      return false;
    }
    for (int i = 0; i < r.count; ++i)
    {
      r.pressure[i] -= step.length * falls[i];
    }
    gained += step.length;
    r.y += moves ? Vec6(step.length * free) : Vec6(Vec6::Zero());
    if (step.leaves < 0)
    {
      r.pressure[r.count] = gained;
      active.add(broken);
      return true;
    }
    active.remove(step.leaves);
  }
}

} // namespace

MotionRow motionRow(const Vec3& n, const Vec3& arm, double least, double characteristic_u) noexcept
{
  Vec6 j;
  j << n, arm.cross(n) / characteristic_u;
  const double norm = j.norm();
  return { j / norm, least / norm };
}

NearestMotion nearestMotion(std::span<const MotionRow> rows, const Vec6& wish) noexcept
{
  NearestMotion result;
  result.y = wish;
  ActiveRows active(rows, wish, result);
  const double rounding = roundingOf(rows, wish);
  const std::size_t cap = 20 + 4 * rows.size(); // the distance grows with each step: only rounding could cause a cycle
  for (std::size_t step = 0; step < cap; ++step)
  {
    const Violation broken = worst(rows, result.y, rounding);
    if (broken.row < 0)
    {
      return result;
    }
    if (!enforce(active, rows[broken.row], broken.row, result))
    {
      break;
    }
    active.resolve();
  }
  result.feasible = false;
  return result;
}

} // namespace palpate
