// Memory that a thread keeps for the next owner of the same type.
#pragma once

#include <memory>
#include <utility>

namespace taut::internal {

/// take() returns the T that the last owner in this thread gave back, in the state in which it was left, or a new one.
/// Allocating and freeing memory for each query would cost more than a small query does. One object of each type is
/// kept until the thread ends; owners that are static objects may end later.
template <class T>
class ThreadLocalPool {
 public:
  struct GiveBack {
    void operator()(T* it) const { give(it); }
  };
  using Pointer = std::unique_ptr<T, GiveBack>;

  static Pointer take() {
    T* const kept = over_ ? nullptr : std::exchange(own().kept_, nullptr);
    return Pointer(kept ? kept : new T);  // new T leaves members without a constructor untouched, unlike new T()
  }

  ThreadLocalPool(const ThreadLocalPool&) = delete;
  ThreadLocalPool& operator=(const ThreadLocalPool&) = delete;
  ~ThreadLocalPool() {
    delete kept_;
    over_ = true;
  }

 private:
  ThreadLocalPool() = default;

  static void give(T* it) {
    if (over_ || own().kept_) {
      delete it;
    } else {
      own().kept_ = it;
    }
  }
  static ThreadLocalPool& own() {
    static thread_local ThreadLocalPool spare;
    return spare;
  }

  static inline thread_local bool over_ = false;
  T* kept_ = nullptr;
};

}  // namespace taut::internal
