// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/solve/SparseFactor.h"

#include <mutex>
#include <new>

#include <cholmod.h>

#include "haptics/compliance/solve/EliminationPath.h"

namespace palpate
{
namespace
{

/// CHOLMOD's view of a matrix of ours, which it only reads.
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
    ints(factor.px), ints(factor.s), static_cast<const double*>(factor.x), ints(factor.Perm) };
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
    this->common.try_catch = 1; // It says nothing on the terminal: what failed is asked.
  }
  Hidden(const Hidden&) = delete;
  Hidden& operator=(const Hidden&) = delete;
  ~Hidden()
  {
    cholmod_free_factor(&this->factor, &this->common);
    cholmod_finish(&this->common);
  }

  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  bool ready = false;
};

SparseFactor::SparseFactor(const SparseLower& pattern) : hidden_(std::make_unique<Hidden>())
{
  // METIS draws from the one sequence of rand(), which it begins anew: two at a time would find other orders each time.
  static std::mutex oneAtATime;
  const std::lock_guard<std::mutex> lock(oneAtATime);
  cholmod_sparse view = viewOf(pattern);
  this->hidden_->factor = cholmod_analyze(&view, &this->hidden_->common);
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

std::size_t SparseFactor::bytes() const
{
  return this->hidden_->factor ? this->hidden_->factor->xsize * sizeof(double) : 0;
}

bool SparseFactor::factor(const SparseLower& matrix)
{
  Hidden& h = *this->hidden_;
  cholmod_sparse view = viewOf(matrix);
  h.ready = h.factor && cholmod_factorize(&view, h.factor, &h.common) && h.common.status == CHOLMOD_OK &&
            h.factor->minor == h.factor->n && h.factor->is_super;
  return h.ready;
}

bool SparseFactor::ready() const
{
  return this->hidden_->ready;
}

Eigen::VectorXd SparseFactor::solve(const Eigen::VectorXd& b) const
{
  Hidden& h = *this->hidden_;
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = static_cast<std::size_t>(b.size());
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, h.factor, &right, &h.common);
  if (!x)
  {
    throw std::bad_alloc();
  }
  const Eigen::VectorXd result = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(x->x), b.size());
  cholmod_free_dense(&x, &h.common);
  return result;
}

Eigen::MatrixXd SparseFactor::sharedCompliance(const SparseColumns& e) const
{
  return complianceOnPath(supernodesOf(*this->hidden_->factor), e);
}

} // namespace palpate
