// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/planes/Projection.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

/// A roll asks for at most 27 rows (the touched planes, and three as they will be), seating for at most 32; the
/// rest is room.
constexpr int maxRows = 48;
/// |sin|^2 below which two planes act as one. Unit normals are rounded by 1e-16, so a sine of 1e-13 is known to a
/// thousandth; planes are to be told apart down to 1e-12 rad (row 12 of the bar).
constexpr double parallelPair = 1e-26;
/// |det| below which three planes have no common corner, by the same reasoning.
constexpr double dependentTriple = 1e-13;

bool before(const PlaneRow& a, const PlaneRow& b) noexcept
{
  for (int k = 0; k < 3; ++k)
  {
    if (a.n[k] != b.n[k])
    {
      return a.n[k] < b.n[k];
    }
  }
  return a.bound < b.bound;
}

/// Candidate solutions over the rows in one canonical order, so that the answer does not know the caller's.
class Solver
{
public:
  Solver(std::span<const PlaneRow> rows, const Vec3& q, double slack) noexcept
    : rows_(rows), q_(q), slack_(slack), count_(rows.size() < maxRows ? static_cast<int>(rows.size()) : maxRows)
  {
    for (int i = 0; i < this->count_; ++i)
    {
      int at = i;
      for (; at > 0 && before(rows[i], rows[this->order_[at - 1]]); --at)
      {
        this->order_[at] = this->order_[at - 1];
      }
      this->order_[at] = i;
    }
  }

  [[nodiscard]] ProjectionResult solve() noexcept
  {
    this->search();
    this->best_.feasible = this->found_;
    this->best_.sets = this->sets_;
    return this->best_;
  }

private:
  void search() noexcept
  {
    this->accept({}, this->q_, 0);
    if (this->found_ && this->worst_ >= 0.0)
    {
      return;
    }
    // A set that leaves another row violated by mere rounding is only taken if no larger set does better: between
    // nearly parallel planes the larger one is the exact answer, and its error is bounded by depth times angle.
    for (const auto stage : { &Solver::trySingles, &Solver::tryPairs, &Solver::tryTriples })
    {
      (this->*stage)();
      if (this->found_ && this->worst_ >= 0.0)
      {
        return;
      }
    }
  }

  [[nodiscard]] const PlaneRow& row(int i) const noexcept { return this->rows_[this->order_[i]]; }

  /// True once a set of that size is taken: of one size the first in canonical order stays.
  [[nodiscard]] bool has(int size) const noexcept { return this->found_ && this->best_.count == size; }

  void trySingles() noexcept
  {
    for (int i = 0; i < this->count_ && !this->has(1); ++i)
    {
      const double l = this->row(i).bound - this->row(i).n.dot(this->q_);
      if (l >= 0.0)
      {
        this->accept({ i, -1, -1 }, this->q_ + l * this->row(i).n, 1, { l, 0, 0 });
      }
    }
  }

  void tryPairs() noexcept
  {
    for (int i = 0; i < this->count_; ++i)
    {
      for (int j = i + 1; j < this->count_ && !this->has(2); ++j)
      {
        this->tryPair(i, j);
      }
    }
  }

  void tryTriples() noexcept
  {
    for (int i = 0; i < this->count_; ++i)
    {
      for (int j = i + 1; j < this->count_; ++j)
      {
        for (int k = j + 1; k < this->count_ && !this->has(3); ++k)
        {
          this->tryTriple(i, j, k);
        }
      }
    }
  }

  /// Gram-Schmidt: to the plane of i, then straight along it to the plane of j. Refined twice, since in narrow wedges a
  /// single step leaves errors that look like planes which contradict each other.
  void tryPair(int i, int j) noexcept
  {
    ++this->sets_;
    const Vec3 &ni = this->row(i).n, &nj = this->row(j).n;
    Vec3 u = nj - ni.dot(nj) * ni;
    u -= ni.dot(u) * ni;
    const double uu = u.squaredNorm();
    if (uu < parallelPair)
    {
      return;
    }
    const double li0 = this->row(i).bound - ni.dot(this->q_);
    Vec3 y = this->q_ + li0 * ni;
    double lj = 0.0;
    double li = li0;
    for (int step = 0; step < 3; ++step)
    {
      const double change = (this->row(j).bound - nj.dot(y)) / uu; // along u: n_i . u = 0, n_j . u = |u|^2
      y += change * u;
      lj += change;
      const double back = this->row(i).bound - ni.dot(y);
      y += back * ni;
      li += back;
    }
    li -= lj * ni.dot(nj); // y = q + li0 ni + lj u, u = nj - (ni.nj) ni
    if (li >= 0.0 && lj >= 0.0)
    {
      this->accept({ i, j, -1 }, y, 2, { li, lj, 0.0 });
    }
  }

  /// Cramer's rule for the corner and for the multipliers, each refined once.
  void tryTriple(int i, int j, int k) noexcept
  {
    ++this->sets_;
    const std::array<int, 3> set = { i, j, k };
    const Vec3 &a = this->row(i).n, &b = this->row(j).n, &c = this->row(k).n;
    const Vec3 bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
    const double det = a.dot(bc);
    if (std::fabs(det) < dependentTriple)
    {
      return;
    }
    Vec3 y = this->q_;
    for (int step = 0; step < 2; ++step)
    {
      Vec3 rest;
      for (int m = 0; m < 3; ++m)
      {
        rest[m] = this->row(set[m]).bound - this->row(set[m]).n.dot(y);
      }
      y += (rest[0] * bc + rest[1] * ca + rest[2] * ab) / det;
    }
    Vec3 l = Vec3::Zero();
    for (int step = 0; step < 2; ++step)
    {
      const Vec3 rest = (y - this->q_) - (l[0] * a + l[1] * b + l[2] * c);
      l += Vec3(rest.dot(bc), rest.dot(ca), rest.dot(ab)) / det;
    }
    if (l.minCoeff() >= 0.0)
    {
      this->accept(set, y, 3, { l[0], l[1], l[2] });
    }
  }

  /// Keeps the candidate if it violates no other row by more than rounding, and the best one so far by less.
  void accept(const std::array<int, 3>& set, const Vec3& y, int size, const std::array<double, 3>& l = {}) noexcept
  {
    // A deep press is a long sum of multipliers, each rounded in its own size.
    const double allowed = this->slack_ + 8 * std::numeric_limits<double>::epsilon() * (l[0] + l[1] + l[2]);
    double worst = 0.0;
    for (int i = 0; i < this->count_; ++i)
    {
      const bool isActive = (size > 0 && set[0] == i) || (size > 1 && set[1] == i) || (size > 2 && set[2] == i);
      const double over = isActive ? 0.0 : this->row(i).n.dot(y) - this->row(i).bound;
      worst = over < worst ? over : worst;
      if (worst < -allowed || !(over == over))
      {
        return;
      }
    }
    this->found_ = true;
    this->worst_ = worst;
    this->best_.y = y;
    this->best_.count = size;
    for (int m = 0; m < size; ++m)
    {
      this->best_.active[m] = this->order_[set[m]];
      this->best_.lambda[m] = l[m];
    }
  }

  std::span<const PlaneRow> rows_;
  Vec3 q_;
  double slack_;
  int count_;
  std::array<int, maxRows> order_;
  ProjectionResult best_;
  int sets_ = 0;
  bool found_ = false;
  double worst_ = 0.0;
};

} // namespace

ProjectionResult projectOntoPlanes(std::span<const PlaneRow> rows, const Vec3& q, double slack) noexcept
{
  return Solver(rows, q, slack).solve();
}

} // namespace palpate
