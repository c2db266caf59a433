#include "allocations.hpp"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {

std::int64_t count = 0;
std::size_t held = 0;

void* counted(void* taken) {
    if (!taken) throw std::bad_alloc();
    ++count;
    held += malloc_usable_size(taken);
    return taken;
}

void give_back(void* taken) noexcept {
    if (taken) held -= malloc_usable_size(taken);
    std::free(taken);
}

}  // namespace

namespace weavefront::benchmark {

std::int64_t allocations() { return count; }
std::size_t bytes_held() { return held; }

}  // namespace weavefront::benchmark

// The forms for arrays and those that do not throw call these. The benchmark has one thread.
void* operator new(std::size_t size) { return counted(std::malloc(size > 0 ? size : 1)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto grain = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(grain, (size / grain + 1) * grain));
}
void operator delete(void* taken) noexcept { give_back(taken); }
void operator delete(void* taken, std::size_t) noexcept { give_back(taken); }
void operator delete(void* taken, std::align_val_t) noexcept { give_back(taken); }
void operator delete(void* taken, std::size_t, std::align_val_t) noexcept { give_back(taken); }
