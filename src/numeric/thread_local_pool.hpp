// Memory that a thread keeps for the next owner of the same type.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace taut::internal {

/// take() returns the T that the last owner in this thread gave back, in the state in which it was left, or a new one.
/// Allocating and freeing memory for each query would cost more than a small query does. A few objects of each type,
/// as the pairs of a small world have at once, are kept until the thread ends; owners that are static objects may end
/// later.
template <class T>
class ThreadLocalPool {
 public:
  struct GiveBack {
    void operator()(T* it) const { give(it); }
  };
  using Pointer = std::unique_ptr<T, GiveBack>;

  static Pointer take() {
    if (over_ || own().count_ == 0)
      return Pointer(new T);  // unlike new T(), leaves members without a constructor alone
    ThreadLocalPool& pool = own();
    return Pointer(pool.kept_[--pool.count_]);
  }

  ThreadLocalPool(const ThreadLocalPool&) = delete;
  ThreadLocalPool& operator=(const ThreadLocalPool&) = delete;
  ~ThreadLocalPool() {
    while (count_ > 0) delete kept_[--count_];
    over_ = true;
  }

 private:
  ThreadLocalPool() = default;

  static void give(T* it) {
    if (over_ || own().count_ == most_kept) {
      delete it;
    } else {
      ThreadLocalPool& pool = own();
      pool.kept_[pool.count_++] = it;
    }
  }
  static ThreadLocalPool& own() {
    static thread_local ThreadLocalPool spare;
    return spare;
  }

  static constexpr std::size_t most_kept = 8;
  static inline thread_local bool over_ = false;
  std::array<T*, most_kept> kept_{};
  std::size_t count_ = 0;
};

}  // namespace taut::internal
