// huge_pages.h: memory for what rays read here and there, in pages as large as the system has them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace litmus {

/// Allocates for std::vector. A ray reads a few lines of some hundred megabytes: with small pages
/// it waits for the address of each as long as for the line.
template <class T>
struct HugePages {
  using value_type = T;
  static constexpr std::size_t kPage = std::size_t(2) << 20;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}

  /// Small things stay off pages of their own.
  static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t(bytes < kPage ? std::max(alignof(T), std::size_t(64)) : kPage);
  }
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* const memory = ::operator new(bytes, alignment(bytes));
#ifdef MADV_HUGEPAGE
    if (bytes >= kPage) madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: nothing to do if refused
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    ::operator delete(memory, alignment(count * sizeof(T)));
  }
  friend bool operator==(const HugePages&, const HugePages&) { return true; }
};

template <class T>
using HugeVector = std::vector<T, HugePages<T>>;

}  // namespace litmus
