// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/laws/Primitives.h"

#include <cmath>

#include <Eigen/LU>

#include "haptics/core/Across.h"
#include "haptics/field/laws/PrimitiveSets.h"

namespace palpate
{
namespace
{

constexpr int firstRounds = 3, moreRounds = 12, mostTries = 3, mostNewton = 8;
constexpr double stillRounds_N = 1e-13; ///< rounds that change no pull by more have ended
constexpr double dependent = 1e-6;      ///< sine between two constraints below which they count as one
constexpr double solved_N = 1e-11;      ///< of the pulls: far below the threshold of any hand, far above rounding

enum class Holding : std::uint8_t
{
  Slack,
  Slides,
  Holds
};

/// All points together, where they were taken out of a problem with one anchor.
struct CommonPoints
{
  double strength_N = 0.0;
  Vec3 anchor = Vec3::Zero();

  /// Whether they hold a hand that the others leave there: then any pulls that these may have are an answer.
  [[nodiscard]] bool hold(const Vec3& x, double k) const noexcept
  {
    return this->strength_N > 0.0 && k * (x - this->anchor).norm() <= this->strength_N;
  }
};

/// Of points, lines and planes.
class PrimitiveSolver
{
public:
  PrimitiveSolver(
    std::span<const Primitive> primitives, const CommonPoints& points, const Vec3& device, double stiffness) noexcept
    : primitives_(primitives), points_(points), device_(device), k_(stiffness)
  {
  }

  PrimitiveSolution solve() noexcept
  {
    this->best_.pull_N.fill(Vec3::Zero());
    this->best_.x = this->device_;
    bool done = this->takeRounds(firstRounds);
    for (int i = 0; i < mostTries && !done; ++i)
    {
      done = this->finishByNewton() || this->takeRounds(moreRounds << i);
    }
    this->best_.error_u = done ? 0.0 : this->certificate();
    return this->best_;
  }

private:
  using Pulls = std::array<Vec3, PrimitiveSolution::mostPrimitives>;

  [[nodiscard]] std::size_t count() const noexcept { return this->primitives_.size(); }

  /// Each pull in turn is solved for with the others fixed. True once none changes any more, or points hold.
  bool takeRounds(int rounds) noexcept
  {
    for (int round = 0; round < rounds; ++round)
    {
      ++this->best_.rounds;
      double change_N = 0.0;
      const Pulls before_N = this->best_.pull_N;
      for (std::size_t i = 0; i < this->count(); ++i)
      {
        Vec3& pull_N = this->best_.pull_N[i];
        const Vec3 without = this->best_.x - pull_N / this->k_;
        const Vec3 now_N = allowedPull(this->primitives_[i], -this->k_ * (without - this->primitives_[i].anchor));
        change_N = std::max(change_N, (now_N - pull_N).norm());
        this->best_.x = without + now_N / this->k_;
        pull_N = now_N;
      }
      if (change_N <= stillRounds_N || this->points_.hold(this->best_.x, this->k_))
      {
        return true;
      }
      if (this->best_.rounds > firstRounds)
      {
        this->goFurther(before_N);
      }
    }
    return false;
  }

  /// Rounds creep where pulls must shift strength from one to another. Their objective is a square of the place less a
  /// linear part, so its least along the change of the last round is known: that far, or a quarter of that, where the
  /// objective is less once the pulls are cut to their limits.
  void goFurther(const Pulls& before_N) noexcept
  {
    constexpr double furthest = 100.0, leastWorth = 0.1; // times the last round
    constexpr double shorter = 0.25;
    Vec3 change_u = Vec3::Zero();
    double drawn = 0.0;
    for (std::size_t i = 0; i < this->count(); ++i)
    {
      const Vec3 change_N = this->best_.pull_N[i] - before_N[i];
      change_u += change_N / this->k_;
      drawn += change_N.dot(this->primitives_[i].anchor);
    }
    const double least = (drawn - this->k_ * this->best_.x.dot(change_u)) / (this->k_ * change_u.squaredNorm());
    if (least > leastWorth && !this->goBy(std::min(least, furthest), before_N))
    {
      (void)this->goBy(shorter * std::min(least, furthest), before_N);
    }
  }

  /// True where that makes the square less.
  bool goBy(double share, const Pulls& before_N) noexcept
  {
    Pulls further_N = this->best_.pull_N;
    Vec3 x = this->device_;
    double drawn = 0.0;
    for (std::size_t i = 0; i < this->count(); ++i)
    {
      const Vec3& now_N = this->best_.pull_N[i];
      further_N[i] = allowedPull(this->primitives_[i], now_N + share * (now_N - before_N[i]));
      x += further_N[i] / this->k_;
      drawn += (further_N[i] - now_N).dot(this->primitives_[i].anchor);
    }
    const bool isLess = 0.5 * this->k_ * (x.squaredNorm() - this->best_.x.squaredNorm()) < drawn;
    if (isLess)
    {
      this->best_.pull_N = further_N;
      this->best_.x = x;
    }
    return isLess;
  }

  [[nodiscard]] Holding stateOf(std::size_t i) const noexcept
  {
    const Primitive& p = this->primitives_[i];
    const double pull_N = this->best_.pull_N[i].norm(), nearly = 1.0 - 1e-9;
    if (p.kind == PrimitiveKind::Plane && pull_N == 0.0)
    {
      return Holding::Slack;
    }
    return pull_N < nearly * p.strength_N ? Holding::Holds : Holding::Slides;
  }

  /// Directions in which a holding primitive leaves no freedom; directions that others hold already are left out.
  void addRows(const Primitive& p) noexcept
  {
    const auto [across, other] = tangentsOf(p.axis);
    const std::array<Vec3, 3> directions{ p.axis, across, other };
    const int first = p.kind == PrimitiveKind::Line ? 1 : 0, last = p.kind == PrimitiveKind::Plane ? 1 : 3;
    for (int d = first; d < last && this->rows_ < 3; ++d)
    {
      Vec3 left = directions[d];
      double target = left.dot(p.anchor);
      for (int r = 0; r < this->rows_; ++r)
      {
        const double part = this->row_[r].dot(left);
        left -= part * this->row_[r];
        target -= part * this->target_[r];
      }
      if (left.norm() > dependent)
      {
        this->row_[this->rows_] = left.normalized();
        this->target_[this->rows_++] = target / left.norm();
      }
    }
  }

  /// Newton's method on the guess: balance of the forces, while holding primitives do not move.
  bool finishByNewton() noexcept
  {
    this->rows_ = 0;
    for (std::size_t i = 0; i < this->count(); ++i)
    {
      this->holding_[i] = this->stateOf(i);
      if (this->holding_[i] == Holding::Holds)
      {
        this->addRows(this->primitives_[i]);
      }
    }
    if (this->rows_ == 3)
    {
      return this->accept(this->heldPlace()); // there is nothing to seek
    }
    Vec3 x = this->best_.x;
    for (int step = 0; step < mostNewton; ++step)
    {
      const Vec3 change = this->newtonStep(x);
      x += change;
      if (!(change.norm() <= 1e6 * (1.0 + x.norm())))
      {
        return false;
      }
      if (change.norm() <= 1e-15 * (this->device_ - x).norm())
      {
        break;
      }
    }
    return this->accept(x);
  }

  /// The place where the holding primitives leave no freedom.
  [[nodiscard]] Vec3 heldPlace() const noexcept
  {
    Vec3 x = Vec3::Zero();
    for (int r = 0; r < this->rows_; ++r)
    {
      x += this->target_[r] * this->row_[r];
    }
    return x;
  }

  [[nodiscard]] Vec3 newtonStep(const Vec3& x) const noexcept
  {
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
    using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
    const int n = 3 + this->rows_;
    Square matrix = Square::Zero(n, n);
    Column right = Column::Zero(n);
    matrix.topLeftCorner<3, 3>() = this->k_ * Mat3::Identity();
    right.head<3>() = this->k_ * (this->device_ - x);
    for (std::size_t i = 0; i < this->count(); ++i)
    {
      if (this->holding_[i] == Holding::Slides)
      {
        this->addSliding(this->primitives_[i], x, matrix, right);
      }
    }
    for (int r = 0; r < this->rows_; ++r)
    {
      matrix.block<3, 1>(0, 3 + r) = -this->row_[r];
      matrix.block<1, 3>(3 + r, 0) = this->row_[r].transpose();
      right[3 + r] = this->target_[r] - this->row_[r].dot(x);
    }
    const Column solution = matrix.partialPivLu().solve(right);
    return solution.head<3>();
  }

  template<class Square, class Column>
  void addSliding(const Primitive& p, const Vec3& x, Square& matrix, Column& right) const noexcept
  {
    if (p.kind == PrimitiveKind::Plane)
    {
      right.template head<3>() += p.strength_N * p.axis;
      return;
    }
    const Vec3 way = resisted(p, x - p.anchor);
    const double far = way.norm();
    const Vec3 u = far > 0.0 ? Vec3(way / far) : Vec3(Vec3::Zero());
    Mat3 across = Mat3::Identity() - u * u.transpose();
    if (p.kind == PrimitiveKind::Line)
    {
      across -= p.axis * p.axis.transpose();
    }
    matrix.template topLeftCorner<3, 3>() += far > 0.0 ? Mat3(p.strength_N / far * across) : Mat3(Mat3::Zero());
    right.template head<3>() -= p.strength_N * u;
  }

  /// Sliding primitives pull with all of their strength; holding ones share the missing force, changed as little as can
  /// be.
  [[nodiscard]] std::array<Vec3, PrimitiveSolution::mostPrimitives> pullsAt(const Vec3& x) const noexcept
  {
    std::array<Vec3, PrimitiveSolution::mostPrimitives> pull_N = this->best_.pull_N;
    Vec3 missing_N = this->k_ * (x - this->device_);
    Mat3 shares = Mat3::Zero();
    for (std::size_t i = 0; i < this->count(); ++i)
    {
      const Primitive& p = this->primitives_[i];
      if (this->holding_[i] == Holding::Slides)
      {
        const Vec3 away = resisted(p, x - p.anchor);
        if (p.kind != PrimitiveKind::Plane && this->k_ * away.norm() <= solved_N)
        {
          missing_N -= pull_N[i]; // at its anchor it may pull anywhere with all of its strength: as the rounds had it
          continue;
        }
        pull_N[i] = p.strength_N * (p.kind == PrimitiveKind::Plane ? p.axis : Vec3(-away.stableNormalized()));
      }
      for (int k = 0; k < 3 && this->holding_[i] == Holding::Holds; ++k)
      {
        shares.col(k) += resisted(p, Vec3::Unit(k));
      }
      missing_N -= pull_N[i];
    }
    Eigen::FullPivLU<Mat3> division(shares);
    const Vec3 share_N = division.setThreshold(dependent).solve(missing_N);
    for (std::size_t i = 0; i < this->count(); ++i)
    {
      if (this->holding_[i] == Holding::Holds)
      {
        pull_N[i] += resisted(this->primitives_[i], share_N);
      }
    }
    return pull_N;
  }

  /// The guess counts if every pull is the allowed one nearest to the same pull without its limit.
  bool accept(const Vec3& x) noexcept
  {
    const std::array<Vec3, PrimitiveSolution::mostPrimitives> pull_N = this->pullsAt(x);
    Vec3 sum_N = this->k_ * (this->device_ - x);
    for (std::size_t i = 0; i < this->count(); ++i)
    {
      const Primitive& p = this->primitives_[i];
      const Vec3 wanted_N = allowedPull(p, pull_N[i] - this->k_ * (x - p.anchor));
      if (!((wanted_N - pull_N[i]).norm() <= solved_N))
      {
        return false;
      }
      sum_N += pull_N[i];
    }
    if (!(sum_N.norm() <= solved_N))
    {
      return false;
    }
    this->best_.x = x;
    this->best_.pull_N = pull_N;
    return true;
  }

  /// Each term is the loss of a pull against its best, so none is negative and nothing cancels.
  [[nodiscard]] double certificate() const noexcept
  {
    double gap = 0.0;
    for (std::size_t i = 0; i < this->count(); ++i)
    {
      const Primitive& p = this->primitives_[i];
      gap += p.strength_N * missed(p, this->best_.x) + this->best_.pull_N[i].dot(this->best_.x - p.anchor);
    }
    return std::sqrt(2.0 * std::max(gap, 0.0) / this->k_);
  }

  std::span<const Primitive> primitives_;
  const CommonPoints& points_;
  Vec3 device_;
  double k_;
  PrimitiveSolution best_;
  std::array<Holding, PrimitiveSolution::mostPrimitives> holding_{};
  std::array<Vec3, 3> row_;
  std::array<double, 3> target_{}; ///< of the place along each row
  int rows_ = 0;
};

/// The rest of a problem once the pulls that need no search are taken out.
struct Reduced
{
  std::array<Primitive, PrimitiveSolution::mostPrimitives> primitive;
  std::array<std::size_t, PrimitiveSolution::mostPrimitives> origin{}; ///< of each that is left
  std::size_t count = 0;
  Vec3 device; ///< shifted by the forces that are the same everywhere
  CommonPoints points;
};

bool haveCommonAnchor(std::span<const Primitive> primitives) noexcept
{
  const Primitive* first = nullptr;
  for (const Primitive& p : primitives)
  {
    if (p.kind != PrimitiveKind::Directed)
    {
      first = first == nullptr ? &p : first;
      if (p.anchor != first->anchor)
      {
        return false;
      }
    }
  }
  return true;
}

/// With one anchor the proxy is the hand's offset from the anchor less the projection on the sum of all allowed pulls
/// (Moreau): the ball of the points may be taken off last, since the rest then has the direction of the whole.
Reduced reduce(std::span<const Primitive> primitives, const Vec3& device, double k) noexcept
{
  Reduced reduced;
  reduced.device = device;
  const bool common = haveCommonAnchor(primitives);
  for (std::size_t i = 0; i < primitives.size(); ++i)
  {
    const Primitive& p = primitives[i];
    if (p.kind == PrimitiveKind::Directed)
    {
      reduced.device += p.strength_N / k * p.axis;
    }
    else if (p.kind == PrimitiveKind::Point && common)
    {
      reduced.points.strength_N += p.strength_N;
      reduced.points.anchor = p.anchor;
    }
    else
    {
      reduced.origin[reduced.count] = i;
      reduced.primitive[reduced.count++] = p;
    }
  }
  return reduced;
}

} // namespace

PrimitiveSolution solvePrimitives(
  std::span<const Primitive> primitives, const Vec3& device, double stiffness_N_per_u) noexcept
{
  primitives = primitives.first(std::min<std::size_t>(primitives.size(), PrimitiveSolution::mostPrimitives));
  const Reduced reduced = reduce(primitives, device, stiffness_N_per_u);
  const PrimitiveSolution rest =
    PrimitiveSolver({ reduced.primitive.data(), reduced.count }, reduced.points, reduced.device, stiffness_N_per_u)
      .solve();
  PrimitiveSolution all = rest;
  all.pull_N.fill(Vec3::Zero());
  for (std::size_t i = 0; i < reduced.count; ++i)
  {
    all.pull_N[reduced.origin[i]] = rest.pull_N[i];
  }
  const CommonPoints& points = reduced.points;
  if (points.strength_N > 0.0)
  {
    const Vec3 way = rest.x - points.anchor;
    const double far_N = stiffness_N_per_u * way.norm();
    const bool holds = points.hold(rest.x, stiffness_N_per_u);
    all.x = holds ? points.anchor : Vec3(rest.x - (points.strength_N / far_N) * way);
  }
  for (std::size_t i = 0; i < primitives.size(); ++i)
  {
    const Primitive& p = primitives[i];
    if (p.kind == PrimitiveKind::Directed)
    {
      all.pull_N[i] = p.strength_N * p.axis;
    }
    else if (p.kind == PrimitiveKind::Point && points.strength_N > 0.0)
    {
      all.pull_N[i] = p.strength_N / points.strength_N * stiffness_N_per_u * (all.x - rest.x);
    }
  }
  return all;
}

} // namespace palpate
