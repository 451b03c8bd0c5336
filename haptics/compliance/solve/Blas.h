// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

// Functions of the system's BLAS and LAPACK for dense blocks: column by column, `ld` numbers from one to the next.
// NOLINTBEGIN(readability-identifier-naming) the names of BLAS
extern "C"
{
  void dgemm_(const char* transA, const char* transB, const int* m, const int* n, const int* k, const double* alpha,
    const double* a, const int* lda, const double* b, const int* ldb, const double* beta, double* c, const int* ldc);
  void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* a, const int* lda,
    const double* x, const int* incx, const double* beta, double* y, const int* incy);
  void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha, const double* a,
    const int* lda, const double* beta, double* c, const int* ldc);
  void dtrsm_(const char* side, const char* uplo, const char* trans, const char* diag, const int* m, const int* n,
    const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
  void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a, const int* lda,
    double* x, const int* incx);
  void sgemv_(const char* trans, const int* m, const int* n, const float* alpha, const float* a, const int* lda,
    const float* x, const int* incx, const float* beta, float* y, const int* incy);
  void strsv_(const char* uplo, const char* trans, const char* diag, const int* n, const float* a, const int* lda,
    float* x, const int* incx);
  void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
}
// NOLINTEND(readability-identifier-naming)

namespace palpate::blas
{

/// Locked during each call: OpenBLAS without threads of its own, as Debian builds it since version 0.3.29, gives wrong
/// numbers where two threads of a program call it at a time. A soft body has one thread, which then never waits.
inline std::mutex oneCallAtATime;
using Turn = std::lock_guard<std::mutex>;

struct ConstBlock
{
  const double* values;
  int ld;
};

struct Block
{
  double* values;
  int ld;
};

enum class Transposed : char
{
  No = 'N',
  Yes = 'T',
};

/// C (m x n) <- scale A (m x k) B + keep C; `b`: k x n, or n x k where it is transposed.
inline void multiply(
  int m, int n, int k, double scale, ConstBlock a, ConstBlock b, Transposed ofB, double keep, Block c) noexcept
{
  const Turn turn(oneCallAtATime);
  const char no = 'N';
  const char trans = static_cast<char>(ofB);
  if (m > 1)
  {
    dgemm_(&no, &trans, &m, &n, &k, &scale, a.values, &a.ld, b.values, &b.ld, &keep, c.values, &c.ld);
    return;
  }
  // One row: transposed it is a matrix times a vector, for which every BLAS has a fast path.
  const char other = ofB == Transposed::Yes ? 'N' : 'T';
  const int rows = ofB == Transposed::Yes ? n : k;
  const int columns = ofB == Transposed::Yes ? k : n;
  dgemv_(&other, &rows, &columns, &scale, b.values, &b.ld, a.values, &a.ld, &keep, c.values, &c.ld);
}

/// X (m x n) <- X L^-1, or X L^-T; `l`: lower triangle of n columns.
inline void solveRight(int m, int n, ConstBlock l, Transposed ofL, Block x) noexcept
{
  const Turn turn(oneCallAtATime);
  const char right = 'R', lower = 'L', plain = 'N';
  const char trans = static_cast<char>(ofL);
  const double one = 1.0;
  if (m > 1)
  {
    dtrsm_(&right, &lower, &trans, &plain, &m, &n, &one, l.values, &l.ld, x.values, &x.ld);
    return;
  }
  const char other = ofL == Transposed::Yes ? 'N' : 'T';
  dtrsv_(&lower, &other, &plain, &n, l.values, &l.ld, x.values, &x.ld);
}

/// y <- A x, or A^T x; A: m x n, in single precision.
inline void multiplyVector(int m, int n, const float* a, int ld, Transposed ofA, const float* x, float* y) noexcept
{
  const Turn turn(oneCallAtATime);
  const char trans = static_cast<char>(ofA);
  const float one = 1.0F, none = 0.0F;
  const int next = 1;
  sgemv_(&trans, &m, &n, &one, a, &ld, x, &next, &none, y, &next);
}

/// x <- L^-1 x, or L^-T x; `l`: lower triangle of n columns, in single precision.
inline void solveVector(int n, const float* l, int ld, Transposed ofL, float* x) noexcept
{
  const Turn turn(oneCallAtATime);
  const char lower = 'L', plain = 'N';
  const char trans = static_cast<char>(ofL);
  const int next = 1;
  strsv_(&lower, &trans, &plain, &n, l, &ld, x, &next);
}

/// Lower triangle of C (n x n) <- A A^T; `a`: n x k.
inline void multiplyByItself(int n, int k, ConstBlock a, Block c) noexcept
{
  const Turn turn(oneCallAtATime);
  const char lower = 'L', no = 'N';
  const double one = 1.0, none = 0.0;
  dsyrk_(&lower, &no, &n, &k, &one, a.values, &a.ld, &none, c.values, &c.ld);
}

/// Lower triangle of A (n x n) <- L with L L^T = A; false if A is not positive definite.
[[nodiscard]] inline bool factorLower(int n, Block a) noexcept
{
  const Turn turn(oneCallAtATime);
  const char lower = 'L';
  int failed = 0;
  dpotrf_(&lower, &n, a.values, &a.ld, &failed);
  return failed == 0;
}

} // namespace palpate::blas
