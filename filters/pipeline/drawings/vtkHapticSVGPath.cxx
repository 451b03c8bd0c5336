// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSVGPath.h"

#include <charconv>
#include <numbers>
#include <stdexcept>
#include <string>

namespace
{
using Point = vtkHapticPlaneLines::Point;
constexpr double RadPerDegree = std::numbers::pi / 180.0;

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Takes numbers and commands off a text; numbers may touch, as in "1-2.5.5".
class Scanner
{
public:
  explicit Scanner(std::string_view text) : Text(text) {}

  [[nodiscard]] bool AtEnd()
  {
    this->SkipBlanks();
    return this->At == this->Text.size();
  }

  [[nodiscard]] bool AtLetter() { return !this->AtEnd() && IsLetter(this->Text[this->At]); }

  [[nodiscard]] char TakeLetter() { return this->Text[this->At++]; }

  [[nodiscard]] std::string_view TakeName()
  {
    this->SkipBlanks();
    const std::size_t first = this->At;
    while (this->At < this->Text.size() && IsLetter(this->Text[this->At]))
    {
      ++this->At;
    }
    return this->Text.substr(first, this->At - first);
  }

  [[nodiscard]] bool Take(char c)
  {
    const bool there = !this->AtEnd() && this->Text[this->At] == c;
    this->At += there;
    return there;
  }

  [[nodiscard]] double TakeNumber()
  {
    this->SkipSeparator();
    std::size_t first = this->At;
    first += first < this->Text.size() && this->Text[first] == '+';
    const char* const begin = this->Text.data() + first;
    const char* const end = this->Text.data() + this->Text.size();
    const char* const digit = begin + (begin != end && *begin == '-' && first == this->At);
    double value = 0.0;
    const bool looksRight = digit != end && (IsDigit(*digit) || *digit == '.'); // not "inf", which from_chars takes
    const auto [stop, error] =
      looksRight ? std::from_chars(begin, end, value) : std::from_chars_result{ begin, std::errc::invalid_argument };
    if (error != std::errc())
    {
      throw this->Expected("a number");
    }
    this->At = static_cast<std::size_t>(stop - this->Text.data());
    return value;
  }

  /// Flags of an arc are one character, and the next number may follow at once.
  [[nodiscard]] bool TakeFlag()
  {
    this->SkipSeparator();
    const char c = this->At < this->Text.size() ? this->Text[this->At] : '\0';
    if (c != '0' && c != '1')
    {
      throw this->Expected("0 or 1");
    }
    ++this->At;
    return c == '1';
  }

  [[nodiscard]] std::runtime_error Expected(const char* what) const
  {
    return std::runtime_error(std::string("expected ") + what + " after " + std::to_string(this->At) + " characters");
  }

  void SkipSeparator()
  {
    this->SkipBlanks();
    if (this->At < this->Text.size() && this->Text[this->At] == ',')
    {
      ++this->At;
      this->SkipBlanks();
    }
  }

private:
  void SkipBlanks() { this->At = std::min(this->Text.find_first_not_of(" \t\r\n\f", this->At), this->Text.size()); }

  std::string_view Text;
  std::size_t At = 0;
};

double AngleOf(const Point& direction)
{
  return std::atan2(direction.y(), direction.x());
}

/// One path while it is read. Controls of curves are remembered for the smooth commands.
class PathReader
{
public:
  PathReader(std::string_view data, vtkHapticPlaneLines& lines) : In(data), Lines(lines) {}

  void Read()
  {
    char command = '\0';
    while (!this->In.AtEnd())
    {
      if (this->In.AtLetter())
      {
        command = this->In.TakeLetter();
      }
      else if (command == 'Z' || command == 'z' || command == '\0')
      {
        throw this->In.Expected("a command");
      }
      this->Do(command);
      command = command == 'M' ? 'L' : command == 'm' ? 'l' : command;
    }
  }

private:
  static constexpr bool IsRelative(char command) { return command >= 'a'; }
  [[nodiscard]] Point Here() const { return this->Started ? this->Lines.GetEnd() : Point(Point::Zero()); }

  Point TakePoint(bool relative)
  {
    const double x = this->In.TakeNumber();
    const double y = this->In.TakeNumber();
    return relative ? Point(this->Here() + Point(x, y)) : Point(x, y);
  }

  void Do(char command)
  {
    const bool relative = IsRelative(command);
    const char kind = static_cast<char>(relative ? command - 'a' + 'A' : command);
    if (kind != 'M' && !this->Started)
    {
      throw this->In.Expected("the command M first, found a text that ends");
    }
    this->Smooth = kind == 'C' || kind == 'S' ? this->LastKind == 'C' || this->LastKind == 'S'
                                              : this->LastKind == 'Q' || this->LastKind == 'T';
    switch (kind)
    {
      case 'M':
        this->Move(relative);
        break;
      case 'Z':
        this->Lines.Close();
        break;
      case 'L':
        this->Lines.LineTo(this->TakePoint(relative));
        break;
      case 'H':
        this->Lines.LineTo({ this->In.TakeNumber() + (relative ? this->Here().x() : 0.0), this->Here().y() });
        break;
      case 'V':
        this->Lines.LineTo({ this->Here().x(), this->In.TakeNumber() + (relative ? this->Here().y() : 0.0) });
        break;
      case 'C':
      case 'S':
        this->Cubic(relative, kind == 'S');
        break;
      case 'Q':
      case 'T':
        this->Quadratic(relative, kind == 'T');
        break;
      case 'A':
        this->Arc(relative);
        break;
      default:
        throw this->In.Expected("one of the path commands M L H V C S Q T A Z, found a text that ends");
    }
    this->LastKind = kind;
  }

  void Move(bool relative)
  {
    const Point p = this->TakePoint(relative);
    this->Lines.MoveTo(p);
    this->Started = true;
  }

  /// The last control mirrored at where the path is.
  [[nodiscard]] Point Mirrored() const
  {
    return this->Smooth ? Point(2.0 * this->Here() - this->Control) : this->Here();
  }

  void Cubic(bool relative, bool smooth)
  {
    const Point first = smooth ? this->Mirrored() : this->TakePoint(relative);
    const Point second = this->TakePoint(relative);
    const Point end = this->TakePoint(relative);
    this->Lines.CubicTo(first, second, end);
    this->Control = second;
  }

  void Quadratic(bool relative, bool smooth)
  {
    const Point control = smooth ? this->Mirrored() : this->TakePoint(relative);
    this->Lines.QuadraticTo(control, this->TakePoint(relative));
    this->Control = control;
  }

  /// From end points to a centre: section F.6 of the standard.
  void Arc(bool relative)
  {
    Point radii = { std::abs(this->In.TakeNumber()), 0.0 };
    radii.y() = std::abs(this->In.TakeNumber());
    const Eigen::Rotation2Dd turn(this->In.TakeNumber() * RadPerDegree);
    const bool large = this->In.TakeFlag(), positive = this->In.TakeFlag();
    const Point from = this->Here(), to = this->TakePoint(relative);
    const Point half = (turn.inverse() * Point(0.5 * (from - to))).cwiseQuotient(radii); // on the unit circle
    if (!half.allFinite() || from == to)
    {
      this->Lines.LineTo(to);
      return;
    }
    const double length = half.squaredNorm();
    const double grow = std::sqrt(std::max(1.0, length)); // radii too small to reach are made larger
    const double off = std::sqrt(std::max(0.0, 1.0 / length - 1.0)) * (large == positive ? -1.0 : 1.0);
    const Point center = length < 1.0 ? Point(off * half.y(), -off * half.x()) : Point(Point::Zero());
    this->Sweep(
      { .from = from, .to = to, .turn = turn, .radii = grow * radii, .half = half / grow, .center = center }, positive);
  }

  struct UnitArc
  {
    Point from, to;
    Eigen::Rotation2Dd turn;
    Point radii;
    Point half;   ///< from half way between the ends to the first, on the unit circle
    Point center; ///< from half way between the ends, on the unit circle
  };

  void Sweep(const UnitArc& arc, bool positive)
  {
    const double first = AngleOf(arc.half - arc.center);
    double sweep = AngleOf(-arc.half - arc.center) - first;
    if (positive && sweep < 0.0)
    {
      sweep += 2.0 * std::numbers::pi;
    }
    else if (!positive && sweep > 0.0)
    {
      sweep -= 2.0 * std::numbers::pi;
    }
    const Eigen::Matrix2d axes = arc.turn.toRotationMatrix() * arc.radii.asDiagonal();
    this->Lines.ArcTo(0.5 * (arc.from + arc.to) + axes * arc.center, axes, first, sweep, arc.to);
  }

  Scanner In;
  vtkHapticPlaneLines& Lines;
  bool Started = false;
  bool Smooth = false;
  char LastKind = '\0';
  Point Control = Point::Zero();
};

std::vector<double> TakeArguments(Scanner& in)
{
  std::vector<double> values;
  if (!in.Take('('))
  {
    throw in.Expected("'('");
  }
  while (!in.Take(')'))
  {
    values.push_back(in.TakeNumber());
  }
  return values;
}

Eigen::Affine2d TransformOf(std::string_view name, const std::vector<double>& v, const Scanner& in)
{
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6)
  {
    map.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0.0, 0.0, 1.0;
  }
  else if (name == "translate" && (n == 1 || n == 2))
  {
    map.translation() = Point(v[0], n == 2 ? v[1] : 0.0);
  }
  else if (name == "scale" && (n == 1 || n == 2))
  {
    map.linear() = Point(v[0], v[n - 1]).asDiagonal();
  }
  else if (name == "rotate" && (n == 1 || n == 3))
  {
    const Point center = n == 3 ? Point(v[1], v[2]) : Point(Point::Zero());
    map = Eigen::Translation2d(center) * Eigen::Rotation2Dd(v[0] * RadPerDegree) * Eigen::Translation2d(-center);
  }
  else if ((name == "skewX" || name == "skewY") && n == 1)
  {
    map.linear()(name == "skewX" ? 0 : 1, name == "skewX" ? 1 : 0) = std::tan(v[0] * RadPerDegree);
  }
  else
  {
    throw in.Expected("matrix, translate, scale, rotate, skewX or skewY with numbers, found a text that ends");
  }
  return map;
}
} // namespace

namespace vtkHapticSVGPath
{
void Append(std::string_view data, vtkHapticPlaneLines& lines)
{
  PathReader(data, lines).Read();
}

std::vector<double> ParseNumbers(std::string_view text)
{
  Scanner in(text);
  std::vector<double> values;
  while (!in.AtEnd())
  {
    values.push_back(in.TakeNumber());
  }
  return values;
}

std::vector<Point> ParsePoints(std::string_view text)
{
  const std::vector<double> values = ParseNumbers(text);
  if (values.size() % 2 != 0)
  {
    throw std::runtime_error("a point lacks its second number");
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < values.size(); i += 2)
  {
    points.emplace_back(values[i], values[i + 1]);
  }
  return points;
}

Eigen::Affine2d ParseTransform(std::string_view text)
{
  Scanner in(text);
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  while (!in.AtEnd())
  {
    in.SkipSeparator();
    const std::string_view name = in.TakeName();
    map = map * TransformOf(name, TakeArguments(in), in);
  }
  return map;
}
} // namespace vtkHapticSVGPath
