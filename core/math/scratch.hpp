// Memory that serves one purpose after the other, so that a step's peak is that of its largest part.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace pf {

class Scratch {
 public:
  /// Room for `count` of T, aligned to 64 bytes, not initialised. What was taken before is lost. Kept between calls: an
  /// eighth more than asked for, so that counts which vary a little allocate nothing.
  template <class T>
  T* take(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignment);
    const std::size_t bytes = count * sizeof(T);
    if (bytes > size_) {
      memory_.reset();
      size_ = bytes + bytes / 8;
      memory_.reset(static_cast<std::byte*>(::operator new (size_, std::align_val_t{alignment})));
    }
    return reinterpret_cast<T*>(memory_.get());
  }
  std::size_t bytes() const { return size_; }

 private:
  static constexpr std::size_t alignment = 64;
  struct Release {
    void operator()(std::byte* memory) const { ::operator delete (memory, std::align_val_t{alignment}); }
  };
  std::unique_ptr<std::byte, Release> memory_;
  std::size_t size_ = 0;
};

}  // namespace pf
