// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticToolShape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "vtkHapticTurnedSolid.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticToolShape);

namespace
{
constexpr double pi = std::numbers::pi;
constexpr double wall = 1.0;           // of the nut and of the block round a hole, in radii of the bore
constexpr double neck = 0.35;          // of a burr's shaft, in radii of its ball
constexpr double heightOfThread = 0.5; // in pitches
constexpr double mostCorners = 2e6;    // of a thread: some 4 million triangles

struct Sizes
{
  double Radius, Length, Clearance, Chamfer, Pitch;
};

vtkHapticRing Round(double radius, double height)
{
  return { height, [=](double) { return radius; } };
}

/// A regular polygon round a circle; the corners lie between the flats, of which one faces the angle 0.
vtkHapticRing Flats(int flats, double inner, double height)
{
  return { height, [=](double angle)
    {
      const double part = 2.0 * pi / flats;
      return inner / std::cos(angle - part * std::round(angle / part));
    } };
}

/// The thread: a triangular wave along the axis that goes once round it in a pitch.
vtkHapticRing Threaded(double radius, double pitch, double height)
{
  return { height, [=](double angle)
    {
      const double turns = height / pitch - angle / (2.0 * pi);
      const double wave = 2.0 * std::abs(turns - std::round(turns)); // 0 to 1
      return radius + heightOfThread * pitch * wave;
    } };
}

std::vector<vtkHapticRing> PegRings(const Sizes& s)
{
  std::vector<vtkHapticRing> rings;
  rings.push_back(Round(s.Radius - s.Chamfer, -s.Length));
  if (s.Chamfer > 0.0)
  {
    rings.push_back(Round(s.Radius, s.Chamfer - s.Length));
  }
  rings.push_back(Round(s.Radius, 0.0));
  return rings;
}

std::vector<vtkHapticRing> HoleRings(const Sizes& s)
{
  const double bore = s.Radius + s.Clearance, outer = (1.0 + wall) * bore + s.Chamfer;
  std::vector<vtkHapticRing> rings{ Flats(4, outer, -s.Length), Flats(4, outer, 0.0), Round(bore + s.Chamfer, 0.0) };
  if (s.Chamfer > 0.0)
  {
    rings.push_back(Round(bore, -s.Chamfer));
  }
  rings.push_back(Round(bore, -s.Length));
  return rings;
}

/// Rings along a thread, from below to the top.
std::vector<vtkHapticRing> ThreadRings(const Sizes& s, double radius, int around)
{
  const int steps = std::max(1, static_cast<int>(std::ceil(s.Length / s.Pitch * around)));
  std::vector<vtkHapticRing> rings;
  for (int i = steps; i >= 0; --i)
  {
    rings.push_back(Threaded(radius, s.Pitch, -s.Length * i / steps));
  }
  return rings;
}

std::vector<vtkHapticRing> NutRings(const Sizes& s, int around)
{
  const double bore = s.Radius + s.Clearance, outer = (1.0 + wall) * bore + heightOfThread * s.Pitch;
  std::vector<vtkHapticRing> rings = ThreadRings(s, bore, around);
  std::reverse(rings.begin(), rings.end()); // down inside, then up outside
  rings.push_back(Flats(6, outer, -s.Length));
  rings.push_back(Flats(6, outer, 0.0));
  return rings;
}

/// A ball at the end of a shaft.
std::vector<vtkHapticRing> BurrRings(const Sizes& s, int around)
{
  const double middle = s.Radius - s.Length, shaft = neck * s.Radius;
  const double last = pi - std::asin(neck); // where the shaft leaves the ball
  const int steps = std::max(3, around / 2);
  std::vector<vtkHapticRing> rings;
  for (int i = 1; i <= steps; ++i)
  {
    const double angle = last * i / steps;
    rings.push_back(Round(s.Radius * std::sin(angle), middle - s.Radius * std::cos(angle)));
  }
  rings.push_back(Round(shaft, 0.0));
  return rings;
}

/// Empty, or the reason why the shape cannot be made.
std::string Refuse(const Sizes& s, int shape, int around)
{
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!positive(s.Radius) || !positive(s.Length) || !positive(s.Clearance) || !positive(s.Pitch))
  {
    return "radius, length, clearance and pitch must be finite numbers above 0";
  }
  const bool chamfered = shape == vtkHapticToolShape::Peg || shape == vtkHapticToolShape::Hole;
  if (chamfered && !(s.Chamfer >= 0.0 && s.Chamfer < std::min(s.Radius, s.Length)))
  {
    return "the chamfer must be 0 or more, and less than radius and length";
  }
  if (shape == vtkHapticToolShape::Burr && !(s.Length > 2.0 * s.Radius))
  {
    return "a burr must be longer than its ball: use a length of more than twice the radius";
  }
  const bool threaded = shape == vtkHapticToolShape::Screw || shape == vtkHapticToolShape::Nut;
  return threaded && s.Length / s.Pitch * around * around > mostCorners
           ? "the thread has too many turns: use a larger pitch, a smaller length or a lower resolution"
           : "";
}
} // namespace

vtkHapticToolShape::vtkHapticToolShape()
{
  this->SetNumberOfInputPorts(0);
}

void vtkHapticToolShape::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << '\n';
  os << indent << "Radius: " << this->Radius << " u\n";
  os << indent << "Length: " << this->Length << " u\n";
  os << indent << "Clearance: " << this->Clearance << " u\n";
  os << indent << "Chamfer: " << this->Chamfer << " u\n";
  os << indent << "Pitch: " << this->Pitch << " u\n";
  os << indent << "Resolution: " << this->Resolution << '\n';
}

int vtkHapticToolShape::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  const Sizes sizes{ this->Radius, this->Length, this->Clearance, this->Chamfer, this->Pitch };
  const int around = 8 * this->Resolution; // corners of four flats are among them, and those of six nearly
  if (const std::string problem = Refuse(sizes, this->Shape, around); !problem.empty())
  {
    vtkErrorMacro("No shape was made: " << problem << ".");
    return 0;
  }
  const auto rings = this->Shape == Peg     ? PegRings(sizes)
                     : this->Shape == Hole  ? HoleRings(sizes)
                     : this->Shape == Screw ? ThreadRings(sizes, sizes.Radius, around)
                     : this->Shape == Nut   ? NutRings(sizes, around)
                                            : BurrRings(sizes, around);
  vtkHapticTurnSolid(rings, around, this->Shape == Hole || this->Shape == Nut, vtkPolyData::GetData(output));
  return 1;
}
