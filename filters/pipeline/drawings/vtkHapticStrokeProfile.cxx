// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticStrokeProfile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr double Nothing = -std::numeric_limits<double>::infinity();

/// A point of the cut: place and height.
struct ProfilePoint
{
  double S = 0.0;
  double H = 0.0;
};

/// Where one triangle meets the plane: none, or a segment (a point counts as one).
struct Piece
{
  std::array<ProfilePoint, 4> End;
  int Count = 0;
};

/// Vertices in the frame of the cut; Side is the distance from the plane.
struct Corner
{
  ProfilePoint In;
  double Side = 0.0;
};

Piece CutTriangle(const std::array<Corner, 3>& corner)
{
  Piece piece;
  for (int k = 0; k < 3; ++k)
  {
    const Corner& a = corner[k];
    const Corner& b = corner[(k + 1) % 3];
    if (a.Side == 0.0)
    {
      piece.End[piece.Count++] = a.In;
    }
    else if (b.Side != 0.0 && (a.Side < 0.0) != (b.Side < 0.0))
    {
      const double t = a.Side / (a.Side - b.Side);
      piece.End[piece.Count++] = { a.In.S + t * (b.In.S - a.In.S), a.In.H + t * (b.In.H - a.In.H) };
    }
  }
  return piece;
}

std::vector<Corner> CornersOf(const palpate::TriangleMesh& mesh, const vtkHapticCutFrame& frame)
{
  const palpate::Vec3 normal_W = frame.Along_W.cross(frame.Up_W);
  std::vector<Corner> corners;
  corners.reserve(mesh.vertices_W.size());
  for (const palpate::Vec3& p_W : mesh.vertices_W)
  {
    const palpate::Vec3 d_W = p_W - frame.Origin_W;
    corners.push_back({ { d_W.dot(frame.Along_W), d_W.dot(frame.Up_W) }, d_W.dot(normal_W) });
  }
  return corners;
}

std::vector<Piece> CutMesh(const palpate::TriangleMesh& mesh, const vtkHapticCutFrame& frame)
{
  const std::vector<Corner> corners = CornersOf(mesh, frame);
  std::vector<Piece> pieces;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Piece piece = CutTriangle({ corners[a], corners[b], corners[c] });
    if (piece.Count >= 2 && std::all_of(piece.End.begin(), piece.End.begin() + piece.Count,
                              [](const ProfilePoint& p) { return std::isfinite(p.S) && std::isfinite(p.H); }))
    {
      pieces.push_back(piece);
    }
  }
  return pieces;
}

/// Raises the profile to the segment from p to q.
void Raise(vtkHapticHeights& profile, ProfilePoint p, ProfilePoint q)
{
  if (q.S < p.S)
  {
    std::swap(p, q);
  }
  const double last = static_cast<double>(profile.Height.size()) - 1.0;
  const double from = std::max(0.0, std::ceil((p.S - profile.First) / profile.Step));
  const double to = std::min(last, std::floor((q.S - profile.First) / profile.Step));
  for (double place = from; place <= to; place += 1.0)
  {
    const auto i = static_cast<std::size_t>(place);
    const double t = q.S > p.S ? (profile.At(i) - p.S) / (q.S - p.S) : 0.0;
    const double height = q.S > p.S ? p.H + t * (q.H - p.H) : std::max(p.H, q.H);
    profile.Height[i] = std::max(profile.Height[i], height);
  }
}
} // namespace

std::optional<vtkHapticHeights> vtkHapticCutProfile(
  const palpate::TriangleMesh& mesh, const vtkHapticCutFrame& frame, double step, std::size_t most)
{
  const std::vector<Piece> pieces = CutMesh(mesh, frame);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Piece& piece : pieces)
  {
    for (int k = 0; k < piece.Count; ++k)
    {
      low = std::min(low, piece.End[k].S);
      high = std::max(high, piece.End[k].S);
    }
  }
  const double places = std::floor((high - low) / step) + 1.0;
  if (pieces.empty() || !(places <= static_cast<double>(most)))
  {
    return std::nullopt;
  }
  vtkHapticHeights profile{ low, step, std::vector<double>(static_cast<std::size_t>(places), Nothing) };
  for (const Piece& piece : pieces)
  {
    for (int k = 0; k < piece.Count; ++k)
    {
      Raise(profile, piece.End[k], piece.End[(k + 1) % piece.Count]);
    }
  }
  return profile;
}

vtkHapticHeights vtkHapticLongestRun(const vtkHapticHeights& profile, double cliff)
{
  const std::vector<double>& height = profile.Height;
  std::size_t bestFirst = 0;
  std::size_t bestCount = 0;
  for (std::size_t first = 0; first < height.size();)
  {
    std::size_t end = first + 1;
    while (end < height.size() && height[first] != Nothing && std::abs(height[end] - height[end - 1]) <= cliff)
    {
      ++end;
    }
    if (height[first] != Nothing && end - first > bestCount)
    {
      bestFirst = first;
      bestCount = end - first;
    }
    first = end;
  }
  const auto begin = height.begin() + static_cast<std::ptrdiff_t>(bestFirst);
  return { profile.At(bestFirst), profile.Step, { begin, begin + static_cast<std::ptrdiff_t>(bestCount) } };
}

vtkHapticHeights vtkHapticMiddle(const vtkHapticHeights& profile, double reach)
{
  const std::size_t count = profile.Height.size();
  const auto kept = static_cast<std::size_t>(std::ceil(reach * static_cast<double>(count)));
  const std::size_t skipped = (count - kept) / 2;
  const auto begin = profile.Height.begin() + static_cast<std::ptrdiff_t>(skipped);
  return { profile.At(skipped), profile.Step, { begin, begin + static_cast<std::ptrdiff_t>(kept) } };
}

std::vector<double> vtkHapticSmoothBelow(const std::vector<double>& heights, std::size_t half)
{
  const auto around = [&](const std::vector<double>& values, auto combine)
  {
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i - std::min(i, half));
      const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(values.size(), i + half + 1));
      result[i] = combine(begin, end);
    }
    return result;
  };
  using Iterator = std::vector<double>::const_iterator;
  const auto least = [](Iterator begin, Iterator end) { return *std::min_element(begin, end); };
  const auto mean = [](Iterator begin, Iterator end)
  {
    double sum = 0.0;
    std::for_each(begin, end, [&sum](double x) { sum += x; });
    return sum / static_cast<double>(end - begin);
  };
  return around(around(heights, least), mean);
}
