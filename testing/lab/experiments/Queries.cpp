// SPDX-License-Identifier: GPL-3.0-or-later
// Charts C9: which libraries answer a collision query rightly, and the cost of an answer.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "testing/lab/Experiments.h"
#include "testing/lab/backends/Backend.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Random.h"

namespace palpate::lab
{
namespace queries_experiment
{

struct Segment
{
  Vec3 from_W, to_W;
};

using Segments = std::vector<Segment>;

/// Short segments near the surface in any direction, as between two ticks: about half of them meet it.
Segments nearSurface(const test::NoisySphere& sphere, std::size_t count, test::Random& random)
{
  Segments segments;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 up = random.direction();
    const Vec3 middle_W = up * (sphere.surfaceRadius_u(up) + random.uniform(-1.0, 1.0));
    const Vec3 half = random.direction() * random.uniform(0.05, 1.0);
    segments.push_back({ middle_W - half, middle_W + half });
  }
  return segments;
}

/// Pushes into the surface right through a vertex or the middle of an edge. The surface is closed, so each of them
/// meets it, whatever is rounded: an answer "free" is a hole between neighbouring triangles.
Segments throughSeams(const test::NoisySphere& sphere, std::size_t count, test::Random& random)
{
  const TriangleMesh& mesh = sphere.mesh();
  Segments segments;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& t = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
    const Vec3& a = mesh.vertices_W[t[0]];
    const Vec3 seam_W = i % 2 == 0 ? a : Vec3(0.5 * (a + mesh.vertices_W[t[1]]));
    segments.push_back({ seam_W + 2.0 * seam_W.normalized(), seam_W - 2.0 * seam_W.normalized() });
  }
  return segments;
}

/// Segments from outside that end `short_u` before a vertex. With 0 the closed segment meets the surface in its last
/// point and nowhere else; with more it is free.
Segments ontoVertices(const test::NoisySphere& sphere, double short_u, std::size_t count, test::Random& random)
{
  const TriangleMesh& mesh = sphere.mesh();
  Segments segments;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3& v = mesh.vertices_W[random.below(static_cast<std::uint32_t>(mesh.vertices_W.size()))];
    segments.push_back({ v + 2.0 * v.normalized(), v + short_u * v.normalized() });
  }
  return segments;
}

Segments shifted(Segments segments, const Vec3& by_W)
{
  for (Segment& s : segments)
  {
    s = { s.from_W + by_W, s.to_W + by_W };
  }
  return segments;
}

std::vector<char> answers(Backend& backend, const Segments& segments)
{
  std::vector<char> met;
  for (const Segment& s : segments)
  {
    met.push_back(backend.meets(s.from_W, s.to_W));
  }
  return met;
}

Cost costOf(Backend& backend, const Segments& segments)
{
  test::CostSample sample(segments.size());
  int met = 0;
  for (const Segment& s : segments)
  {
    sample.time([&] { met += backend.meets(s.from_W, s.to_W); });
  }
  return Cost::of(sample);
}

Cost distanceCost(Backend& backend, const Segments& segments)
{
  test::CostSample sample(segments.size());
  double sum_u = 0.0;
  for (const Segment& s : segments)
  {
    sample.time([&] { sum_u += *backend.distance_u(s.from_W); });
  }
  return Cost::of(sample);
}

double countDifferent(const std::vector<char>& a, const std::vector<char>& b)
{
  double count = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    count += a[i] != b[i];
  }
  return count;
}

/// How many answers depend on where coordinates are rounded to: those that change when the segment is moved, or made
/// longer or shorter, by `step_u`. A library that computes that coarsely may be wrong there and nowhere else.
double countUndecided(Backend& exact, const Segments& segments, const std::vector<char>& truth, double step_u)
{
  std::vector<char> changes(segments.size(), 0);
  const std::vector<char> same(segments.size(), 0);
  for (const Vec3& axis : { Vec3::UnitX().eval(), Vec3::UnitY().eval(), Vec3::UnitZ().eval(), Vec3::Zero().eval() })
  {
    for (const double step : { step_u, -step_u })
    {
      for (std::size_t i = 0; i < segments.size(); ++i)
      {
        const Segment& s = segments[i];
        const Vec3 longer = axis.isZero() ? Vec3(step * (s.to_W - s.from_W).normalized()) : Vec3(Vec3::Zero());
        const bool met = exact.meets(s.from_W + step * axis - longer, s.to_W + step * axis + longer);
        changes[i] |= static_cast<char>(met != (truth[i] != 0));
      }
    }
  }
  return countDifferent(changes, same);
}

/// Rounding error of a few operations in a library's arithmetic on a coordinate of size 1. (Times are doubles also
/// where the decision is exact.)
double rounding(Arithmetic arithmetic)
{
  return 32.0 * std::ldexp(1.0, arithmetic == Arithmetic::Single ? -24 : -53);
}

/// A kind of query, and where theory says that an arithmetic fails.
struct Question
{
  std::string query;
  Segments segments;
  std::optional<Arithmetic> failing = std::nullopt;
  double failures = 0.0; ///< at least so many, of every library with that arithmetic
};

/// All libraries and the oracle on one mesh.
class Panel
{
public:
  Panel(const TriangleMesh& mesh, Table& table)
    : triangles_(static_cast<double>(mesh.triangles.size())), table_(table), oracle_(makeExact(mesh)),
      bruteForce_(makeBruteForce(mesh))
  {
    for (const Vec3& v : mesh.vertices_W)
    {
      this->largest_u_ = std::max(this->largest_u_, v.cwiseAbs().maxCoeff());
    }
    for (const BackendKind& kind : backendKinds())
    {
      this->backends_.push_back(kind.make != nullptr ? kind.make(mesh) : nullptr);
    }
  }

  /// One row for each library, with its cost.
  void judgeAnswers(const Question& question)
  {
    const std::vector<char> truth = answers(*this->oracle_, question.segments);
    this->forEach(question.query, "disagreements", "",
      [&](const BackendKind& kind, const Subject& subject, Backend& backend)
      {
        const double wrong = countDifferent(answers(backend, question.segments), truth);
        Row& row = kind.arithmetic == question.failing
                     ? this->table_.atLeast(subject, wrong, question.failures)
                     : this->table_.atMost(subject, wrong, this->mayBeWrong(kind.arithmetic, question.segments, truth));
        row.cost = costOf(backend, question.segments);
      });
  }

  /// The points of first hits lie on the surface as well as the library's numbers can say it.
  void judgeHits(const Question& question)
  {
    this->forEach(question.query, "first hit off the surface", "mm",
      [&](const BackendKind& kind, const Subject& subject, Backend& backend)
      {
        double furthest_u = 0.0;
        for (const Segment& s : question.segments)
        {
          if (const std::optional<double> t = backend.firstHit(s.from_W, s.to_W))
          {
            furthest_u = std::max(furthest_u, *this->oracle_->distance_u(s.from_W + *t * (s.to_W - s.from_W)));
          }
        }
        this->table_.atMost(subject, furthest_u, rounding(kind.arithmetic) * this->largest_u_);
      });
  }

  /// Distances to the surface, of the libraries that offer them, against all triangles one by one.
  void judgeDistances(const Segments& segments)
  {
    this->forEach("distance", "distance error", "mm",
      [&](const BackendKind& kind, const Subject& subject, Backend& backend)
      {
        if (backend.distance_u(segments[0].from_W))
        {
          const double error_u = this->distanceError_u(backend, segments);
          this->table_.atMost(subject, error_u, rounding(kind.arithmetic) * this->largest_u_).cost =
            distanceCost(backend, segments);
        }
      });
  }

  /// The oracle itself, on a few of the segments, against all triangles one by one.
  void judgeOracle(const Question& question)
  {
    const Segments few(question.segments.begin(), question.segments.begin() + judgedByForce);
    const double wrong = countDifferent(answers(*this->oracle_, few), answers(*this->bruteForce_, few));
    this->table_.atMost({ this->caseOf(question.query), "oracle", "disagreements with every triangle" }, wrong, 0.0);
  }

private:
  static constexpr int judgedByForce = 25;

  [[nodiscard]] std::string caseOf(const std::string& query) const
  {
    return caseName({ { "triangles", this->triangles_ } }) + " query=" + query;
  }

  template<class Judge>
  void forEach(const std::string& query, const char* quantity, const char* unit, Judge judge)
  {
    const std::vector<BackendKind> kinds = backendKinds();
    for (std::size_t i = 0; i < kinds.size(); ++i)
    {
      const Subject subject{ this->caseOf(query), kinds[i].name, quantity, unit };
      if (this->backends_[i] == nullptr)
      {
        this->table_.absent(subject);
      }
      else
      {
        judge(kinds[i], subject, *this->backends_[i]);
      }
    }
  }

  /// Exact: never. Else: where the answer depends on its rounding.
  [[nodiscard]] double mayBeWrong(Arithmetic arithmetic, const Segments& segments, const std::vector<char>& truth)
  {
    return arithmetic == Arithmetic::Exact
             ? 0.0
             : countUndecided(*this->oracle_, segments, truth, rounding(arithmetic) * this->largest_u_);
  }

  [[nodiscard]] double distanceError_u(Backend& backend, const Segments& segments)
  {
    double largest_u = 0.0;
    for (std::size_t i = 0; i < judgedByForce; ++i)
    {
      const double truth_u = *this->bruteForce_->distance_u(segments[i].from_W);
      largest_u = std::max(largest_u, std::abs(*backend.distance_u(segments[i].from_W) - truth_u));
    }
    return largest_u;
  }

  double triangles_;
  double largest_u_ = 0.0; ///< coordinate
  Table& table_;
  std::unique_ptr<Backend> oracle_, bruteForce_;
  std::vector<std::unique_ptr<Backend>> backends_; ///< as backendKinds(); null: not there
};

/// Queries of a short segment, of one through a seam and of one that just ends at a vertex.
void judgeQueries(const test::NoisySphere& sphere, std::size_t count, std::uint64_t seed, Table& table)
{
  test::Random random(seed);
  Panel panel(sphere.mesh(), table);
  const Question segment{ "segment", nearSurface(sphere, count, random) };
  panel.judgeAnswers(segment);
  panel.judgeHits(segment);
  panel.judgeDistances(segment.segments);
  const Question seam{ "seam", throughSeams(sphere, count, random), Arithmetic::Double, 1.0 };
  const Question vertex{ "vertex", ontoVertices(sphere, 0.0, count, random), Arithmetic::Double, 1.0 };
  // Far less than single precision tells apart at 50 mm (4e-6 mm), far more than double precision does.
  const Question above{ "above", ontoVertices(sphere, 1e-7, count, random), Arithmetic::Single,
    0.1 * static_cast<double>(count) };
  for (const Question& question : { seam, vertex, above })
  {
    panel.judgeAnswers(question);
    panel.judgeOracle(question);
  }
}

/// The sphere far from the origin, as a survey in national coordinates is: 500 km, where single precision tells 32 mm
/// apart, so that it can know nothing of segments of 2 mm, and double precision 6e-8 mm.
void judgeFarAway(const test::NoisySphere& sphere, std::size_t count, std::uint64_t seed, Table& table)
{
  const Vec3 far_W(5e8, -5e8, 0.0);
  test::Random random(seed);
  const TriangleMesh mesh = test::shifted(sphere.mesh(), far_W);
  Panel panel(mesh, table);
  panel.judgeAnswers({ "far", shifted(nearSurface(sphere, count, random), far_W), Arithmetic::Single,
    0.1 * static_cast<double>(count) });
}

} // namespace queries_experiment

void runQueries(const Conditions& conditions, Table& table)
{
  using namespace queries_experiment;
  const std::size_t count = conditions.pick<std::size_t>(2000, 5000, 50000);
  const std::vector<std::size_t> all = { 14400, 57600, 230400, 921600 };
  const std::vector<std::size_t> sizes(all.begin(), all.begin() + conditions.pick(2, 4, 4));
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const test::NoisySphere sphere(sizes[i], 1.0);
    judgeQueries(sphere, count, conditions.seed, table);
    conditions.progress(static_cast<double>(i + 1) / static_cast<double>(sizes.size()));
    if (i == 0)
    {
      judgeFarAway(sphere, count, conditions.seed, table);
    }
  }
}

} // namespace palpate::lab
