#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include <fairlight/render/parallel.h>

namespace fairlight {

void for_each_unit(int units, int threads, const std::function<void(int)>& work) {
  if (threads < 1) throw std::invalid_argument("the number of threads must be at least 1");
  std::atomic<int> next = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  std::exception_ptr failure;
  int failed_unit = units;
  const auto serve = [&] {
    while (!failed) {
      const int unit = next++;
      if (unit >= units) return;
      try {
        work(unit);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failed = true;
        if (unit < failed_unit) {
          failed_unit = unit;
          failure = std::current_exception();
        }
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < std::min(threads, units); ++i) others.emplace_back(serve);
    serve();
  }
  if (failure) std::rethrow_exception(failure);
}

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace fairlight
