// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/solve/SparseFactor.h"

#include <mutex>

#include <cholmod.h>

#include "haptics/compliance/solve/Blas.h"
#include "haptics/compliance/solve/EliminationPath.h"
#include "haptics/compliance/solve/SingleFactor.h"

namespace palpate
{
namespace
{

/// CHOLMOD's view of a matrix, which it only reads.
cholmod_sparse viewOf(const SparseLower& matrix)
{
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.order());
  view.nzmax = matrix.rows.size();
  view.p = const_cast<int*>(matrix.start.data());
  view.i = const_cast<int*>(matrix.rows.data());
  view.x = const_cast<double*>(matrix.values.data());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

SupernodalView supernodesOf(const cholmod_factor& factor)
{
  const auto ints = [](const void* p) { return static_cast<const int*>(p); };
  return { static_cast<int>(factor.n), static_cast<int>(factor.nsuper), ints(factor.super), ints(factor.pi),
    ints(factor.px), ints(factor.s), ints(factor.Perm) };
}

} // namespace

struct SparseFactor::Hidden
{
  Hidden()
  {
    cholmod_start(&this->common);
    this->common.supernodal = CHOLMOD_SUPERNODAL;
    this->common.nmethods = 1;
    this->common.method[0].ordering = CHOLMOD_METIS;
    this->common.print = 0;
    this->common.try_catch = 1; // no messages on the terminal: failures are queried
  }
  Hidden(const Hidden&) = delete;
  Hidden& operator=(const Hidden&) = delete;
  ~Hidden()
  {
    cholmod_free_factor(&this->factor, &this->common);
    cholmod_finish(&this->common);
  }

  cholmod_common common{};
  cholmod_factor* factor = nullptr; ///< its pattern only
  SupernodalView pattern;
  std::vector<int> slots; ///< for each number of the matrix
  std::vector<double> values;
  SingleFactor single;
  bool ready = false;
};

SparseFactor::SparseFactor(const SparseLower& pattern) : hidden_(std::make_unique<Hidden>())
{
  // METIS draws from the global sequence of rand(), which it restarts: two at a time would find other orders each time.
  static std::mutex oneAtATime;
  const std::lock_guard<std::mutex> lock(oneAtATime);
  Hidden& h = *this->hidden_;
  cholmod_sparse view = viewOf(pattern);
  h.factor = cholmod_analyze(&view, &h.common);
  if (h.factor && h.factor->is_super)
  {
    h.pattern = supernodesOf(*h.factor);
    h.slots = slotsOf(h.pattern, pattern);
  }
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

std::size_t SparseFactor::bytes() const
{
  return this->hidden_->factor ? this->hidden_->factor->xsize * sizeof(double) : 0;
}

/// Own factorisation: that of CHOLMOD starts threads that wait by spinning, beside the servo.
bool SparseFactor::factor(const SparseLower& matrix)
{
  Hidden& h = *this->hidden_;
  h.ready = false;
  h.single = {};
  if (h.slots.size() != matrix.values.size())
  {
    return false;
  }
  h.values.assign(h.factor->xsize, 0.0);
  for (std::size_t i = 0; i < h.slots.size(); ++i)
  {
    h.values[static_cast<std::size_t>(h.slots[i])] += matrix.values[i];
  }
  h.ready = factorSupernodes(h.pattern, h.values.data());
  return h.ready;
}

bool SparseFactor::ready() const
{
  return this->hidden_->ready;
}

void SparseFactor::keepSingle()
{
  Hidden& h = *this->hidden_;
  if (h.ready && !h.single.ready())
  {
    h.single = SingleFactor(h.pattern, h.values);
  }
}

const SingleFactor& SparseFactor::single() const
{
  return this->hidden_->single;
}

Eigen::VectorXd SparseFactor::solve(const Eigen::VectorXd& b) const
{
  const Hidden& h = *this->hidden_;
  Eigen::MatrixXd y(1, b.size());
  for (Eigen::Index k = 0; k < b.size(); ++k)
  {
    y(0, k) = b[h.pattern.matrixRow[k]];
  }
  const EliminationPath whole(h.pattern, h.values.data());
  whole.forward(y);
  whole.backward(y);
  Eigen::VectorXd x(b.size());
  for (Eigen::Index k = 0; k < b.size(); ++k)
  {
    x[h.pattern.matrixRow[k]] = y(0, k);
  }
  return x;
}

Eigen::MatrixXd SparseFactor::sharedCompliance(const SparseColumns& e) const
{
  const Hidden& h = *this->hidden_;
  const EliminationPath path(h.pattern, h.values.data(), e.rows);
  Eigen::MatrixXd y = path.rightSides(e);
  path.forward(y);
  const int count = static_cast<int>(y.rows());
  Eigen::MatrixXd half(count, count);
  blas::multiplyByItself(count, static_cast<int>(y.cols()), { y.data(), count }, { half.data(), count });
  return half.selfadjointView<Eigen::Lower>();
}

Eigen::VectorXd SparseFactor::ownCompliance(const SparseColumns& e) const
{
  const Hidden& h = *this->hidden_;
  const EliminationPath path(h.pattern, h.values.data(), e.rows);
  Eigen::MatrixXd y = path.rightSides(e);
  path.forward(y);
  return y.rowwise().squaredNorm();
}

Eigen::MatrixXd SparseFactor::sharedCompliance(const SparseColumns& e, const SparseColumns& n) const
{
  const Hidden& h = *this->hidden_;
  const EliminationPath path(h.pattern, h.values.data(), e.rows);
  Eigen::MatrixXd y = path.rightSides(n);
  path.forward(y);
  path.backward(y);
  return path.readOff(e, y);
}

} // namespace palpate
