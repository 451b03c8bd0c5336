// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/AllocationGuard.h"

#include <cerrno>
#include <cstddef>

#include <dlfcn.h>
#include <pthread.h>

namespace
{

struct Counters
{
  bool counting;
  std::uint64_t allocations, frees, locks;
};

thread_local constinit Counters counters{};

void count(std::uint64_t Counters::*what) noexcept
{
  if (counters.counting)
  {
    ++(counters.*what);
  }
}

} // namespace

#ifndef PALPATE_SANITIZED // given by the build
// glibc's own entry points stay reachable under these names, so that the replacements need no look-up for memory.
extern "C"
{
  void* __libc_malloc(std::size_t);
  void* __libc_calloc(std::size_t, std::size_t);
  void* __libc_realloc(void*, std::size_t);
  void* __libc_memalign(std::size_t, std::size_t);
  void __libc_free(void*);

  void* malloc(std::size_t size)
  {
    count(&Counters::allocations);
    return __libc_malloc(size);
  }
  void* calloc(std::size_t n, std::size_t size)
  {
    count(&Counters::allocations);
    return __libc_calloc(n, size);
  }
  void* realloc(void* old, std::size_t size)
  {
    count(&Counters::allocations);
    return __libc_realloc(old, size);
  }
  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    count(&Counters::allocations);
    return __libc_memalign(alignment, size);
  }
  int posix_memalign(void** memory, std::size_t alignment, std::size_t size)
  {
    count(&Counters::allocations);
    *memory = __libc_memalign(alignment, size);
    return *memory != nullptr ? 0 : ENOMEM;
  }
  void free(void* memory)
  {
    if (memory != nullptr)
    {
      count(&Counters::frees);
    }
    __libc_free(memory);
  }
}

namespace
{

template<class Function>
Function* original(const char* name) noexcept
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

#define PALPATE_COUNT_LOCK(name, type)                                                                                 \
  extern "C" int name(type* lock)                                                                                      \
  {                                                                                                                    \
    static auto* const next = original<int(type*)>(#name);                                                             \
    count(&Counters::locks);                                                                                           \
    return next(lock);                                                                                                 \
  }
PALPATE_COUNT_LOCK(pthread_mutex_lock, pthread_mutex_t)
PALPATE_COUNT_LOCK(pthread_mutex_trylock, pthread_mutex_t)
PALPATE_COUNT_LOCK(pthread_rwlock_rdlock, pthread_rwlock_t)
PALPATE_COUNT_LOCK(pthread_rwlock_wrlock, pthread_rwlock_t)
PALPATE_COUNT_LOCK(pthread_spin_lock, pthread_spinlock_t)
#undef PALPATE_COUNT_LOCK
#endif

namespace palpate::test
{

AllocationGuard::AllocationGuard() noexcept
{
  counters = { true, 0, 0, 0 };
}

AllocationGuard::~AllocationGuard()
{
  counters.counting = false;
}

std::uint64_t AllocationGuard::allocations() const noexcept
{
  return counters.allocations;
}

std::uint64_t AllocationGuard::frees() const noexcept
{
  return counters.frees;
}

std::uint64_t AllocationGuard::locks() const noexcept
{
  return counters.locks;
}

bool AllocationGuard::works() noexcept
{
#ifdef PALPATE_SANITIZED
  return false;
#else
  return true;
#endif
}

} // namespace palpate::test
