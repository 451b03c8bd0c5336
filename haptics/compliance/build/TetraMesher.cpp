// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/build/TetraMesher.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using LabelAt = std::function<int(const Vec3& p_W)>;

struct Cancelled
{
};

/// More tetrahedra arise than volume and edge length predict.
struct TooMany
{
};

/// Queries of the label at a point, per tetrahedron, during refinement.
constexpr double questionsOfTetra = 50.0;

/// The region to be filled.
struct Filled
{
  LabelAt labelAt;
  Vec3 low_W = Vec3::Zero();
  Vec3 high_W = Vec3::Zero();
  double volume_u3 = 0.0;
};

/// Counts the queries, which are the only measure of the progress of the refinement.
class WatchedLabel
{
public:
  WatchedLabel(const Filled& filled, double expected, double most, const Goes& goes)
    : labelAt_(filled.labelAt), expected_(expected), most_(most), goes_(goes)
  {
  }

  int operator()(const Kernel::Point_3& p)
  {
    // Near the end the refinement goes on for as long as the worst tetrahedra need: the share only approaches 1.
    const auto asked = static_cast<double>(++this->asked_);
    if (this->asked_ % 1024 == 0 && !this->goes_(asked / (asked + this->expected_)))
    {
      throw Cancelled();
    }
    if (asked > this->most_)
    {
      throw TooMany();
    }
    return this->labelAt_(Vec3(p.x(), p.y(), p.z()));
  }

private:
  const LabelAt& labelAt_;
  double expected_;
  double most_;
  std::size_t asked_ = 0;
  const Goes& goes_;
};

double tetrasExpected(const Filled& filled, const TetraSizes& sizes)
{
  // A regular tetrahedron has a volume of .118 of its edge's cube; refined ones are smaller than the allowed size.
  return filled.volume_u3 / (0.06 * std::pow(sizes.edge_u, 3));
}

TetraMeshResult tetrasOf(const Complex& complex)
{
  TetraMeshResult result;
  std::map<Triangulation::Vertex_handle, std::uint32_t> numbers;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
  {
    Tetra t{};
    for (int i = 0; i < 4; ++i)
    {
      const auto next = static_cast<std::uint32_t>(result.mesh.vertices_W.size());
      const auto [known, fresh] = numbers.try_emplace(cell->vertex(i), next);
      t[i] = known->second;
      if (fresh)
      {
        const auto& p = cell->vertex(i)->point();
        result.mesh.vertices_W.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      }
    }
    result.mesh.tetras.push_back(t);
    result.labels.push_back(static_cast<std::uint32_t>(complex.subdomain_index(cell)));
  }
  return result;
}

std::string refuseSizes(const Filled& filled, const TetraSizes& sizes)
{
  if (!(sizes.edge_u > 0.0) || !(sizes.distance_u > 0.0))
  {
    return "edge length and distance of the tetrahedra must be above 0";
  }
  // Doubles cannot bisect a segment across the border often enough for less.
  if (const double least_u = 1e-7 * (filled.high_W - filled.low_W).norm(); sizes.distance_u < least_u)
  {
    std::ostringstream words;
    words << "a distance of " << sizes.distance_u << " is too short: use at least " << least_u;
    return words.str();
  }
  if (const double expected = tetrasExpected(filled, sizes); expected > static_cast<double>(sizes.most))
  {
    return "about " + std::to_string(static_cast<std::size_t>(expected)) + " tetrahedra would be made, more than the " +
           std::to_string(sizes.most) + " allowed: use a longer edge";
  }
  return {};
}

TetraMeshResult fill(const Filled& filled, const TetraSizes& sizes, const Goes& goes)
{
  TetraMeshResult result;
  result.refusal = refuseSizes(filled, sizes);
  if (!result.refusal.empty())
  {
    return result;
  }
  const double expected = questionsOfTetra * tetrasExpected(filled, sizes);
  const double most = 4.0 * questionsOfTetra * static_cast<double>(sizes.most);
  const auto watched = std::make_shared<WatchedLabel>(filled, expected, most, goes);
  const auto labelAt = [watched](const Kernel::Point_3& p) { return (*watched)(p); };
  const CGAL::Bbox_3 box(
    filled.low_W.x(), filled.low_W.y(), filled.low_W.z(), filled.high_W.x(), filled.high_W.y(), filled.high_W.z());
  const double diagonal = (filled.high_W - filled.low_W).norm();
  CGAL::Random random(1); // the same tetrahedra each time
  namespace p = CGAL::parameters;
  try
  {
    const Domain domain(p::function = labelAt, p::bounding_object = box,
      p::relative_error_bound = std::min(0.02 * sizes.distance_u / diagonal, 1e-3), p::p_rng = &random);
    const Criteria criteria(p::facet_angle = 25, p::facet_size = sizes.edge_u, p::facet_distance = sizes.distance_u,
      p::cell_radius_edge_ratio = 2, p::cell_size = sizes.edge_u);
    const Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, p::no_perturb(), p::no_exude());
    result = tetrasOf(complex);
  }
  catch (const Cancelled&)
  {
    result.refusal = "cancelled";
  }
  catch (const TooMany&)
  {
    result.refusal = "far more than the " + std::to_string(sizes.most) +
                     " tetrahedra allowed arise near the surface: use a larger distance";
  }
  catch (const std::exception& e) // exceptions of CGAL, and lack of memory
  {
    result.refusal = std::string("CGAL could not mesh the body: ") + e.what();
  }
  if (!result.refusal.empty())
  {
    result.mesh = {};
    return result;
  }
  if (result.mesh.tetras.empty())
  {
    result.refusal = "the mesher made no tetrahedra: use a shorter edge";
  }
  return result;
}

/// Proven bound of the distance between the border and the surface, both ways; infinity: more than 16 times the
/// distance asked for, as where a sharp rib is rounded off.
double boundOf(const TetraMesh& mesh, const SurfaceTree& surface, double asked_u)
{
  const SurfaceTree border(cleanMesh({ mesh.vertices_W, borderOf(mesh) }).mesh);
  const auto within = [](const SurfaceTree& from, const SurfaceTree& to, double limit_u)
  { return proveWithin(from, to, limit_u).verdict == DistanceProof::Verdict::Within; };
  for (double limit_u = asked_u; limit_u < 17.0 * asked_u; limit_u *= 2.0)
  {
    if (within(border, surface, limit_u) && within(surface, border, limit_u))
    {
      return limit_u;
    }
  }
  return std::numeric_limits<double>::infinity();
}

double volumeInside(const SurfaceTree& surface, const Vec3& low_W, const Vec3& size_u)
{
  // Triangles of a cleaned mesh have lost their orientation: points of a lattice are tested.
  constexpr int lattice = 12;
  int inside = 0;
  for (int i = 0; i < lattice * lattice * lattice; ++i)
  {
    const Vec3 share(i % lattice + 0.5, i / lattice % lattice + 0.5, i / lattice / lattice + 0.5);
    inside += sideOf(surface, low_W + share.cwiseProduct(size_u) / lattice) == PointSide::Inside;
  }
  return size_u.prod() * std::max(inside, 1) / (lattice * lattice * lattice);
}

std::uint32_t labelOf(const LabelImage& image, const Vec3& p_W)
{
  const Vec3 place = (p_W - image.first_W).cwiseQuotient(image.step_u);
  std::array<int, 3> at{};
  for (int axis = 0; axis < 3; ++axis)
  {
    at[axis] = static_cast<int>(std::floor(place[axis] + 0.5));
    if (at[axis] < 0 || at[axis] >= image.counts[axis])
    {
      return 0;
    }
  }
  return image.labels[(static_cast<std::size_t>(at[2]) * image.counts[1] + at[1]) * image.counts[0] + at[0]];
}

} // namespace

TetraMeshResult meshInside(const SurfaceTree& closed, const TetraSizes& sizes, const Goes& goes)
{
  if (!isClosed(closed))
  {
    return { {}, {}, 0.0, "the surface has holes: close the surface, or use tetrahedra" };
  }
  const SurfaceData& data = closed.data();
  const Vec3 size_u = data.high_W - data.low_W;
  Filled filled;
  filled.labelAt = [&closed](const Vec3& p_W) { return sideOf(closed, p_W) == PointSide::Inside ? 1 : 0; };
  filled.low_W = data.low_W - 0.05 * size_u;
  filled.high_W = data.high_W + 0.05 * size_u;
  filled.volume_u3 = volumeInside(closed, data.low_W, size_u);
  TetraMeshResult result = fill(filled, sizes, goes);
  result.bound_u = result.refusal.empty() ? boundOf(result.mesh, closed, sizes.distance_u) : 0.0;
  return result;
}

TetraMeshResult meshLabels(const LabelImage& image, const TetraSizes& sizes, const Goes& goes)
{
  const std::size_t boxes = static_cast<std::size_t>(image.counts[0]) * image.counts[1] * image.counts[2];
  if (boxes == 0 || image.labels.size() != boxes || !(image.step_u.minCoeff() > 0.0))
  {
    return { {}, {}, 0.0, "the label image has no voxels, or not one value per voxel" };
  }
  const auto labelled = boxes - static_cast<std::size_t>(std::count(image.labels.begin(), image.labels.end(), 0u));
  if (labelled == 0)
  {
    return { {}, {}, 0.0, "the label image has no labels: all values are 0" };
  }
  Filled filled;
  filled.labelAt = [&image](const Vec3& p_W) { return static_cast<int>(labelOf(image, p_W)); };
  filled.low_W = image.first_W - image.step_u;
  filled.high_W = image.first_W + image.step_u.cwiseProduct(Vec3(image.counts[0], image.counts[1], image.counts[2]));
  filled.volume_u3 = static_cast<double>(labelled) * image.step_u.prod();
  return fill(filled, sizes, goes);
}

} // namespace palpate
