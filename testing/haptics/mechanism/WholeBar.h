// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "testing/haptics/mechanism/HeldMesh.h"

namespace palpate::test
{

inline const Vec3 barSize(0.1, 0.04, 0.02);
inline constexpr double barYoung_Pa = 200e3, barPoisson = 0.3, gap_m = 0.002;

/// The block that stands below its free end, so far from it.
inline TriangleMesh blockBelowBar()
{
  return makeBox(Vec3(0.05, -0.02, -0.03), Vec3(0.15, 0.06, -gap_m));
}

/// A bar along x that is held at x = 0, of four-node tetrahedra.
inline SoftBodyInput bar(const std::array<int, 3>& cells)
{
  SoftBodyInput input;
  input.mesh = blockOf(cells, barSize);
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa = { barYoung_Pa };
  input.poisson = barPoisson;
  input.element = ElementKind::Linear;
  input.model = ElasticModel::Linear;
  return input;
}

/// Of four-node tetrahedra (Zienkiewicz & Taylor), with contacts of all its lower vertices at once: an active set, a
/// vertex more or less at a time, until none reaches through and none draws.
class WholeBar
{
public:
  static bool isLower(const Vec3& p) { return p.z() == 0.0 && p.x() >= 0.05; }

  /// `meets`: which of the vertices have contacts.
  explicit WholeBar(const SoftBodyInput& input, const std::function<bool(const Vec3&)>& meets = isLower)
    : vertices_(input.mesh.vertices_W), row_(vertices_.size(), -1)
  {
    int rows = 0;
    for (std::size_t v = 0; v < this->vertices_.size(); ++v)
    {
      this->row_[v] = input.fixed[v] ? -1 : 3 * rows++;
      if (this->row_[v] >= 0 && meets(this->vertices_[v]))
      {
        this->lower_.push_back(v);
      }
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const Tetra& t : input.mesh.tetras)
    {
      this->addTetra(t, hookeOf(input), entries);
    }
    this->stiffness_.resize(3 * rows, 3 * rows);
    this->stiffness_.setFromTriplets(entries.begin(), entries.end());
    this->factor_.compute(this->stiffness_);
    this->columns_ = Eigen::MatrixXd::Zero(3 * rows, static_cast<Eigen::Index>(this->lower_.size()));
    for (std::size_t k = 0; k < this->lower_.size(); ++k)
    {
      this->columns_(this->row_[this->lower_[k]] + 2, static_cast<Eigen::Index>(k)) = 1.0;
    }
    this->columns_ = this->factor_.solve(this->columns_).eval();
  }

  /// Under these forces at these places of its surface, whose vertices are numbered by the surface.
  void press(std::span<const MechanismPress> presses, const std::vector<Vec3>& surface_W)
  {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(this->stiffness_.rows());
    for (const MechanismPress& press : presses)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const int row = this->row_[this->nearest(surface_W[press.at.vertices[c]])];
        if (row >= 0)
        {
          load.segment<3>(row) += press.at.weights[static_cast<Eigen::Index>(c)] * press.force_N;
        }
      }
    }
    this->free_ = this->factor_.solve(load);
  }
  /// Under a force on each of its vertices.
  void load(const std::vector<Vec3>& of_N)
  {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(this->stiffness_.rows());
    for (std::size_t v = 0; v < of_N.size(); ++v)
    {
      if (this->row_[v] >= 0)
      {
        load.segment<3>(this->row_[v]) = of_N[v];
      }
    }
    this->free_ = this->factor_.solve(load);
  }
  /// How the contacts go along z under forces on one another [m/N].
  [[nodiscard]] Eigen::MatrixXd compliance() const
  {
    const auto count = static_cast<Eigen::Index>(this->lower_.size());
    Eigen::MatrixXd compliance(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      compliance.row(i) = this->columns_.row(this->row_[this->lower_[static_cast<std::size_t>(i)]] + 2);
    }
    return compliance;
  }
  /// The bar lies on another body, which has the same contacts, and yields to their forces.
  void standOn(const WholeBar& other) { this->below_ = other.compliance(); }
  /// The least gap to the block if that were not there [m].
  [[nodiscard]] double leastGap_m() const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t v : this->lower_)
    {
      least = std::min(least, gap_m + this->free_[this->row_[v] + 2]);
    }
    return least;
  }
  /// Force of the block on the bar, upwards, so far apart at first [N].
  [[nodiscard]] double borne_N(double apart_m = gap_m) const
  {
    const auto count = static_cast<Eigen::Index>(this->lower_.size());
    Eigen::MatrixXd compliance = this->compliance();
    if (this->below_.size() > 0)
    {
      compliance += this->below_;
    }
    Eigen::VectorXd gap(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      gap[i] = apart_m + this->free_[this->row_[this->lower_[static_cast<std::size_t>(i)]] + 2];
    }
    std::vector<Eigen::Index> active;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(count);
    for (int left = 1000; left > 0; --left)
    {
      Eigen::Index worst = 0;
      force.setZero();
      if (!active.empty())
      {
        force(active) = compliance(active, active).ldlt().solve(-Eigen::VectorXd(gap(active))).eval();
      }
      if (force.minCoeff(&worst) < -1e-12)
      {
        std::erase(active, worst);
        continue;
      }
      if (Eigen::VectorXd(gap + compliance * force).minCoeff(&worst) > -1e-12)
      {
        return force.sum();
      }
      active.push_back(worst);
    }
    ADD_FAILURE() << "no set of contacts";
    return 0.0;
  }

private:
  [[nodiscard]] std::size_t nearest(const Vec3& p) const
  {
    const auto away = [&p](const Vec3& v) { return (v - p).squaredNorm(); };
    return static_cast<std::size_t>(std::ranges::min_element(this->vertices_, {}, away) - this->vertices_.begin());
  }

  static Eigen::Matrix<double, 6, 6> hookeOf(const SoftBodyInput& input)
  {
    const double young_Pa = input.young_Pa.front(), nu = input.poisson;
    const double lame = young_Pa * nu / ((1 + nu) * (1 - 2 * nu)), shear = young_Pa / (2 * (1 + nu));
    Eigen::Matrix<double, 6, 6> hooke = Eigen::Matrix<double, 6, 6>::Zero();
    hooke.topLeftCorner<3, 3>().setConstant(lame);
    hooke.diagonal() += (Eigen::Matrix<double, 6, 1>() << 2, 2, 2, 1, 1, 1).finished() * shear;
    return hooke;
  }

  void addTetra(
    const Tetra& t, const Eigen::Matrix<double, 6, 6>& hooke, std::vector<Eigen::Triplet<double>>& entries) const
  {
    Eigen::Matrix4d places;
    for (int c = 0; c < 4; ++c)
    {
      places.row(c) << 1.0, this->vertices_[t[static_cast<std::size_t>(c)]].transpose();
    }
    const Eigen::Matrix4d shape = places.inverse(); // rows 1 to 3: gradients of the four functions
    const double volume = std::abs(places.determinant()) / 6.0;
    Eigen::Matrix<double, 6, 12> strain = Eigen::Matrix<double, 6, 12>::Zero();
    for (int c = 0; c < 4; ++c)
    {
      const double x = shape(1, c), y = shape(2, c), z = shape(3, c);
      strain.middleCols<3>(3 * c) << x, 0, 0, 0, y, 0, 0, 0, z, y, x, 0, 0, z, y, z, 0, x;
    }
    const Eigen::Matrix<double, 12, 12> k = volume * strain.transpose() * hooke * strain;
    for (int i = 0; i < 12; ++i)
    {
      for (int j = 0; j < 12; ++j)
      {
        const int row = this->row_[t[static_cast<std::size_t>(i / 3)]],
                  column = this->row_[t[static_cast<std::size_t>(j / 3)]];
        if (row >= 0 && column >= 0)
        {
          entries.emplace_back(row + i % 3, column + j % 3, k(i, j));
        }
      }
    }
  }

  std::vector<Vec3> vertices_;
  std::vector<int> row_; ///< of each vertex; -1: it is fixed
  std::vector<std::size_t> lower_;
  Eigen::SparseMatrix<double> stiffness_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::MatrixXd columns_; ///< displacements under a force of 1 N on each lower vertex
  Eigen::MatrixXd below_;   ///< of a body on which the bar lies; empty: that is rigid
  Eigen::VectorXd free_;
};

inline std::vector<MechanismPress> pressesFrom(const MechanismResult& r, int body)
{
  std::vector<MechanismPress> from;
  std::copy_if(r.presses.begin(), r.presses.begin() + r.pressCount, std::back_inserter(from),
    [body](const MechanismPress& press) { return press.from == body; });
  return from;
}

inline double upwards_N(const std::vector<MechanismPress>& presses)
{
  double sum_N = 0.0;
  for (const MechanismPress& press : presses)
  {
    sum_N += press.force_N.z();
  }
  return sum_N;
}

} // namespace palpate::test
