// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPlaneLines_h
#define vtkHapticPlaneLines_h

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

/// Poly-lines of the plane that grow as a drawing is read; curves become chords that are nowhere farther off than a
/// tolerance. Every point is given in the drawing's own coordinates and kept in those of the plane [u].
class vtkHapticPlaneLines
{
public:
  using Point = Eigen::Vector2d;
  using Line = std::vector<Point>;

  /// More than a hand can feel, and a bound for the memory that a few bytes may need.
  static constexpr std::size_t MostPoints = 10'000'000;
  /// Of one curve: it would be thousands of times as large as its drawing.
  static constexpr double MostChords = 1e5;

  void SetMap(const Eigen::Affine2d& toPlane)
  {
    this->ToPlane = toPlane;
    const Eigen::Matrix2d& m = toPlane.linear();
    this->Stretch = 0.5 * (std::hypot(m(0, 0) + m(1, 1), m(1, 0) - m(0, 1)) + // the larger singular value
                            std::hypot(m(0, 0) - m(1, 1), m(1, 0) + m(0, 1)));
  }
  void SetTolerance(double tolerance) { this->Tolerance = tolerance; }

  void MoveTo(const Point& p)
  {
    this->Lines.emplace_back();
    this->Begin = p;
    this->LineTo(p);
  }

  void LineTo(const Point& p)
  {
    const Point mapped = this->ToPlane * p;
    // Beyond this, squares of lengths would overflow and differences of neighbours be lost.
    if (!(mapped.cwiseAbs().maxCoeff() < 1e100))
    {
      throw std::runtime_error("a coordinate is out of range");
    }
    this->End = p;
    Line& line = this->Lines.back();
    if (!line.empty() && line.back() == mapped)
    {
      return;
    }
    if (++this->Count > MostPoints)
    {
      throw std::runtime_error("it has more than 10 million points; simplify it first");
    }
    line.push_back(mapped);
  }

  /// Back to the start of the line; a command without a move begins there again.
  void Close()
  {
    if (this->Lines.back().size() > 1)
    {
      this->LineTo(this->Begin);
    }
    this->MoveTo(this->Begin);
  }

  void CubicTo(const Point& b, const Point& c, const Point& d)
  {
    const Point a = this->End;
    // A chord of a curve over a parameter step h is off by at most |x''| h^2 / 8.
    const double bend = 6.0 * std::max((a - 2.0 * b + c).norm(), (b - 2.0 * c + d).norm());
    this->Chords(this->StepsFor(bend),
      [&](double t)
      {
        const double s = 1.0 - t;
        return Point(s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d);
      });
  }

  void QuadraticTo(const Point& b, const Point& c)
  {
    const Point a = this->End;
    this->Chords(this->StepsFor(2.0 * (a - 2.0 * b + c).norm()),
      [&](double t)
      {
        const double s = 1.0 - t;
        return Point(s * s * a + 2.0 * s * t * b + t * t * c);
      });
  }

  /// Along center + axes (cos w, sin w) for w from `from` over `sweep` [rad], to `end`, which rounding may miss.
  void ArcTo(const Point& center, const Eigen::Matrix2d& axes, double from, double sweep, const Point& end)
  {
    const std::size_t even = (this->StepsFor(axes.norm() * sweep * sweep) + 1) / 2 * 2; // keeps a whole turn's middle
    this->Chords(even,
      [&](double t)
      {
        const double w = from + t * sweep;
        return t < 1.0 ? Point(center + axes * Point(std::cos(w), std::sin(w))) : end;
      });
  }

  /// Where the line has come to, in the drawing's coordinates; there must be one.
  [[nodiscard]] const Point& GetEnd() const { return this->End; }
  /// All lines of two points or more; the rest is left out.
  [[nodiscard]] std::vector<Line> Take()
  {
    std::erase_if(this->Lines, [](const Line& line) { return line.size() < 2; });
    this->Count = 0;
    return std::move(this->Lines);
  }

private:
  [[nodiscard]] std::size_t StepsFor(double secondDerivative) const
  {
    const double steps = std::ceil(std::sqrt(this->Stretch * secondDerivative / (8.0 * this->Tolerance)));
    if (!(steps <= MostChords))
    {
      throw std::runtime_error("a curve is out of range");
    }
    return steps < 1.0 ? 1 : static_cast<std::size_t>(steps);
  }

  template<class Curve>
  void Chords(std::size_t steps, const Curve& at)
  {
    for (std::size_t i = 1; i <= steps; ++i)
    {
      this->LineTo(at(static_cast<double>(i) / static_cast<double>(steps)));
    }
  }

  Eigen::Affine2d ToPlane = Eigen::Affine2d::Identity();
  double Stretch = 1.0; // the map makes nothing longer than so many times
  double Tolerance = 1.0;
  std::vector<Line> Lines;
  std::size_t Count = 0;
  Point Begin = Point::Zero();
  Point End = Point::Zero();
};

#endif
