// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/NoisySphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "testing/support/Icosahedron.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr double radius_mm = 50.0;
constexpr double amplitude_mm = 1.5;

/// Plane waves of 3 to 12 mm with equal slopes, limited smoothly to the amplitude.
class Bumps
{
public:
  Bumps()
  {
    Random random(2024);
    for (std::size_t i = 0; i < count; ++i)
    {
      const double wavelength_mm = 3.0 * std::pow(4.0, static_cast<double>(i) / (count - 1));
      this->waves_[i] = { random.direction() * (2 * std::numbers::pi / wavelength_mm),
        random.uniform(0.0, 2 * std::numbers::pi), 0.03 * wavelength_mm };
    }
  }

  [[nodiscard]] double height_mm(const Vec3& unitDirection) const
  {
    double sum = 0.0;
    for (const Wave& wave : this->waves_)
    {
      sum += wave.amplitude_mm * std::sin(radius_mm * wave.perMillimetre.dot(unitDirection) + wave.phase);
    }
    return amplitude_mm * std::tanh(sum / amplitude_mm);
  }

private:
  static constexpr std::size_t count = 16;
  struct Wave
  {
    Vec3 perMillimetre;
    double phase;
    double amplitude_mm;
  };
  std::array<Wave, count> waves_;
};

/// Direction of tick i: 0.1 mm a tick on the sphere; the circle's plane turns by 0.07 rad per radian.
Vec3 slideDirection(std::size_t tick)
{
  const double a = 0.1 / radius_mm * static_cast<double>(tick);
  const double b = 0.07 * a;
  const Vec3 tilted(std::cos(a), std::sin(a) * std::cos(0.6), std::sin(a) * std::sin(0.6));
  return { std::cos(b) * tilted.x() - std::sin(b) * tilted.y(), std::sin(b) * tilted.x() + std::cos(b) * tilted.y(),
    tilted.z() };
}

} // namespace

NoisySphere::NoisySphere(std::size_t triangles, double unitsPerMillimetre)
  : base_(icosahedron()),
    n_(std::max(1u, static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 20.0))))),
    unit_(unitsPerMillimetre)
{
  this->makeVertices();
  this->makeTriangles();
}

std::uint32_t NoisySphere::edgeVertex(std::uint32_t from, std::uint32_t to, std::uint32_t step) const
{
  // Each of the 12 x 12 ordered pairs would do as a number; only 30 are edges, counted in the order of (low, high).
  const std::uint32_t low = std::min(from, to), high = std::max(from, to);
  const double edge = (this->base_.vertices_W[0] - this->base_.vertices_W[11]).norm();
  std::uint32_t number = 0;
  for (std::uint32_t a = 0; a < 12; ++a)
  {
    for (std::uint32_t b = a + 1; b < 12; ++b)
    {
      if (a == low && b == high)
      {
        return 12 + number * (this->n_ - 1) + (from == low ? step : this->n_ - step) - 1;
      }
      number += (this->base_.vertices_W[a] - this->base_.vertices_W[b]).norm() < 1.01 * edge;
    }
  }
  throw std::logic_error("not an edge of the icosahedron");
}

std::uint32_t NoisySphere::vertexAt(std::uint32_t face, std::uint32_t i, std::uint32_t j) const
{
  const auto [a, b, c] = this->base_.triangles[face];
  const std::uint32_t n = this->n_, k = n - i - j;
  if (i == n || j == n || k == n)
  {
    return k == n ? a : (i == n ? b : c);
  }
  if (i == 0 || j == 0 || k == 0)
  {
    return j == 0 ? this->edgeVertex(a, b, i) : (i == 0 ? this->edgeVertex(a, c, j) : this->edgeVertex(b, c, j));
  }
  const std::uint32_t inner = (n - 1) * (n - 2) / 2;
  // Row j holds n - 1 - j inner points; the rows before it together (j - 1)(n - 1) - (j - 1) j / 2.
  return 12 + 30 * (n - 1) + face * inner + (j - 1) * (n - 1) - (j - 1) * j / 2 + i - 1;
}

void NoisySphere::makeVertices()
{
  const std::uint32_t n = this->n_;
  this->mesh_.vertices_W.resize(10 * std::size_t{ n } * n + 2);
  const Bumps bumps;
  for (std::uint32_t face = 0; face < 20; ++face)
  {
    const auto [a, b, c] = this->base_.triangles[face];
    const Vec3 &va = this->base_.vertices_W[a], &vb = this->base_.vertices_W[b], &vc = this->base_.vertices_W[c];
    for (std::uint32_t j = 0; j <= n; ++j)
    {
      for (std::uint32_t i = 0; i + j <= n; ++i)
      {
        const Vec3 direction = (double(n - i - j) * va + double(i) * vb + double(j) * vc).normalized();
        this->mesh_.vertices_W[this->vertexAt(face, i, j)] =
          this->unit_ * (radius_mm + bumps.height_mm(direction)) * direction;
      }
    }
  }
}

void NoisySphere::makeTriangles()
{
  this->mesh_.triangles.reserve(20 * std::size_t{ this->n_ } * this->n_);
  for (std::uint32_t face = 0; face < 20; ++face)
  {
    for (std::uint32_t j = 0; j < this->n_; ++j)
    {
      for (std::uint32_t i = 0; i + j < this->n_; ++i)
      {
        const std::uint32_t right = this->vertexAt(face, i + 1, j), up = this->vertexAt(face, i, j + 1);
        this->mesh_.triangles.push_back({ this->vertexAt(face, i, j), right, up });
        if (i + j + 2 <= this->n_)
        {
          this->mesh_.triangles.push_back({ right, this->vertexAt(face, i + 1, j + 1), up });
        }
      }
    }
  }
}

double NoisySphere::surfaceRadius_u(const Vec3& direction) const
{
  // Seen from the origin the triangles are those of the flat icosahedron: barycentric coordinates find the cell.
  std::uint32_t face = 0;
  Vec3 weights = Vec3::Zero();
  double best = -1e300;
  for (std::uint32_t f = 0; f < 20; ++f)
  {
    const auto [a, b, c] = this->base_.triangles[f];
    Mat3 corners;
    corners << this->base_.vertices_W[a], this->base_.vertices_W[b], this->base_.vertices_W[c];
    const Vec3 w = corners.inverse() * direction;
    if (w.minCoeff() / w.cwiseAbs().sum() > best)
    {
      best = w.minCoeff() / w.cwiseAbs().sum();
      face = f;
      weights = w / w.sum();
    }
  }
  const double x = std::clamp(weights[1], 0.0, 1.0) * this->n_, y = std::clamp(weights[2], 0.0, 1.0) * this->n_;
  const std::uint32_t i = std::min(static_cast<std::uint32_t>(x), this->n_ - 1);
  const std::uint32_t j = std::min(static_cast<std::uint32_t>(y), this->n_ - 1 - i);
  const bool upper = (x - i) + (y - j) > 1.0 && i + j + 2 <= this->n_;
  const Vec3& a = this->mesh_.vertices_W[this->vertexAt(face, i + upper, j + upper)];
  const Vec3& b = this->mesh_.vertices_W[this->vertexAt(face, i + 1, j)];
  const Vec3& c = this->mesh_.vertices_W[this->vertexAt(face, i, j + 1)];
  const Vec3 normal = (b - a).cross(c - a);
  return direction.norm() * normal.dot(a) / normal.dot(direction);
}

SlidePoint slideOver(const NoisySphere& sphere, std::size_t tick)
{
  const Vec3 direction = slideDirection(tick).normalized();
  const double depth_u = (1.5 + 0.5 * std::sin(0.01 * static_cast<double>(tick))) * sphere.unitsPerMillimetre();
  return { (sphere.surfaceRadius_u(direction) - depth_u) * direction, depth_u };
}

Vec3 slideStart_W(const NoisySphere& sphere)
{
  return (radius_mm + 5.0) * sphere.unitsPerMillimetre() * slideDirection(0);
}

} // namespace palpate::test
