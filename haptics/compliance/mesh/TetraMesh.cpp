// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/mesh/TetraMesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "haptics/core/DisjointSets.h"

namespace palpate
{
namespace
{

using Face = std::array<std::uint32_t, 3>;

/// A face of a tetrahedron; `corners` sorted, so that two tetrahedra that share it have them alike.
struct OwnedFace
{
  Face corners;
  Face outward;
  std::uint32_t tetra;
};

/// Rounding error of a volume, as a share of the cube of its longest edge.
constexpr double flatShare = 1e-12;

double longestEdgeOf(const TetraMesh& mesh, const Tetra& t)
{
  double longest = 0.0;
  for (int a = 0; a < 4; ++a)
  {
    for (int b = a + 1; b < 4; ++b)
    {
      longest = std::max(longest, (mesh.vertices_W[t[a]] - mesh.vertices_W[t[b]]).norm());
    }
  }
  return longest;
}

Tetra sorted(Tetra t)
{
  std::sort(t.begin(), t.end());
  return t;
}

std::vector<OwnedFace> facesOf(const TetraMesh& mesh)
{
  std::vector<OwnedFace> faces;
  faces.reserve(4 * mesh.tetras.size());
  for (std::uint32_t i = 0; i < mesh.tetras.size(); ++i)
  {
    const Tetra& t = mesh.tetras[i];
    for (const Face& f :
      { Face{ t[1], t[2], t[3] }, Face{ t[0], t[3], t[2] }, Face{ t[0], t[1], t[3] }, Face{ t[0], t[2], t[1] } })
    {
      OwnedFace face{ f, f, i };
      std::sort(face.corners.begin(), face.corners.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(),
    [](const OwnedFace& a, const OwnedFace& b) { return std::tie(a.corners, a.tetra) < std::tie(b.corners, b.tetra); });
  return faces;
}

bool evenOrder(const Face& a, const Face& b)
{
  return (a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[2]) || (a[0] == b[2] && a[1] == b[0]);
}

std::string refuseCorners(const TetraMesh& mesh)
{
  for (std::size_t i = 0; i < mesh.tetras.size(); ++i)
  {
    for (const std::uint32_t v : mesh.tetras[i])
    {
      if (v >= mesh.vertices_W.size() || !mesh.vertices_W[v].allFinite())
      {
        return "tetrahedron " + std::to_string(i) + " has a vertex that is not finite: repair the mesh";
      }
    }
  }
  return {};
}

/// Leaves out flat and duplicated tetrahedra, and reverses those of the other orientation.
void keepSolid(CheckedTetras& out, const TetraMesh& raw)
{
  std::set<Tetra> known;
  for (std::uint32_t i = 0; i < raw.tetras.size(); ++i)
  {
    Tetra t = raw.tetras[i];
    const double volume = volumeOf(raw, t);
    if (std::abs(volume) <= flatShare * std::pow(longestEdgeOf(raw, t), 3))
    {
      ++out.report.flat;
    }
    else if (!known.insert(sorted(t)).second)
    {
      ++out.report.doubled;
    }
    else
    {
      if (volume < 0.0)
      {
        std::swap(t[2], t[3]);
        ++out.report.turned;
      }
      out.mesh.tetras.push_back(t);
      out.sourceTetra.push_back(i);
    }
  }
}

std::string refuseFolds(const TetraMesh& mesh)
{
  const std::vector<OwnedFace> faces = facesOf(mesh);
  for (std::size_t i = 1; i < faces.size(); ++i)
  {
    if (faces[i].corners != faces[i - 1].corners)
    {
      continue;
    }
    const bool third = i >= 2 && faces[i - 2].corners == faces[i].corners;
    if (third || evenOrder(faces[i].outward, faces[i - 1].outward))
    {
      return "tetrahedra " + std::to_string(faces[i - 1].tetra) + " and " + std::to_string(faces[i].tetra) +
             " overlap at their shared face (inverted): mesh the body again";
    }
  }
  return {};
}

/// Names each part by its first tetrahedron: two are connected where they share a face.
std::vector<std::uint32_t> partsOf(const TetraMesh& mesh)
{
  DisjointSets parts(mesh.tetras.size());
  const std::vector<OwnedFace> faces = facesOf(mesh);
  for (std::size_t i = 1; i < faces.size(); ++i)
  {
    if (faces[i].corners == faces[i - 1].corners)
    {
      parts.join(faces[i].tetra, faces[i - 1].tetra);
    }
  }
  return parts.all();
}

/// Motion that fixed vertices leave: none where three are not collinear.
enum class Hold
{
  None,
  Turns,
  Firm,
};

Hold holdOf(const TetraMesh& mesh, const std::set<std::uint32_t>& held)
{
  if (held.empty())
  {
    return Hold::None;
  }
  const Vec3& first = mesh.vertices_W[*held.begin()];
  Vec3 far = Vec3::Zero();
  for (const std::uint32_t v : held)
  {
    const Vec3 d = mesh.vertices_W[v] - first;
    far = d.squaredNorm() > far.squaredNorm() ? d : far;
  }
  for (const std::uint32_t v : held)
  {
    if (far.cross(mesh.vertices_W[v] - first).norm() > 1e-9 * far.squaredNorm())
    {
      return Hold::Firm;
    }
  }
  return Hold::Turns;
}

std::string keepHeld(CheckedTetras& out, const std::vector<bool>& fixed)
{
  const std::vector<std::uint32_t> part = partsOf(out.mesh);
  std::map<std::uint32_t, std::set<std::uint32_t>> held;
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    std::set<std::uint32_t>& vertices = held[part[i]];
    for (const std::uint32_t v : out.mesh.tetras[i])
    {
      if (fixed[v])
      {
        vertices.insert(v);
      }
    }
  }
  std::map<std::uint32_t, Hold> holds;
  for (const auto& [name, vertices] : held)
  {
    holds[name] = holdOf(out.mesh, vertices);
    if (holds[name] == Hold::Turns)
    {
      return "a part of the body can still rotate: fix at least three of its vertices that are not collinear";
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    if (holds[part[i]] == Hold::Firm)
    {
      out.mesh.tetras[kept] = out.mesh.tetras[i];
      out.sourceTetra[kept++] = out.sourceTetra[i];
    }
  }
  out.report.loose = part.size() - kept;
  out.mesh.tetras.resize(kept);
  out.sourceTetra.resize(kept);
  return kept > 0 ? "" : "the body has no fixed vertices: choose the part of the body that does not move";
}

void dropUnusedVertices(CheckedTetras& out, const TetraMesh& raw, const std::vector<bool>& fixed)
{
  constexpr std::uint32_t unused = ~0u;
  std::vector<std::uint32_t> number(raw.vertices_W.size(), unused);
  for (const Tetra& t : out.mesh.tetras)
  {
    for (const std::uint32_t v : t)
    {
      number[v] = 0;
    }
  }
  out.mesh.vertices_W.clear();
  for (std::uint32_t v = 0; v < number.size(); ++v)
  {
    if (number[v] != unused)
    {
      number[v] = static_cast<std::uint32_t>(out.mesh.vertices_W.size());
      out.mesh.vertices_W.push_back(raw.vertices_W[v]);
      out.sourceVertex.push_back(v);
      out.fixed.push_back(fixed[v]);
    }
  }
  for (Tetra& t : out.mesh.tetras)
  {
    for (std::uint32_t& v : t)
    {
      v = number[v];
    }
  }
}

} // namespace

double volumeOf(const TetraMesh& mesh, const Tetra& t)
{
  const Vec3& o = mesh.vertices_W[t[0]];
  return (mesh.vertices_W[t[1]] - o).cross(mesh.vertices_W[t[2]] - o).dot(mesh.vertices_W[t[3]] - o) / 6.0;
}

std::string TetraReport::summary() const
{
  std::ostringstream words;
  const auto say = [&words](std::size_t count, const char* what)
  {
    if (count > 0)
    {
      words << (words.tellp() > 0 ? ", " : "") << count << what;
    }
  };
  say(this->turned, " with reversed orientation");
  say(this->flat, " without volume removed");
  say(this->doubled, " duplicated, removed");
  say(this->loose, " without connection to a fixed vertex removed");
  return words.tellp() > 0 ? "tetrahedra: " + words.str() : "";
}

CheckedTetras checkTetras(const TetraMesh& raw, const std::vector<bool>& fixed)
{
  CheckedTetras out;
  out.refusal = raw.tetras.empty() ? "there are no tetrahedra" : refuseCorners(raw);
  if (!out.refusal.empty())
  {
    return out;
  }
  out.mesh.vertices_W = raw.vertices_W;
  keepSolid(out, raw);
  out.refusal = out.mesh.tetras.empty() ? "no tetrahedron has a volume" : refuseFolds(out.mesh);
  if (out.refusal.empty())
  {
    out.refusal = keepHeld(out, fixed);
  }
  if (out.refusal.empty())
  {
    dropUnusedVertices(out, raw, fixed);
  }
  return out;
}

std::vector<std::array<std::uint32_t, 3>> borderOf(const TetraMesh& mesh)
{
  std::vector<Face> border;
  const std::vector<OwnedFace> faces = facesOf(mesh);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const bool asBefore = i > 0 && faces[i].corners == faces[i - 1].corners;
    const bool asNext = i + 1 < faces.size() && faces[i].corners == faces[i + 1].corners;
    if (!asBefore && !asNext)
    {
      border.push_back(faces[i].outward);
    }
  }
  return border;
}

} // namespace palpate
